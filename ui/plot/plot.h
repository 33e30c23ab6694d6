// The one painted plot: what to show, as values. Panels and pictures fill it in; nothing here knows of
// studies.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

namespace thetalane {

enum class Marker { None, Circle, Square, Triangle, Diamond, Cross, Star };

struct PlotPoint {
    double x = 0;
    double y = 0;
    QString label;   // beside the point, where there is room; may be empty
    QString hover{}; // under the mouse; else the name of the series and the label
    // From the lower to the upper quartile, where they are known.
    std::optional<std::pair<double, double>> spreadX{};
};

struct PlotSeries {
    QString name; // in the legend
    QColor colour;
    Qt::PenStyle line = Qt::SolidLine; // Qt::NoPen: markers alone
    Marker marker = Marker::Circle;
    std::vector<PlotPoint> points;
};

struct PlotAxis {
    QString title; // with its unit
    bool logarithmic = false;
    std::optional<double> low{}; // else from the points, with room around
    std::optional<double> high{};
};

struct PlotLine { // across the plot, such as a tolerance
    double at = 0;
    bool horizontal = true;
    QString label;
};

// On a logarithmic axis what is not positive stands at the edge, with an arrow, as "0 or less".
struct Plot {
    QString title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
    std::vector<PlotLine> lines;
};

} // namespace thetalane

// Paints a Plot with any QPainter, on a screen or off it.
#pragma once

#include "ui/plot/plot.h"

#include <QFont>
#include <QLocale>
#include <QRectF>

#include <optional>

class QPainter;

namespace thetalane {

struct PlotStyle {
    QFont font; // of ticks, legend and titles; its pixel size is the smallest type
    QColor text{0x22, 0x22, 0x22};
    QColor quiet{0x66, 0x66, 0x66}; // ticks
    QColor grid{0xdd, 0xdd, 0xdd};
    QColor paper{Qt::white};
    double lineWidth = 2;
    QLocale locale; // of the ticks' digits
};

// Where a point is, for hovering.
struct PlotHit {
    std::size_t series = 0;
    std::size_t point = 0;
    QPointF at; // in the painter's pixels
};

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style,
               const std::optional<PlotHit>& lit = {});

// The point nearest to `where`, if one is within `reach` pixels, of a plot painted into that area.
std::optional<PlotHit> plotPointAt(const QPointF& where, double reach, const QRectF& area, const Plot& plot,
                                   const PlotStyle& style);

} // namespace thetalane

// Where things are in a plot: the frame, its scales and ticks, and the legend.
#pragma once

#include "ui/plot/paint_plot.h"

#include <QFontMetricsF>
#include <QRectF>

#include <vector>

namespace thetalane {

struct PlotTick {
    double value = 0;
    QString label; // empty for a minor one
};

// One axis: from values to the part of its length, 0 to 1.
class PlotScale {
public:
    PlotScale(const PlotAxis& axis, std::vector<double> values, const QLocale& locale);

    // Clamped a little beyond the ends; what a logarithm cannot show lies at 0.
    double part(double value) const;
    bool shows(double value) const { return !m_logarithmic || value > 0; }
    const std::vector<PlotTick>& ticks() const { return m_ticks; }

private:
    void decades(const QLocale& locale);
    void evenTicks(const QLocale& locale);

    bool m_logarithmic;
    double m_low = 0; // of a logarithmic one: its exponent
    double m_high = 1;
    std::vector<PlotTick> m_ticks;
};

class PlotLayout {
public:
    PlotLayout(const QRectF& area, const Plot& plot, const PlotStyle& style);

    struct LegendEntry {
        std::size_t series = 0;
        QPointF at; // left end of its line
    };

    QRectF frame;
    QRectF title, xTitle, yTitle; // yTitle as it lies after turning by a quarter
    PlotScale x, y;
    std::vector<LegendEntry> legend;
    double sampleWidth = 0; // of a line in the legend

    QPointF at(const PlotPoint& point) const { return {xOf(point.x), yOf(point.y)}; }
    double xOf(double value) const { return frame.left() + x.part(value) * frame.width(); }
    double yOf(double value) const { return frame.bottom() - y.part(value) * frame.height(); }

private:
    double layLegend(const QRectF& area, const Plot& plot, const QFontMetricsF& metrics);
};

} // namespace thetalane

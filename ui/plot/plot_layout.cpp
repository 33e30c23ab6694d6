#include "ui/plot/plot_layout.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

QString powerOfTen(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("10");
    if (exponent < 0)
        text += QChar(0x207B);
    for (const QChar c : QString::number(std::abs(exponent)))
        text += digits[c.digitValue()];
    return text;
}

QString decadeText(int exponent, const QLocale& locale) {
    if (exponent < -3 || exponent > 4)
        return powerOfTen(exponent);
    return locale.toString(std::pow(10, exponent), 'f', std::max(0, -exponent));
}

QString plainText(double value, double step, const QLocale& locale) {
    const int decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-9)));
    return locale.toString(value, 'f', decimals).replace('-', QChar(0x2212));
}

std::vector<double> valuesOf(const Plot& plot, bool x) {
    std::vector<double> values;
    for (const PlotSeries& s : plot.series)
        for (const PlotPoint& p : s.points)
            values.push_back(x ? p.x : p.y);
    for (const PlotLine& line : plot.lines)
        if (line.horizontal != x)
            values.push_back(line.at);
    return values;
}

double widest(const PlotScale& scale, const QFontMetricsF& metrics) {
    double width = 0;
    for (const PlotTick& t : scale.ticks())
        width = std::max(width, metrics.horizontalAdvance(t.label));
    return width;
}

} // namespace

PlotScale::PlotScale(const PlotAxis& axis, std::vector<double> values, const QLocale& locale)
    : m_logarithmic(axis.logarithmic) {
    std::erase_if(values, [this](double v) { return !std::isfinite(v) || !shows(v); });
    if (axis.low)
        values.push_back(*axis.low);
    if (axis.high)
        values.push_back(*axis.high);
    if (values.empty())
        values = {m_logarithmic ? 0.1 : 0.0, 1.0};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    m_low = m_logarithmic ? std::log10(*least) : *least;
    m_high = m_logarithmic ? std::log10(*most) : *most;
    if (m_logarithmic) {
        m_low = axis.low ? m_low : std::floor(m_low - 0.15);
        m_high = axis.high ? m_high : std::ceil(m_high + 0.15);
        if (!(m_high > m_low))
            m_high = m_low + 1;
        decades(locale);
        return;
    }
    const double room = m_high > m_low ? 0.05 * (m_high - m_low) : std::max(0.5, std::abs(m_high) * 0.1);
    m_low -= axis.low ? 0 : room;
    m_high += axis.high ? 0 : room;
    if (!(m_high > m_low))
        m_high = m_low + 1;
    evenTicks(locale);
}

double PlotScale::part(double value) const {
    if (!shows(value))
        return 0;
    const double v = m_logarithmic ? std::log10(value) : value;
    return std::clamp((v - m_low) / (m_high - m_low), -0.02, 1.02);
}

void PlotScale::decades(const QLocale& locale) {
    const int first = int(std::ceil(m_low - 1e-9)), last = int(std::floor(m_high + 1e-9));
    const int every = std::max(1, (last - first + 8) / 9);
    for (int e = first - 1; e <= last; ++e) {
        if (e >= first)
            m_ticks.push_back(
                {std::pow(10, e), (e - first) % every == 0 ? decadeText(e, locale) : QString()});
        for (int k = 2; k < 10 && every == 1 && last - first <= 6; ++k)
            if (const double v = k * std::pow(10, e); std::log10(v) > m_low && std::log10(v) < m_high)
                m_ticks.push_back({v, {}});
    }
}

void PlotScale::evenTicks(const QLocale& locale) {
    const double rough = (m_high - m_low) / 6;
    const double decade = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (const double nice : {5.0, 2.0, 1.0})
        if (nice * decade >= rough)
            step = nice * decade;
    for (double k = std::ceil(m_low / step); k * step <= m_high * (1 + 1e-12) && m_ticks.size() < 50; ++k)
        m_ticks.push_back({k * step, plainText(k * step, step, locale)});
}

// The entries flow from left to right, in as many lines as they need; returns the height of them all.
double PlotLayout::layLegend(const QRectF& area, const Plot& plot, const QFontMetricsF& metrics) {
    const double gap = metrics.height(), line = metrics.height() * 1.5;
    double left = area.left() + gap / 2, lines = 0;
    for (std::size_t k = 0; k < plot.series.size(); ++k) {
        if (plot.series[k].name.isEmpty())
            continue;
        const double width = sampleWidth + gap / 2 + metrics.horizontalAdvance(plot.series[k].name);
        if (lines == 0 || left + width > area.right()) {
            ++lines;
            left = area.left() + gap / 2;
        }
        legend.push_back({k, {left, (lines - 0.5) * line}});
        left += width + 1.5 * gap;
    }
    for (LegendEntry& entry : legend)
        entry.at.ry() += area.bottom() - lines * line;
    return lines * line;
}

PlotLayout::PlotLayout(const QRectF& area, const Plot& plot, const PlotStyle& style)
    : x(plot.x, valuesOf(plot, true), style.locale)
    , y(plot.y, valuesOf(plot, false), style.locale) {
    const QFontMetricsF metrics(style.font);
    QFont bold = style.font;
    bold.setBold(true);
    const double h = metrics.height(), gap = h / 2;
    sampleWidth = 3 * h;
    const double legendHeight = layLegend(area.adjusted(0, 0, 0, -gap / 2), plot, metrics);
    const double titleHeight = plot.title.isEmpty() ? 0 : QFontMetricsF(bold).height() + gap;
    const double left = (plot.y.title.isEmpty() ? 0 : h + gap) + widest(y, metrics) + 2 * gap;
    const double bottom = legendHeight + (plot.x.title.isEmpty() ? 0 : h + gap) + h + 1.5 * gap;
    const double right = std::max(2 * gap, 2 + widest(x, metrics) / 2); // half a label may stand over the end
    frame = area.adjusted(left, titleHeight + gap, -right, -bottom);
    if (frame.width() < 1 || frame.height() < 1) // too small to show anything
        frame = QRectF(area.topLeft(), QSizeF(1, 1));
    title = QRectF(area.left() + gap, area.top() + gap / 2, area.width() - h, titleHeight);
    xTitle = QRectF(frame.left(), frame.bottom() + h + gap, frame.width(), h + gap);
    yTitle = QRectF(area.left() + gap / 2, frame.top(), h + gap, frame.height());
}

} // namespace thetalane

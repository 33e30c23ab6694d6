#include "ui/plot/plot_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

namespace thetalane {
namespace {
constexpr double reach = 18; // of the mouse [px]
}

PlotView::PlotView(QWidget* parent)
    : QWidget(parent) {
    setMouseTracking(true);
    setMinimumSize(240, 160);
}

void PlotView::setPlot(Plot plot) {
    m_plot = std::move(plot);
    light({}); // its points may be others now
    update();
}

void PlotView::setStyle(const PlotStyle& style) {
    m_style = style;
    update();
}

void PlotView::light(const std::optional<PlotHit>& hit) {
    const bool same = hit.has_value() == m_lit.has_value() &&
                      (!hit || (hit->series == m_lit->series && hit->point == m_lit->point));
    m_lit = hit;
    if (same)
        return;
    update();
    if (hit)
        emit pointed(hit->series, hit->point);
}

void PlotView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintPlot(painter, rect(), m_plot, m_style, m_lit);
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    light(plotPointAt(event->position(), reach, rect(), m_plot, m_style));
    if (!m_lit) {
        QToolTip::hideText();
        return;
    }
    const PlotSeries& s = m_plot.series[m_lit->series];
    const PlotPoint& p = s.points[m_lit->point];
    const QString text = p.hover.isEmpty() ? (p.label.isEmpty() ? s.name : s.name + ", " + p.label) : p.hover;
    QToolTip::showText(event->globalPosition().toPoint(), text, this);
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    if (const auto hit = plotPointAt(event->position(), reach, rect(), m_plot, m_style))
        emit picked(hit->series, hit->point);
    else
        QWidget::mousePressEvent(event);
}

void PlotView::leaveEvent(QEvent* event) {
    light({});
    QWidget::leaveEvent(event);
}

} // namespace thetalane

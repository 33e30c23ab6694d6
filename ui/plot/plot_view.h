// A plot as a widget; the point under the mouse is lit, and its label shown.
#pragma once

#include "ui/plot/paint_plot.h"

#include <QWidget>

namespace thetalane {

class PlotView : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);

    const Plot& plot() const { return m_plot; }
    void setPlot(Plot plot);
    void setStyle(const PlotStyle& style);
    using QWidget::setStyle;

    const std::optional<PlotHit>& lit() const { return m_lit; }
    QSize sizeHint() const override { return {480, 320}; }

signals:
    void pointed(std::size_t series, std::size_t point); // the mouse came over it
    void picked(std::size_t series, std::size_t point);  // it was clicked

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void light(const std::optional<PlotHit>& hit);

    Plot m_plot;
    PlotStyle m_style;
    std::optional<PlotHit> m_lit;
};

} // namespace thetalane

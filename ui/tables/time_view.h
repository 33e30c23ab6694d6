// A plot over time with the playhead in it: press or drag to move the playhead. Bars, if there are any, stand
// on the axis and can be picked.
#pragma once

#include "ui/plot/plot_layout.h"

#include <QPixmap>
#include <QWidget>

namespace thetalane {

class Appearance;

struct TimeBar {
    double time = 0;  // [s]
    double value = 0; // on the plot's y axis
    QColor colour;
    bool wall = false; // drawn with a square head, a body's with a round one
    bool open = false; // the one that is selected
    QString hover;
};

class TimeView : public QWidget {
    Q_OBJECT
public:
    TimeView(const Appearance& appearance, const char* name, QWidget* parent = nullptr);

    void setPlot(Plot plot, std::vector<TimeBar> bars = {});
    void setCursor(double time, bool shown); // [s]
    using QWidget::setCursor;

    const Plot& plot() const { return m_plot; }
    const std::vector<TimeBar>& bars() const { return m_bars; }
    double cursorTime() const { return m_time; }
    QPointF at(double time, double value) const; // where that is, in pixels of the widget
    double timeAt(double x) const;               // [s], within the axis

    QSize sizeHint() const override { return {320, 220}; }
    QSize minimumSizeHint() const override { return {240, 150}; }

signals:
    void timeChosen(double time);
    void barPicked(std::size_t bar);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    const PlotLayout& layout() const;
    void forget();
    void paintBars(QPainter& painter) const;
    std::optional<std::size_t> barAt(QPointF where) const;

    const Appearance& m_appearance;
    Plot m_plot;
    std::vector<TimeBar> m_bars;
    double m_time = 0;
    bool m_hasCursor = false;
    bool m_dragging = false;
    mutable std::optional<PlotLayout> m_layout;
    QPixmap m_picture; // all but the cursor
};

// The look of the plots of this room.
PlotStyle plotStyleOf(const Appearance& appearance);

} // namespace thetalane

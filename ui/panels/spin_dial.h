// The ball from above as it turns: the axis through it, and a bead whose bearing is the axis' and whose
// distance is the rotation's. Drag it, turn the wheel (Shift: the axis), or use the arrow keys.
#pragma once

#include "ui/appearance.h"

#include <QWidget>

namespace thetalane {

class SpinDial : public QWidget {
    Q_OBJECT
public:
    SpinDial(const Appearance& appearance, const QString& name, QWidget* parent = nullptr);

    // rpm at most `mostRpm` on the dial; axis [°] from a forward roll, positive hooks left. What is beyond
    // the dial stays as it is and rests at its rim.
    static constexpr double mostRpm = 600;
    void setSpin(double rpm, double axis); // without a signal
    double rpm() const { return m_rpm; }
    double axis() const { return m_axis; }
    void setWords(const QString& name, const QString& toolTip, const QString& value);

    QPointF beadAt(double rpm, double axis) const; // [px]
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void edited(double rpm, double axis); // by the user only

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QPointF hub() const; // [px] the ball's middle
    double rim() const;  // [px] of the bead at the most
    double ring() const; // [px] of the bead at no rotation
    void moveTo(const QPointF& at, bool fine);
    void offer(double rpm, double axis);
    void paintBall(QPainter& painter) const;

    const Appearance& m_appearance;
    double m_rpm = 0;
    double m_axis = 0;
    int m_wheel = 0;
    bool m_held = false;
};

} // namespace thetalane

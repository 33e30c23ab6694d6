// A slider over real numbers, painted by us. What is outside its range stays as it is and rests at its end.
#pragma once

#include "ui/appearance.h"

#include <QSlider>

namespace thetalane {

class ValueSlider : public QSlider {
    Q_OBJECT
public:
    // The line is filled from `origin` to the handle. name becomes the objectName.
    ValueSlider(const Appearance& appearance, const QString& name, QWidget* parent = nullptr);

    void setSpan(double low, double high, double step, double origin);
    void setNumber(double number); // without a signal
    void setWords(const QString& name, const QString& toolTip);

    int xOf(double number) const; // [px]

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void numberEdited(double number); // by the user only

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    double handleRadius() const { return m_appearance.projector() ? 12 : 8; }
    void moveHandle(double x);

    const Appearance& m_appearance;
    double m_low = 0;
    double m_step = 0.01;
    double m_origin = 0;
    bool m_silent = false;
};

} // namespace thetalane

#include "ui/panels/value_slider.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace thetalane {

ValueSlider::ValueSlider(const Appearance& appearance, const QString& name, QWidget* parent)
    : QSlider(Qt::Horizontal, parent)
    , m_appearance(appearance) {
    setObjectName(name);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setSpan(0, 1, 0.01, 0);
    connect(&appearance, &Appearance::changed, this, [this] { updateGeometry(); });
    connect(this, &QSlider::valueChanged, this, [this](int steps) {
        if (!m_silent) // twelve digits: 0.1 + 0.2 is to be 0.3
            emit numberEdited(QString::number(m_low + steps * m_step, 'g', 12).toDouble());
    });
}

void ValueSlider::setSpan(double low, double high, double step, double origin) {
    m_low = low;
    m_step = step;
    m_origin = origin;
    m_silent = true;
    setRange(0, int(std::lround((high - low) / step)));
    setPageStep(10);
    m_silent = false;
}

void ValueSlider::setNumber(double number) {
    m_silent = true;
    setValue(int(std::lround(std::clamp((number - m_low) / m_step, 0.0, double(maximum())))));
    m_silent = false;
}

void ValueSlider::setWords(const QString& name, const QString& toolTip) {
    setAccessibleName(name);
    setToolTip(toolTip);
}

int ValueSlider::xOf(double number) const {
    const double share = std::clamp((number - m_low) / m_step / maximum(), 0.0, 1.0);
    return int(std::lround(handleRadius() + 1 + share * (width() - 2 * handleRadius() - 2)));
}

QSize ValueSlider::sizeHint() const {
    return {m_appearance.unit() * 10, m_appearance.projector() ? 36 : 24};
}

void ValueSlider::moveHandle(double x) {
    const double share = (x - handleRadius() - 1) / std::max(1.0, width() - 2 * handleRadius() - 2);
    setValue(int(std::lround(std::clamp(share, 0.0, 1.0) * maximum())));
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    setSliderDown(true);
    moveHandle(event->position().x());
    update();
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown())
        moveHandle(event->position().x());
}

void ValueSlider::mouseReleaseEvent(QMouseEvent*) {
    setSliderDown(false);
    update();
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
    // Only with the focus: a wheel that scrolls the panel must not change what passes under it.
    hasFocus() ? QSlider::wheelEvent(event) : event->ignore();
}

void ValueSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const double thick = m_appearance.projector() ? 4 : 3;
    const double from = xOf(m_origin);
    const double handle = xOf(m_low + value() * m_step);
    const double radius = handleRadius() - 1.5;

    painter.setPen(QPen(m_appearance.line(), thick, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(handleRadius(), middle), QPointF(width() - handleRadius(), middle));
    const QColor ink = isEnabled() ? m_appearance.accent() : m_appearance.quietText();
    painter.setPen(QPen(ink, thick, Qt::SolidLine, Qt::RoundCap));
    if (from != handle)
        painter.drawLine(QPointF(from, middle), QPointF(handle, middle));
    if (m_origin != m_low) // where the middle is
        painter.drawLine(QPointF(from, middle - thick * 1.5), QPointF(from, middle + thick * 1.5));

    painter.setPen(QPen(ink, 2));
    painter.setBrush(isSliderDown() ? ink : m_appearance.card());
    painter.drawEllipse(QPointF(handle, middle), radius, radius);
    if (hasFocus()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(QPointF(handle, middle), radius * 0.5, radius * 0.5);
    }
}

} // namespace thetalane

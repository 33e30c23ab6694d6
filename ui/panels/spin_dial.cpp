#include "ui/panels/spin_dial.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double rpmStep = 10, axisStep = 1;

// Up is the way the ball goes; a positive axis turns to the left.
QPointF towards(double axis) {
    return {-std::sin(axis * degree), -std::cos(axis * degree)};
}

double nearest(double value, double step) {
    return QString::number(std::round(value / step) * step, 'g', 12).toDouble() + 0.0; // not -0
}

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

} // namespace

SpinDial::SpinDial(const Appearance& appearance, const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(name);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
}

QSize SpinDial::sizeHint() const {
    const int side = 15 * m_appearance.unit();
    return {side, 3 * side / 4}; // below the ball there is nothing to set
}

void SpinDial::setSpin(double rpm, double axis) {
    if (rpm == m_rpm && axis == m_axis)
        return;
    m_rpm = rpm;
    m_axis = axis;
    update();
}

void SpinDial::setWords(const QString& name, const QString& toolTip, const QString& value) {
    setAccessibleName(name);
    setAccessibleDescription(value);
    setToolTip(toolTip);
}

double SpinDial::rim() const {
    return std::min(width() / 2.0, height() / 1.5) - m_appearance.unit();
}

QPointF SpinDial::hub() const {
    return {width() / 2.0, rim() + m_appearance.unit()};
}

double SpinDial::ring() const {
    return 0.62 * rim();
}

QPointF SpinDial::beadAt(double rpm, double axis) const {
    const double share = std::clamp(rpm / mostRpm, 0.0, 1.0);
    return hub() + towards(axis) * (ring() + share * (rim() - ring()));
}

void SpinDial::offer(double rpm, double axis) {
    rpm = std::clamp(rpm, 0.0, std::max(mostRpm, m_rpm));
    axis = std::clamp(axis, std::min(-90.0, m_axis), std::max(90.0, m_axis));
    if (rpm == m_rpm && axis == m_axis)
        return;
    setSpin(rpm, axis);
    emit edited(rpm, axis);
}

void SpinDial::moveTo(const QPointF& at, bool fine) {
    const QPointF v = at - hub();
    const double distance = std::hypot(v.x(), v.y());
    const double share = (distance - ring()) / (rim() - ring());
    const double rpm = nearest(std::clamp(share, 0.0, 1.0) * mostRpm, fine ? 1 : rpmStep);
    if (distance < ring() / 2) // too near to have a bearing
        return offer(rpm, m_axis);
    offer(rpm, nearest(std::atan2(-v.x(), -v.y()) / degree, fine ? 0.1 : axisStep));
}

bool SpinDial::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (isArrow(key->key()) && !(key->modifiers() & Qt::ControlModifier)) {
            event->accept(); // the window's arrows are the dial's while it has the focus
            return true;
        }
    }
    return QWidget::event(event);
}

void SpinDial::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    m_held = true;
    moveTo(event->position(), event->modifiers() & Qt::ShiftModifier);
    update();
}

void SpinDial::mouseMoveEvent(QMouseEvent* event) {
    if (m_held)
        moveTo(event->position(), event->modifiers() & Qt::ShiftModifier);
}

void SpinDial::mouseReleaseEvent(QMouseEvent*) {
    m_held = false;
    update();
}

// Only with the focus: a wheel that scrolls the panel must not change what passes under it.
void SpinDial::wheelEvent(QWheelEvent* event) {
    if (!hasFocus())
        return event->ignore();
    m_wheel += event->angleDelta().y();
    const int notches = m_wheel / QWheelEvent::DefaultDeltasPerStep;
    m_wheel -= notches * QWheelEvent::DefaultDeltasPerStep;
    const bool axis = event->modifiers() & Qt::ShiftModifier;
    offer(axis ? m_rpm : nearest(m_rpm + notches * rpmStep, 1),
          axis ? nearest(m_axis + notches * axisStep, 0.1) : m_axis);
    event->accept();
}

void SpinDial::keyPressEvent(QKeyEvent* event) {
    if (!isArrow(event->key()) || event->modifiers() & Qt::ControlModifier)
        return event->ignore();
    const bool fine = event->modifiers() & Qt::ShiftModifier;
    const int left = (event->key() == Qt::Key_Left) - (event->key() == Qt::Key_Right);
    const int up = (event->key() == Qt::Key_Up) - (event->key() == Qt::Key_Down);
    offer(up ? nearest(m_rpm + up * (fine ? 1 : rpmStep), 1) : m_rpm,
          left ? nearest(m_axis + left * (fine ? axisStep : 5 * axisStep), 0.1) : m_axis);
}

// The axis lies level, so that from above the ball's skin moves straight across it: in bands, the way of the
// arrow.
void SpinDial::paintBall(QPainter& painter) const {
    const QPointF centre = hub();
    const double radius = 0.46 * rim();
    const QPointF along = towards(m_axis), across(-along.y(), along.x());
    const QColor ink = m_appearance.ink(Ink::First);
    const double line = m_appearance.lineWidth();
    const bool turns = m_rpm > 0 && isEnabled();
    painter.setPen(
        QPen(turns ? m_appearance.text() : m_appearance.line(), line, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(centre - across * radius * 1.22, centre + across * radius * 1.22); // the axis
    painter.setPen(QPen(m_appearance.textInk(Ink::First), 0.5 * line));
    painter.setBrush(isEnabled() ? ink : m_appearance.line());
    painter.drawEllipse(centre, radius, radius);
    QColor light(Qt::white);
    light.setAlphaF(turns ? 0.45f : 0.2f);
    painter.setPen(QPen(light, line, Qt::SolidLine, Qt::FlatCap));
    for (const double side : {-0.66, -0.33, 0.33, 0.66}) {
        const double half = std::sqrt(1 - side * side) * radius * 0.96;
        const QPointF middle = centre + across * side * radius;
        painter.drawLine(middle - along * half, middle + along * half);
    }
    if (!turns)
        return;
    const QPointF tip = centre + along * radius * 0.8;
    painter.setPen(QPen(Qt::white, 1.5 * line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(centre - along * radius * 0.8, tip);
    const QPointF wings[] = {tip - along * 0.35 * radius + across * 0.25 * radius, tip,
                             tip - along * 0.35 * radius - across * 0.25 * radius};
    painter.drawPolyline(wings, 3);
}

void SpinDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre = hub();
    const double line = m_appearance.lineWidth();
    const QColor accent = isEnabled() ? m_appearance.accent() : m_appearance.quietText();
    // From a hook to the left over the forward roll to a hook to the right, at none and at the most rotation.
    painter.setPen(QPen(m_appearance.line(), line));
    for (const double r : {ring(), rim()})
        painter.drawArc(QRectF(centre - QPointF(r, r), QSizeF(2 * r, 2 * r)), 0, 180 * 16);
    for (int angle = -90; angle <= 90; angle += 30) {
        const double from = angle % 90 == 0 ? 0.94 : 0.97;
        painter.drawLine(centre + towards(angle) * rim() * from, centre + towards(angle) * rim());
    }
    paintBall(painter);
    const QPointF bead = beadAt(m_rpm, m_axis);
    painter.setPen(QPen(accent, 1.5 * line, Qt::SolidLine, Qt::FlatCap));
    painter.drawArc(QRectF(centre - QPointF(ring(), ring()), QSizeF(2 * ring(), 2 * ring())), 90 * 16,
                    int(std::clamp(m_axis, -180.0, 180.0) * 16));
    painter.drawLine(centre + towards(m_axis) * ring(), bead);
    const double radius = 0.75 * m_appearance.unit();
    painter.setPen(QPen(accent, 2));
    painter.setBrush(m_held ? accent : m_appearance.card());
    painter.drawEllipse(bead, radius, radius);
    if (hasFocus()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(accent);
        painter.drawEllipse(bead, radius * 0.5, radius * 0.5);
    }
}

} // namespace thetalane

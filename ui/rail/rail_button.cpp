#include "ui/rail/rail_button.h"

#include "ui/rail/room_icons.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace thetalane {

RailButton::RailButton(const Appearance& appearance, Room room, QWidget* parent)
    : QAbstractButton(parent)
    , m_appearance(appearance)
    , m_room(room) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
}

void RailButton::setCompact(bool compact) {
    if (compact == m_compact)
        return;
    m_compact = compact;
    updateGeometry();
    update();
}

int RailButton::iconSide() const {
    return m_appearance.projector() ? 30 : 22;
}

QSize RailButton::fullSize() const {
    const QFontMetrics metrics(m_appearance.font(Appearance::Size::Small));
    const int u = m_appearance.unit();
    return {std::max(metrics.horizontalAdvance(text()), iconSide()) + 2 * u,
            iconSide() + metrics.height() + u};
}

QSize RailButton::compactSize() const {
    const int u = m_appearance.unit();
    return {iconSide() + 2 * u, iconSide() + u};
}

void RailButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int u = m_appearance.unit();
    if (underMouse() || isChecked())
        painter.fillRect(rect(), m_appearance.hover());
    if (isChecked())
        painter.fillRect(QRect(0, 0, u / 2, height()), m_appearance.accent());
    const QColor colour = isChecked() ? m_appearance.accent() : m_appearance.quietText();
    const int side = iconSide();
    painter.save();
    painter.translate((width() - side) / 2.0, m_compact ? (height() - side) / 2.0 : u / 2.0);
    painter.scale(side / 24.0, side / 24.0);
    QPainterPath path = roomIcon(m_room);
    path.setFillRule(Qt::WindingFill);
    painter.fillPath(path, colour);
    painter.restore();
    if (!m_compact) {
        painter.setFont(m_appearance.font(Appearance::Size::Small));
        painter.setPen(isChecked() ? m_appearance.accent() : m_appearance.text());
        painter.drawText(rect().adjusted(0, side + u / 2, 0, -u / 4), Qt::AlignCenter, text());
    }
    if (hasFocus()) {
        painter.setPen(QPen(m_appearance.accent(), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void RailButton::enterEvent(QEnterEvent* event) {
    QAbstractButton::enterEvent(event);
    update();
}

void RailButton::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

} // namespace thetalane

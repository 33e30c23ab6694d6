#include "ui/panels/icon_button.h"

#include <QEnterEvent>
#include <QPainter>

namespace thetalane {

IconButton::IconButton(const Appearance& appearance, Icon icon, const char* name, QWidget* parent,
                       Weight weight)
    : QAbstractButton(parent)
    , m_appearance(appearance)
    , m_icon(icon)
    , m_weight(weight) {
    setObjectName(QLatin1String(name));
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] { updateGeometry(); });
}

void IconButton::showIcon(Icon icon) {
    m_icon = icon;
    update();
}

void IconButton::setWords(const QString& name, const QString& toolTip) {
    setAccessibleName(name);
    setToolTip(toolTip);
}

QSize IconButton::sizeHint() const {
    const int side = m_appearance.unit() * 4 - (m_appearance.projector() ? 8 : 0);
    const int big = m_appearance.unit() * 5 - (m_appearance.projector() ? 4 : 0);
    return m_weight == Weight::Prominent ? QSize(big, big) : QSize(side, side);
}

void IconButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool prominent = m_weight == Weight::Prominent;
    const QRectF area = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
    const double corner = prominent ? area.height() / 2 : 6;

    QColor back = prominent ? m_appearance.accent() : QColor(Qt::transparent);
    if (!isEnabled() && prominent)
        back = m_appearance.line();
    else if (isEnabled() && (isDown() || underMouse()))
        back = prominent ? back.darker(isDown() ? 130 : 112) : m_appearance.line();
    painter.setPen(Qt::NoPen);
    painter.setBrush(back);
    painter.drawRoundedRect(area, corner, corner);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(prominent ? m_appearance.text() : m_appearance.accent(), 2));
        painter.drawRoundedRect(area, corner, corner);
    }

    const double side = std::min(width(), height()) * (prominent ? 0.56 : 0.66);
    QRectF where(0, 0, side, side);
    where.moveCenter(QRectF(rect()).center());
    const QColor ink = !isEnabled() ? (prominent ? m_appearance.card() : m_appearance.line())
                       : prominent  ? m_appearance.card()
                                    : m_appearance.text();
    paintIcon(painter, m_icon, where, ink);
}

void IconButton::enterEvent(QEnterEvent* event) {
    update();
    QAbstractButton::enterEvent(event);
}

void IconButton::leaveEvent(QEvent* event) {
    update();
    QAbstractButton::leaveEvent(event);
}

IconMark::IconMark(const Appearance& appearance, Icon icon, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_icon(icon) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] { updateGeometry(); });
}

QSize IconMark::sizeHint() const {
    return QSize(3, 2) * m_appearance.unit();
}

void IconMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintIcon(painter, m_icon, rect(), m_appearance.quietText());
}

} // namespace thetalane

#include "ui/game/frame_deck.h"

#include "ui/game/game_words.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace thetalane {

FrameDeck::FrameDeck(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] { updateGeometry(); });
    describe();
}

void FrameDeck::setPins(const PinSet& present, const PinSet& standing) {
    m_present = present;
    m_standing = standing;
    describe();
    update();
}

void FrameDeck::setChoosable(bool on) {
    m_choosable = on;
    setFocusPolicy(on ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(on ? Qt::PointingHandCursor : Qt::ArrowCursor);
    describe();
}

void FrameDeck::setTitle(const QString& title) {
    m_title = title;
    describe();
}

void FrameDeck::describe() {
    const QString pins = standingText(m_standing);
    setAccessibleName(m_title.isEmpty() ? pins : m_title + QStringLiteral(": ") + pins);
    setToolTip(m_choosable
                   ? tr("Click the pins that fell; on the keyboard the digits 1 to 9, and 0 for pin 10")
                   : pins);
}

QSize FrameDeck::sizeHint() const {
    const int unit = m_appearance.unit();
    return m_choosable ? QSize(14 * unit, 12 * unit) : QSize(11 * unit, 9 * unit + unit / 2);
}

double FrameDeck::radius() const {
    return 0.43 * std::min(width() / 4.0, height() / 3.6);
}

// The head pin in front, below.
QPointF FrameDeck::centre(int pin) const {
    const double step = std::min(width() / 4.0, height() / 3.6);
    const Vec2d at = pinPositions()[std::size_t(pin)];
    const double last = 3 * regulation::pinRowSpacing;
    return {width() / 2.0 + at.x / regulation::pinSpacing * step,
            height() / 2.0 - (at.y - last / 2) / regulation::pinSpacing * step};
}

void FrameDeck::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double r = radius();
    QFont font = m_appearance.font(Appearance::Size::Small, true);
    font.setPixelSize(std::max(8, int(r * 1.05)));
    painter.setFont(font);
    for (int pin = 0; pin < 10; ++pin) {
        const auto k = std::size_t(pin);
        const QPointF c = centre(pin);
        if (m_standing[k]) {
            painter.setPen(QPen(m_appearance.text(), m_appearance.projector() ? 2 : 1.4));
            painter.setBrush(m_appearance.pin());
            painter.drawEllipse(c, r, r);
            painter.drawText(QRectF(c.x() - r, c.y() - r, 2 * r, 2 * r), Qt::AlignCenter,
                             QString::number(pin + 1));
        } else if (m_present[k]) { // lies
            painter.setPen(QPen(m_appearance.line(), 1));
            painter.setBrush(m_choosable ? m_appearance.line() : QColor(Qt::transparent));
            painter.drawEllipse(c, r, r);
            if (m_choosable) {
                painter.setPen(m_appearance.quietText());
                painter.drawText(QRectF(c.x() - r, c.y() - r, 2 * r, 2 * r), Qt::AlignCenter,
                                 QString::number(pin + 1));
            }
        } else {
            painter.setPen(Qt::NoPen);
            painter.setBrush(m_appearance.line());
            painter.drawEllipse(c, r / 4, r / 4);
        }
    }
    if (hasFocus()) {
        painter.setPen(QPen(m_appearance.accent(), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
}

void FrameDeck::mousePressEvent(QMouseEvent* event) {
    if (!m_choosable || event->button() != Qt::LeftButton)
        return event->ignore();
    for (int pin = 0; pin < 10; ++pin)
        if (const QPointF d = event->position() - centre(pin);
            m_present[std::size_t(pin)] && QPointF::dotProduct(d, d) <= radius() * radius() * 1.3)
            return emit chosen(pin);
}

void FrameDeck::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    const int pin = key == Qt::Key_0 ? 9 : key - Qt::Key_1;
    if (m_choosable && key >= Qt::Key_0 && key <= Qt::Key_9 && m_present[std::size_t(pin)])
        return emit chosen(pin);
    QWidget::keyPressEvent(event);
}

// A digit typed here is no shortcut of the window's.
bool FrameDeck::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_choosable) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key >= Qt::Key_0 && key <= Qt::Key_9)
            event->accept();
    }
    return QWidget::event(event);
}

void FrameDeck::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        describe();
    QWidget::changeEvent(event);
}

} // namespace thetalane

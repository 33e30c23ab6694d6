#include "ui/lessons/card_button.h"

#include "ui/lessons/lesson_text.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace thetalane {
namespace {

constexpr int wrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

int heightOf(const QFont& font, int width, const QString& text) {
    if (text.isEmpty())
        return 0;
    return QFontMetrics(font).boundingRect(QRect(0, 0, width, 100'000), wrapped, keptWords(text)).height();
}

} // namespace

CardButton::CardButton(const Appearance& appearance, const QString& name, QWidget* parent)
    : QAbstractButton(parent)
    , m_appearance(appearance) {
    setObjectName(name);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void CardButton::setMark(const QString& mark) {
    m_mark = mark;
    update();
}

void CardButton::setWords(const QString& words, const QString& below, const QString& toolTip) {
    m_words = words;
    m_below = below;
    setText(words);
    setAccessibleName(words);
    setAccessibleDescription(below);
    setToolTip(toolTip);
    updateGeometry();
    update();
}

void CardButton::setState(State state) {
    m_state = state;
    update();
}

QFont CardButton::wordsFont() const {
    return m_appearance.font(Appearance::Size::Large, !m_below.isEmpty());
}

CardButton::Places CardButton::placesFor(int width) const {
    const int unit = m_appearance.unit();
    const int side = QFontMetrics(m_appearance.font(Appearance::Size::Large)).height() + unit / 2;
    const int left = unit + side + unit, room = std::max(width - left - unit, 8 * unit);
    Places p;
    const QFont below = m_appearance.font(Appearance::Size::Normal);
    const int words = heightOf(wordsFont(), room, m_words), second = heightOf(below, room, m_below);
    const int gap = second > 0 ? unit / 4 : 0;
    const int inside = std::max(side, words + gap + second);
    // An option is a line, a card stands for itself.
    p.height = std::max(inside + (m_below.isEmpty() ? unit : 2 * unit), m_appearance.projector() ? 44 : 32);
    const int top = (p.height - words - gap - second) / 2;
    p.mark = QRect(unit, (p.height - side) / 2, side, side);
    p.words = QRect(left, top, room, words);
    p.below = QRect(left, top + words + gap, room, second);
    return p;
}

int CardButton::heightForWidth(int width) const {
    return placesFor(width).height;
}

QSize CardButton::sizeHint() const {
    const int width = std::max(this->width(), 200);
    return {width, heightForWidth(width)};
}

QSize CardButton::minimumSizeHint() const {
    return {20 * m_appearance.unit(), m_appearance.projector() ? 44 : 32};
}

// The arrow keys go from card to card, Return presses; elsewhere in the window they have other uses.
bool CardButton::event(QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QAbstractButton::event(event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool steps = key == Qt::Key_Up || key == Qt::Key_Down;
    const bool presses = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (!steps && !presses)
        return QAbstractButton::event(event);
    if (event->type() == QEvent::KeyPress) {
        if (presses)
            click();
        else
            focusNextPrevChild(key == Qt::Key_Down);
    }
    event->accept();
    return true;
}

void CardButton::paintMark(QPainter& painter, const QRect& where) const {
    const Appearance& look = m_appearance;
    const bool isFull = m_state != State::Plain;
    const QColor colour = m_state == State::Wrong   ? look.error()
                          : m_state == State::Right ? look.textInk(Ink::Along)
                                                    : look.accent();
    painter.setPen(QPen(colour, look.lineWidth()));
    painter.setBrush(isFull ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QRectF(where).adjusted(1, 1, -1, -1));
    painter.setPen(isFull ? look.card() : colour);
    if (m_state == State::Plain || m_state == State::Chosen) {
        painter.setFont(look.font(Appearance::Size::Normal, true));
        painter.drawText(where, Qt::AlignCenter, m_mark);
        return;
    }
    const auto at = [&](double x, double y) {
        return QPointF(where.x() + x * where.width(), where.y() + y * where.height());
    };
    painter.setPen(QPen(look.card(), where.width() / 8.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    if (m_state == State::Right) {
        const QPointF tick[] = {at(0.28, 0.52), at(0.44, 0.68), at(0.72, 0.34)};
        painter.drawPolyline(tick, 3);
    } else {
        painter.drawLine(at(0.33, 0.33), at(0.67, 0.67));
        painter.drawLine(at(0.33, 0.67), at(0.67, 0.33));
    }
}

void CardButton::paintEvent(QPaintEvent*) {
    const Appearance& look = m_appearance;
    const Places p = placesFor(width());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool marked = hasFocus() || m_state != State::Plain;
    const QColor edge = m_state == State::Wrong   ? look.error()
                        : m_state == State::Right ? look.textInk(Ink::Along)
                        : marked                  ? look.accent()
                        : underMouse()            ? look.quietText()
                                                  : look.line();
    painter.setPen(QPen(edge, marked ? 2 : 1));
    painter.setBrush(isDown() ? look.line() : look.card());
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    paintMark(painter, p.mark);
    painter.setFont(wordsFont());
    painter.setPen(look.text());
    painter.drawText(p.words, wrapped, keptWords(m_words));
    painter.setFont(look.font(Appearance::Size::Normal));
    painter.setPen(look.quietText());
    painter.drawText(p.below, wrapped, keptWords(m_below));
}

} // namespace thetalane

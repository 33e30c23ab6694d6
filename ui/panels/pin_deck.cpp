#include "ui/panels/pin_deck.h"

#include "ui/appearance.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thetalane {
namespace {

using namespace regulation;

// A pin as painted, of the distance between two: larger than it is, to be read and hit.
constexpr double painted = 0.40;
constexpr double wide = 3 + 2 * painted;                              // in spacings
constexpr double deep = 3 * pinRowSpacing / pinSpacing + 2 * painted; // the same

double spacingIn(const QRectF& where) {
    return std::min(where.width() / wide, where.height() / deep);
}

void paintNumber(QPainter& p, const QPointF& at, double radius, int number, const QColor& colour,
                 const Appearance& a) {
    QFont font = a.font(Appearance::Size::Small, true);
    font.setPixelSize(std::max(font.pixelSize(), int(std::lround(radius * 1.05))));
    p.setFont(font);
    p.setPen(colour);
    p.drawText(QRectF(at.x() - 2 * radius, at.y() - radius, 4 * radius, 2 * radius), Qt::AlignCenter,
               QString::number(number));
}

void paintStanding(QPainter& p, const QPointF& at, double radius, int number, const Appearance& a) {
    const bool readable = radius >= 0.8 * a.pixels(Appearance::Size::Small);
    const double line = std::clamp(radius * 0.16, 1.0, a.lineWidth());
    p.setPen(QPen(a.text(), line));
    p.setBrush(readable ? a.pin() : a.text());
    p.drawEllipse(at, radius - line / 2, radius - line / 2);
    if (readable)
        paintNumber(p, at, radius, number, a.text(), a);
}

void paintSpot(QPainter& p, const QPointF& at, double radius, const Appearance& a) {
    p.setPen(Qt::NoPen);
    p.setBrush(a.projector() ? a.quietText() : a.dark() ? a.line().lighter(140) : a.gutter().darker(115));
    p.drawEllipse(at, 0.28 * radius, 0.28 * radius);
}

// One that can be set up again.
void paintLying(QPainter& p, const QPointF& at, double radius, int number, const Appearance& a) {
    p.setPen(Qt::NoPen);
    p.setBrush(a.dark() || a.projector() ? a.hover() : a.line());
    p.drawEllipse(at, radius, radius);
    paintNumber(p, at, radius, number, a.quietText(), a);
}

} // namespace

QPointF deckPinCentre(const QRectF& where, int k) {
    static const auto positions = pinPositions();
    const Vec2d at = positions[std::size_t(k)];
    const double spacing = spacingIn(where);
    const double middle = 1.5 * pinRowSpacing;
    return {where.center().x() + at.x / pinSpacing * spacing,
            where.center().y() - (at.y - middle) / pinSpacing * spacing};
}

double deckPinRadius(const QRectF& where) {
    return painted * spacingIn(where);
}

void paintPinDeck(QPainter& p, const QRectF& where, const PinSet& standing, const Appearance& a) {
    p.save();
    p.setRenderHint(QPainter::Antialiasing);
    const double radius = deckPinRadius(where);
    for (int k = 0; k < 10; ++k)
        if (standing[std::size_t(k)])
            paintStanding(p, deckPinCentre(where, k), radius, k + 1, a);
        else
            paintSpot(p, deckPinCentre(where, k), radius, a);
    p.restore();
}

QString pinsText(const PinSet& pins) {
    QStringList numbers;
    for (std::size_t k = 0; k < pins.size(); ++k)
        if (pins[k])
            numbers << QString::number(k + 1);
    return numbers.isEmpty() ? QStringLiteral("—") : numbers.join(u'-');
}

PinDeck::PinDeck(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("pinDeck"));
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    retranslate();
}

void PinDeck::setStanding(const PinSet& standing) {
    if (standing == m_standing)
        return;
    m_standing = standing;
    describe();
    update();
}

void PinDeck::setPresent(const PinSet& present) {
    m_present = present;
    update();
}

void PinDeck::setTitle(const QString& title) {
    m_title = title;
    retranslate();
}

void PinDeck::setPickable(bool on) {
    m_pickable = on;
    setMouseTracking(on);
    setFocusPolicy(on ? Qt::StrongFocus : Qt::NoFocus);
    retranslate();
    updateGeometry();
    update();
}

QSize PinDeck::sizeHint() const {
    const double spacing = m_pickable ? (m_appearance.projector() ? 56 : 40) : 3.5 * m_appearance.unit();
    return QSizeF(spacing * wide + 8, spacing * deep + 8).toSize();
}

QSize PinDeck::minimumSizeHint() const {
    // A pin to be picked is a button.
    const double spacing = m_pickable ? (m_appearance.projector() ? 46 : 31) : 1.5 * m_appearance.unit();
    return QSizeF(spacing * wide + 8, spacing * deep + 8).toSize();
}

QRectF PinDeck::deck() const {
    return QRectF(rect()).adjusted(4, 4, -4, -4);
}

int PinDeck::pinAt(const QPointF& point) const {
    const double reach = deckPinRadius(deck()) / painted / 2; // up to half-way to the next one
    for (int k = 0; k < 10; ++k) {
        const QPointF d = point - deckPinCentre(deck(), k);
        if (m_present[std::size_t(k)] && std::hypot(d.x(), d.y()) <= reach)
            return k;
    }
    return -1;
}

void PinDeck::toggle(int pin) {
    if (!m_present[std::size_t(pin)])
        return;
    m_current = pin;
    m_standing.flip(std::size_t(pin));
    describe();
    update();
    emit picked(m_standing);
    emit turned(pin);
}

// To the nearest pin that lies that way: along the row, or to the row before or behind.
void PinDeck::moveBy(int across, int down) {
    const QPointF from = deckPinCentre(deck(), m_current);
    const double spacing = spacingIn(deck());
    int best = -1;
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k < 10; ++k) {
        const QPointF d = deckPinCentre(deck(), k) - from;
        const double ahead = d.x() * across + d.y() * down, aside = std::abs(d.x() * down - d.y() * across);
        if (ahead < 0.25 * spacing || (across != 0 && aside > 0.25 * spacing))
            continue;
        const double far = ahead + 1.5 * aside;
        if (far < least - 1e-6 * spacing) {
            least = far;
            best = k;
        }
    }
    if (best < 0)
        return;
    m_current = best;
    describe();
    update();
}

bool PinDeck::event(QEvent* event) {
    // A window's own shortcuts for arrows and space wait while this has the focus.
    if (event->type() == QEvent::ShortcutOverride && m_pickable) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool own =
            key->modifiers() == Qt::NoModifier &&
            (key->key() == Qt::Key_Space || (key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down) ||
             (key->key() >= Qt::Key_0 && key->key() <= Qt::Key_9));
        if (own) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void PinDeck::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const double radius = deckPinRadius(deck());
    if (!m_pickable)
        return paintPinDeck(p, deck(), m_standing, m_appearance);
    for (int k = 0; k < 10; ++k) {
        const QPointF at = deckPinCentre(deck(), k);
        if (m_standing[std::size_t(k)])
            paintStanding(p, at, radius, k + 1, m_appearance);
        else if (m_present[std::size_t(k)])
            paintLying(p, at, radius, k + 1, m_appearance);
        else
            paintSpot(p, at, radius, m_appearance);
    }
    if (m_hovered >= 0) {
        p.setPen(QPen(m_appearance.accent(), m_appearance.lineWidth()));
        p.setBrush(Qt::NoBrush);
        p.drawEllipse(deckPinCentre(deck(), m_hovered), radius, radius);
    }
    if (hasFocus()) {
        p.setPen(QPen(m_appearance.accent(), m_appearance.lineWidth()));
        p.setBrush(Qt::NoBrush);
        const double ring = radius + 1.5 * m_appearance.lineWidth();
        p.drawEllipse(deckPinCentre(deck(), m_current), ring, ring);
    }
}

void PinDeck::mousePressEvent(QMouseEvent* event) {
    const int pin = m_pickable && event->button() == Qt::LeftButton ? pinAt(event->position()) : -1;
    if (pin < 0)
        return event->ignore();
    toggle(pin);
}

void PinDeck::mouseMoveEvent(QMouseEvent* event) {
    const int pin = m_pickable ? pinAt(event->position()) : -1;
    if (pin == m_hovered)
        return;
    m_hovered = pin;
    setCursor(pin >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void PinDeck::leaveEvent(QEvent* event) {
    m_hovered = -1;
    update();
    QWidget::leaveEvent(event);
}

void PinDeck::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (!m_pickable || (event->modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
        return QWidget::keyPressEvent(event);
    if (key >= Qt::Key_0 && key <= Qt::Key_9)
        return toggle(key == Qt::Key_0 ? 9 : key - Qt::Key_1);
    switch (key) {
    case Qt::Key_Left:
        return moveBy(-1, 0);
    case Qt::Key_Right:
        return moveBy(+1, 0);
    case Qt::Key_Up:
        return moveBy(0, -1);
    case Qt::Key_Down:
        return moveBy(0, +1);
    case Qt::Key_Space:
        return toggle(m_current);
    default:
        QWidget::keyPressEvent(event);
    }
}

void PinDeck::focusInEvent(QFocusEvent* event) {
    update();
    QWidget::focusInEvent(event);
}

void PinDeck::focusOutEvent(QFocusEvent* event) {
    update();
    QWidget::focusOutEvent(event);
}

void PinDeck::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void PinDeck::retranslate() {
    setAccessibleName(m_title.isEmpty() ? tr("Standing pins") : m_title);
    if (m_pickable)
        setToolTip(tr("Click a pin to turn it over; or press its number, 0 for pin 10"));
    describe();
}

void PinDeck::describe() {
    const QString standing = m_standing.none() ? tr("no pin stands") : pinsText(m_standing);
    setAccessibleDescription(!m_pickable ? standing
                                         : tr("%1; at pin %2").arg(standing, QString::number(m_current + 1)));
}

} // namespace thetalane

#include "ui/practice/leaves.h"

#include "ui/panels/pin_deck.h"

#include <QCoreApplication>
#include <QPainter>

#include <array>
#include <initializer_list>

namespace thetalane {
namespace {

struct Leaves {
    Q_DECLARE_TR_FUNCTIONS(Leaves)
};

constexpr PinSet pinsOf(std::initializer_list<int> numbers) {
    unsigned long bits = 0;
    for (const int number : numbers)
        bits |= 1UL << (number - 1);
    return PinSet(bits);
}

struct Leaf {
    PinSet pins;
    const char* name; // null: its pins are name enough
};

constexpr std::array leaves{
    Leaf{pinsOf({10}), QT_TRANSLATE_NOOP("Leaves", "10 pin")},
    Leaf{pinsOf({7}), QT_TRANSLATE_NOOP("Leaves", "7 pin")},
    Leaf{pinsOf({6, 10}), nullptr},
    Leaf{pinsOf({4, 7}), nullptr},
    Leaf{pinsOf({3, 10}), QT_TRANSLATE_NOOP("Leaves", "Baby split 3-10")},
    Leaf{pinsOf({2, 7}), QT_TRANSLATE_NOOP("Leaves", "Baby split 2-7")},
    Leaf{pinsOf({5, 7}), QT_TRANSLATE_NOOP("Leaves", "Split 5-7")},
    Leaf{pinsOf({7, 10}), QT_TRANSLATE_NOOP("Leaves", "Split 7-10")},
    Leaf{pinsOf({6, 7, 10}), QT_TRANSLATE_NOOP("Leaves", "Split 6-7-10")},
    Leaf{pinsOf({4, 6, 7, 10}), QT_TRANSLATE_NOOP("Leaves", "Big four 4-6-7-10")},
    Leaf{pinsOf({2, 4, 5, 8}), QT_TRANSLATE_NOOP("Leaves", "Bucket 2-4-5-8")},
    Leaf{pinsOf({3, 5, 6, 9}), QT_TRANSLATE_NOOP("Leaves", "Bucket 3-5-6-9")},
    Leaf{pinsOf({1, 2, 4, 10}), QT_TRANSLATE_NOOP("Leaves", "Washout 1-2-4-10")},
    Leaf{pinsOf({1, 3, 6, 7}), QT_TRANSLATE_NOOP("Leaves", "Washout 1-3-6-7")},
    Leaf{PinSet(1023), QT_TRANSLATE_NOOP("Leaves", "All ten pins")},
};

} // namespace

std::span<const PinSet> classicLeaves() {
    static const auto pins = [] {
        std::array<PinSet, leaves.size()> all;
        for (std::size_t k = 0; k < leaves.size(); ++k)
            all[k] = leaves[k].pins;
        return all;
    }();
    return pins;
}

QString leafName(const PinSet& pins) {
    for (const Leaf& leaf : leaves)
        if (leaf.pins == pins && leaf.name)
            return QCoreApplication::translate("Leaves", leaf.name);
    return pins.none() ? Leaves::tr("No pins") : Leaves::tr("Pins %1").arg(pinsText(pins));
}

LeafButton::LeafButton(const Appearance& appearance, const PinSet& pins, QWidget* parent)
    : QAbstractButton(parent)
    , m_appearance(appearance)
    , m_pins(pins) {
    setObjectName(QStringLiteral("leaf") + pinsText(pins));
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    retranslate();
}

QSize LeafButton::sizeHint() const {
    return m_appearance.projector() ? QSize(92, 88) : QSize(58, 58);
}

void LeafButton::retranslate() {
    setAccessibleName(leafName(m_pins));
    setToolTip(leafName(m_pins));
}

void LeafButton::enterEvent(QEnterEvent* event) {
    update();
    QAbstractButton::enterEvent(event);
}

void LeafButton::leaveEvent(QEvent* event) {
    update();
    QAbstractButton::leaveEvent(event);
}

void LeafButton::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const Appearance& a = m_appearance;
    const bool bright = isChecked() || hasFocus();
    p.setPen(QPen(bright ? a.accent() : underMouse() ? a.quietText() : a.line(), bright ? 2 : 1));
    p.setBrush(isChecked() ? a.chosen() : a.card());
    p.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
    if (isChecked() && hasFocus()) {
        p.setPen(QPen(a.text(), a.lineWidth()));
        p.setBrush(Qt::NoBrush);
        p.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
    }
    const double text = 1.5 * a.pixels(Appearance::Size::Small);
    paintPinDeck(p, QRectF(rect()).adjusted(6, 6, -6, -text - 2), m_pins, a);
    p.setFont(a.font(Appearance::Size::Small, isChecked()));
    p.setPen(isChecked() ? a.accent() : a.text());
    p.drawText(QRectF(0, height() - text - 3, width(), text), Qt::AlignCenter,
               m_pins.all() ? QStringLiteral("1-10") : pinsText(m_pins));
}

} // namespace thetalane

#include "ui/lane/pin_badge.h"

#include "core/bowling/pinfall.h"
#include "ui/lane/arrow.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace thetalane {
namespace {

// Some of the ten pins, each on a spot of its own.
bool isRack(const Scene& scene) {
    const auto spots = pinPositions();
    return std::all_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& b) {
        return b.kind != BodyKind::Pin || std::find(spots.begin(), spots.end(), b.position) != spots.end();
    });
}

} // namespace

PinBadge::PinBadge(const Context& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context) {
    setObjectName("pinBadge");
    setAttribute(Qt::WA_TransparentForMouseEvents); // what is under it can still be dragged
    connect(&context.session, &Session::runChanged, this, &PinBadge::adoptRun);
    connect(&context.session, &Session::chapterChanged, this, &PinBadge::adoptChapter);
    connect(&context.playhead, &Playhead::timeChanged, this, &PinBadge::showTime);
    connect(&context.appearance, &Appearance::changed, this, [this] {
        emit resized();
        update();
    });
    retranslate();
    adoptRun();
}

void PinBadge::adoptRun() {
    const RunPart part = m_context.session.part();
    const auto run = m_context.session.run();
    const auto count = [&](const std::vector<int>& pins) { return std::int64_t(pins.size()); };
    m_settled = false;
    if (!part.isWhole() && part.collisionsBefore == 0) {
        const auto pins = std::count_if(run->scene.bodies.begin(), run->scene.bodies.end(),
                                        [](const Body& b) { return b.kind == BodyKind::Pin; });
        m_settled = count(pinsTouched(run->scene, run->timeline, part.to)) == pins &&
                    count(pinsDown(run->scene, run->timeline, part.to)) == pins;
    }
    adoptChapter();
}

// What happened in earlier chapters cannot be seen in a later one: there the numbers stand only if no pin was
// left after the first.
void PinBadge::adoptChapter() {
    m_run = m_context.session.run();
    m_later = m_context.session.part().collisionsBefore > 0;
    const Scene& scene = m_run->scene;
    m_changes.clear();
    m_spots.clear();
    m_pins = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].kind != BodyKind::Pin)
            continue;
        ++m_pins;
        m_spots.push_back({int(i), scene.bodies[i].position, false});
        for (const Segment& s : m_run->timeline.segments(i))
            m_changes.push_back(s.start);
    }
    if (m_pins > 0)
        for (const Collision& c : m_run->timeline.collisions())
            m_changes.push_back(c.time);
    if (!isRack(scene) || m_later)
        m_spots.clear();
    std::sort(m_changes.begin(), m_changes.end());
    m_change = -1;
    setVisible(m_pins > 0 && (!m_later || m_settled));
    showTime(m_context.playhead.time());
}

void PinBadge::showTime(double time) {
    if (m_pins == 0 || m_run != m_context.session.run())
        return;
    const auto passed = std::upper_bound(m_changes.begin(), m_changes.end(), time) - m_changes.begin();
    if (passed == m_change)
        return;
    m_change = passed;
    m_touched = m_later ? m_pins : int(pinsTouched(m_run->scene, m_run->timeline, time).size());
    const auto down = m_later ? std::vector<int>() : pinsDown(m_run->scene, m_run->timeline, time);
    m_down = m_later ? m_pins : int(down.size());
    for (Spot& spot : m_spots)
        spot.down = std::find(down.begin(), down.end(), spot.body) != down.end();
    // While a ball is aimed there are runs and runs, and each begins with all the pins.
    if (Said said{m_pins, m_touched, m_down, m_spots}; said != m_said) {
        m_said = std::move(said);
        retranslate();
    }
}

QSize PinBadge::sizeHint() const {
    const Appearance& look = m_context.appearance;
    const QFontMetrics text(look.font(Appearance::Size::Normal));
    const QFontMetrics number(look.font(Appearance::Size::Title, true));
    const int words = text.horizontalAdvance(m_touchedText) + text.horizontalAdvance(m_downText);
    const int numbers = 2 * number.horizontalAdvance(QString::number(m_pins));
    return {words + numbers + int(deckWidth()) + 6 * look.unit(), number.height() + look.unit()};
}

double PinBadge::deckWidth() const {
    return showsDeck() ? 6.0 * m_context.appearance.unit() : 0;
}

std::vector<int> PinBadge::standing() const {
    std::vector<int> bodies;
    for (const Spot& spot : m_spots)
        if (!spot.down)
            bodies.push_back(spot.body);
    return bodies;
}

// As one sees it from the foul line: a pin that stands is full, one that went down an empty ring, and a spot
// where none was set a dot.
void PinBadge::paintDeck(QPainter& painter, const QRectF& box) const {
    const Appearance& look = m_context.appearance;
    const double step = box.height() / 4;
    const auto at = [&](const Vec2d& place) {
        return QPointF(box.center().x() + place.x / regulation::pinSpacing * step * 1.15,
                       box.bottom() - (place.y / regulation::pinRowSpacing + 0.5) * step);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.line());
    for (const Vec2d& spot : pinPositions())
        painter.drawEllipse(at(spot), 0.14 * step, 0.14 * step);
    for (const Spot& spot : m_spots) {
        painter.setPen(QPen(spot.down ? look.line() : look.text(), 1));
        painter.setBrush(spot.down ? look.card() : look.text());
        painter.drawEllipse(at(spot.place), 0.36 * step, 0.36 * step);
    }
}

// Words quiet, numbers large: the back row reads the numbers.
void PinBadge::paintEvent(QPaintEvent*) {
    const Appearance& look = m_context.appearance;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.line(), 1));
    painter.setBrush(faded(look.card(), 0.92));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), look.unit(), look.unit());
    const QFont text = look.font(Appearance::Size::Normal);
    const QFont number = look.font(Appearance::Size::Title, true);
    const int base = height() / 2 + QFontMetrics(number).capHeight() / 2;
    int x = 3 * look.unit() / 2;
    if (showsDeck()) {
        const double inset = 0.5 * look.unit();
        paintDeck(painter, QRectF(x, inset, deckWidth() - look.unit(), height() - 2 * inset));
        x += int(deckWidth());
    }
    const auto put = [&](const QFont& font, const QColor& colour, const QString& words, int advance) {
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(x, base, words);
        x += (advance > 0 ? advance : QFontMetrics(font).horizontalAdvance(words)) + look.unit();
    };
    // The place of a number is as wide as the largest one, so that nothing shifts while the pins fall.
    const int widest = QFontMetrics(number).horizontalAdvance(QString::number(m_pins));
    put(text, look.quietText(), m_touchedText, 0);
    put(number, look.text(), QString::number(m_touched), widest);
    put(text, look.quietText(), m_downText, 0);
    put(number, look.quietText(), QString::number(m_down), widest);
}

void PinBadge::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void PinBadge::retranslate() {
    m_touchedText = tr("Pins touched");
    m_downText = tr("down");
    setAccessibleName(tr("Pins touched: %1, down: %2").arg(m_touched).arg(m_down));
    if (sizeHint() != size()) // room for as many digits as there are pins
        emit resized();
    update();
}

} // namespace thetalane

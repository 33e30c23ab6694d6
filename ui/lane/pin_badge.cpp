#include "ui/lane/pin_badge.h"

#include "core/bowling/pinfall.h"
#include "ui/lane/arrow.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace thetalane {

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
    m_pins = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].kind != BodyKind::Pin)
            continue;
        ++m_pins;
        for (const Segment& s : m_run->timeline.segments(i))
            m_changes.push_back(s.start);
    }
    if (m_pins > 0)
        for (const Collision& c : m_run->timeline.collisions())
            m_changes.push_back(c.time);
    std::sort(m_changes.begin(), m_changes.end());
    m_change = -1;
    setVisible(m_pins > 0 && (!m_later || m_settled));
    showTime(m_context.playhead.time());
    emit resized(); // room for as many digits as there are pins
}

void PinBadge::showTime(double time) {
    if (m_pins == 0 || m_run != m_context.session.run())
        return;
    const auto passed = std::upper_bound(m_changes.begin(), m_changes.end(), time) - m_changes.begin();
    if (passed == m_change)
        return;
    m_change = passed;
    m_touched = m_later ? m_pins : int(pinsTouched(m_run->scene, m_run->timeline, time).size());
    m_down = m_later ? m_pins : int(pinsDown(m_run->scene, m_run->timeline, time).size());
    retranslate();
}

QSize PinBadge::sizeHint() const {
    const Appearance& look = m_context.appearance;
    const QFontMetrics text(look.font(Appearance::Size::Normal));
    const QFontMetrics number(look.font(Appearance::Size::Title, true));
    const int words = text.horizontalAdvance(m_touchedText) + text.horizontalAdvance(m_downText);
    const int numbers = 2 * number.horizontalAdvance(QString::number(m_pins));
    return {words + numbers + 6 * look.unit(), number.height() + look.unit()};
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
    const QSize before = sizeHint();
    m_touchedText = tr("Pins touched");
    m_downText = tr("down");
    setAccessibleName(tr("Pins touched: %1, down: %2").arg(m_touched).arg(m_down));
    if (sizeHint() != before)
        emit resized();
    update();
}

} // namespace thetalane

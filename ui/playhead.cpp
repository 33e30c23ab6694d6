#include "ui/playhead.h"

#include "ui/session.h"

#include <algorithm>
#include <utility>

namespace thetalane {
namespace {

// How much of the run is slow about the first contact with a pin [s]: the ball 0.4 m before it, and until
// most of the pins have met.
constexpr double beforeImpact = 0.05, afterImpact = 0.3;

} // namespace

Playhead::Playhead(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(16);
    connect(&m_timer, &QTimer::timeout, this, [this] { advance(double(m_clock.nsecsElapsed()) * 1e-9); });
    connect(&session, &Session::runChanged, this, &Playhead::startAgain);
    connect(&session, &Session::progressed, this, &Playhead::followProgress);
    findImpact();
}

double Playhead::end() const {
    return m_session.shownUntil();
}

std::optional<std::size_t> Playhead::selected() const {
    const std::int64_t index = m_selected.value_or(0) - m_session.part().collisionsBefore - 1;
    if (!m_selected || index < 0 || index >= std::int64_t(m_session.timeline().collisions().size()))
        return std::nullopt;
    return std::size_t(index);
}

void Playhead::setTime(double time) {
    clearSelection();
    goTo(time, m_session.patience());
}

void Playhead::goTo(double time, int patience) {
    m_wish.reset();
    time = std::clamp(time, 0.0, end());
    const double there = std::min(time, m_session.reach());
    if (auto chapter = m_session.chapter(there, patience))
        put(std::move(chapter), there);
    if (m_time != time)
        m_wish = time;
}

// The time first: who is shown another chapter shows it as it is then.
void Playhead::put(std::shared_ptr<const Chapter> chapter, double time) {
    const bool moves = time != m_time;
    m_time = time;
    m_session.showChapter(std::move(chapter));
    if (moves)
        emit timeChanged(time);
}

void Playhead::setPlaying(bool on) {
    if (on == playing())
        return;
    if (on) {
        m_wish.reset();
        clearSelection();
        showWhole();
        if (m_time >= end())
            goTo(0, m_session.patience());
        m_clock.start();
        m_timer.start();
    } else {
        m_timer.stop();
    }
    emit playingChanged(on);
}

void Playhead::setRate(double rate) {
    if (rate == m_rate)
        return;
    m_rate = rate;
    emit rateChanged(rate);
}

void Playhead::setSlowAtImpact(bool on) {
    if (on == m_slowAtImpact)
        return;
    m_slowAtImpact = on;
    emit slowAtImpactChanged(on);
}

double Playhead::rateNow() const {
    const bool slow = m_slowAtImpact && m_impact && m_time >= m_impact->from && m_time < m_impact->to;
    return slow ? std::min(m_rate, impactRate) : m_rate;
}

// Of the first chapter: a throw has no other.
void Playhead::findImpact() {
    m_impact.reset();
    const Scene& scene = m_session.scene();
    const auto isPin = [&](int body) {
        return body >= 0 && scene.bodies[std::size_t(body)].kind == BodyKind::Pin;
    };
    for (const Collision& c : m_session.timeline().collisions())
        if (isPin(c.first) || isPin(c.second)) {
            m_impact = Impact{c.time - beforeImpact, c.time + afterImpact};
            return;
        }
}

// The clock runs evenly; at a border of the slow part the rest of it counts at the other rate.
double Playhead::later(double seconds) const {
    if (!m_slowAtImpact || !m_impact || m_rate <= impactRate)
        return m_time + seconds * m_rate;
    double time = m_time;
    const auto upTo = [&](double border, double rate) {
        const double there = std::clamp((border - time) / rate, 0.0, seconds);
        time = there < seconds ? border : time + seconds * rate;
        seconds -= there;
    };
    if (time < m_impact->from)
        upTo(m_impact->from, m_rate);
    if (seconds > 0 && time < m_impact->to)
        upTo(m_impact->to, impactRate);
    return time + seconds * m_rate;
}

// What is thrown is shown to its end.
void Playhead::showWhole() {
    if (!m_session.currentThrow() || m_session.foresight() == Foresight::Whole)
        return;
    const double time = m_time;
    m_session.setForesight(Foresight::Whole);
    goTo(time, m_session.patience());
}

void Playhead::stepFrames(int frames) {
    setPlaying(false);
    setTime(m_time + frames * frame());
}

// The number of the collision before or after, also beyond the present chapter.
std::optional<std::int64_t> Playhead::neighbour(int forward) const {
    const RunPart part = m_session.part();
    const Timeline& timeline = m_session.timeline();
    const auto index = forward > 0 ? timeline.collisionAfter(m_time) : timeline.collisionBefore(m_time);
    std::int64_t number = 0;
    if (m_selected)
        number = *m_selected + forward;
    else if (index)
        number = part.collisionsBefore + std::int64_t(*index) + 1;
    else
        number = part.collisionsBefore + (forward > 0 ? std::int64_t(timeline.collisions().size()) + 1 : 0);
    return number >= 1 && number <= part.collisionCount ? std::optional(number) : std::nullopt;
}

bool Playhead::canStepCollisions(int forward) const {
    return neighbour(forward).has_value();
}

void Playhead::stepCollisions(int forward) {
    if (const auto number = neighbour(forward))
        selectNumber(*number);
}

void Playhead::select(std::size_t collision) {
    if (collision < m_session.timeline().collisions().size())
        selectNumber(m_session.part().collisionsBefore + std::int64_t(collision) + 1);
}

void Playhead::selectNumber(std::int64_t number) {
    const RunPart part = m_session.part();
    if (number < 1 || (part.ended && number > part.collisionCount))
        return;
    setPlaying(false);
    open(number, m_selected == number ? m_stage : Stage::Contact, m_session.patience());
}

void Playhead::open(std::int64_t number, Stage stage, int patience) {
    m_wish.reset();
    auto chapter = m_session.chapter(number, patience);
    if (!chapter) {
        m_wish = number;
        m_wishedStage = stage;
        return;
    }
    const bool changed = m_selected != number;
    m_selected = number;
    const auto index = std::size_t(number - chapter->collisionsBefore - 1);
    const double time = std::min(chapter->timeline.collisions()[index].time, end());
    put(std::move(chapter), time);
    setStage(stage);
    if (changed)
        emit selectionChanged();
}

void Playhead::selectBeyond(int body) {
    const RunPart part = m_session.part();
    const std::int64_t next =
        part.collisionsBefore + std::int64_t(m_session.timeline().collisions().size()) + 1;
    const auto chapter = part.last ? nullptr : m_session.chapter(next);
    if (!chapter)
        return;
    const auto all = chapter->timeline.collisions();
    const auto found =
        std::find_if(all.begin(), all.end(), [body](const Collision& c) { return c.involves(body); });
    if (found != all.end())
        selectNumber(next + (found - all.begin()));
}

void Playhead::clearSelection() {
    if (!m_selected)
        return;
    m_selected.reset();
    emit selectionChanged();
}

void Playhead::setStage(Stage stage) {
    if (stage == m_stage)
        return;
    m_stage = stage;
    emit stageChanged(stage);
}

void Playhead::stepStage(int forward) {
    setStage(Stage(std::clamp(int(m_stage) + forward, 0, stageCount - 1)));
}

void Playhead::runUntil(double until) {
    const double time = m_time;
    const auto number = m_selected;
    const Stage stage = m_stage;
    if (until == m_session.until() || m_session.setUntil(until))
        return;
    if (number && time <= end())
        open(*number, stage, m_session.patience());
    else
        setTime(time);
}

// Never further than is computed: where that is slow, the clock waits.
void Playhead::advance(double seconds) {
    m_clock.restart();
    const double time = std::clamp(later(seconds), 0.0, std::min(end(), m_session.reach()));
    if (auto chapter = m_session.chapter(time, int(m_timer.interval())))
        put(std::move(chapter), time);
    m_session.expectTime(m_session.part().to);
    if (m_time >= end())
        setPlaying(false);
}

// A wish is asked for without waiting: whoever wished it has gone on.
void Playhead::followProgress() {
    const RunPart part = m_session.part();
    if (m_time > end())
        goTo(end(), m_session.patience());
    const auto wish = std::exchange(m_wish, std::nullopt);
    if (!wish)
        return;
    if (const auto* number = std::get_if<std::int64_t>(&*wish)) {
        if (*number <= part.collisionCount)
            open(*number, m_wishedStage, 0);
        else if (!part.ended)
            m_wish = wish;
    } else if (part.ended || std::get<double>(*wish) <= m_session.reach()) {
        goTo(std::get<double>(*wish), 0);
    } else {
        m_wish = wish;
    }
}

void Playhead::startAgain() {
    findImpact();
    m_wish.reset();
    setPlaying(false);
    m_selected.reset();
    m_stage = Stage::Contact;
    m_time = 0;
    emit selectionChanged();
    emit stageChanged(m_stage);
    emit timeChanged(m_time);
}

} // namespace thetalane

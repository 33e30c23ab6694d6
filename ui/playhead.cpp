#include "ui/playhead.h"

#include "ui/session.h"

#include <algorithm>

namespace thetalane {

Playhead::Playhead(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(16);
    connect(&m_timer, &QTimer::timeout, this, [this] { advance(double(m_clock.nsecsElapsed()) * 1e-9); });
    connect(&session, &Session::runChanged, this, &Playhead::startAgain);
}

double Playhead::end() const {
    return m_session.shownUntil();
}

void Playhead::setTime(double time) {
    clearSelection();
    moveTo(time);
}

void Playhead::setPlaying(bool on) {
    if (on == playing())
        return;
    if (on) {
        clearSelection();
        if (m_time >= end())
            moveTo(0);
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

void Playhead::stepFrames(int frames) {
    setPlaying(false);
    setTime(m_time + frames * frame());
}

void Playhead::stepCollisions(int forward) {
    const Timeline& timeline = m_session.timeline();
    std::optional<std::size_t> target;
    if (m_selected && forward > 0)
        target =
            *m_selected + 1 < timeline.collisions().size() ? std::optional(*m_selected + 1) : std::nullopt;
    else if (m_selected)
        target = *m_selected > 0 ? std::optional(*m_selected - 1) : std::nullopt;
    else
        target = forward > 0 ? timeline.collisionAfter(m_time) : timeline.collisionBefore(m_time);
    if (target)
        select(*target);
}

void Playhead::select(std::size_t collision) {
    const auto collisions = m_session.timeline().collisions();
    if (collision >= collisions.size())
        return;
    setPlaying(false);
    const bool changed = m_selected != collision;
    m_selected = collision;
    moveTo(collisions[collision].time);
    if (!changed)
        return;
    setStage(Stage::Contact);
    emit selectionChanged();
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

void Playhead::advance(double seconds) {
    m_clock.restart();
    moveTo(m_time + seconds * m_rate);
    if (m_time >= end())
        setPlaying(false);
}

void Playhead::moveTo(double time) {
    time = std::clamp(time, 0.0, end());
    if (time == m_time)
        return;
    m_time = time;
    emit timeChanged(time);
}

void Playhead::startAgain() {
    setPlaying(false);
    m_selected.reset();
    m_stage = Stage::Contact;
    m_time = 0;
    emit selectionChanged();
    emit stageChanged(m_stage);
    emit timeChanged(m_time);
}

} // namespace thetalane

#include "ui/lessons/lesson_player.h"

#include "core/study/just_before.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr int stagePace = 900;      // [ms] the arrows take a third of it to move
constexpr double travelSeconds = 2; // about so long from stop to stop

// The rate at which so much of the run takes about `travelSeconds`.
double rateFor(double span) {
    const auto farFrom = [span](double rate) { return std::abs(std::log(span / rate / travelSeconds)); };
    return *std::min_element(Playhead::rates.begin(), Playhead::rates.end(),
                             [&](double a, double b) { return farFrom(a) < farFrom(b); });
}

// How much of a run is kept is the session's business.
bool isSame(EngineSettings a, const EngineSettings& b) {
    a.maxCollisions = b.maxCollisions;
    return a == b;
}

} // namespace

LessonPlayer::LessonPlayer(const Context& context, QObject* parent)
    : QObject(parent)
    , m_context(context) {
    m_stages.setInterval(stagePace);
    connect(&m_stages, &QTimer::timeout, this, &LessonPlayer::stepToStage);
    connect(&context.session, &Session::runChanged, this, &LessonPlayer::watchRun);
    connect(&context.playhead, &Playhead::timeChanged, this, [this](double time) {
        if (m_travelling && time >= timeOf(*stop()))
            arrive(true);
    });
    // Somebody stopped on the way: there they stay, until the next page is asked for.
    connect(&context.playhead, &Playhead::playingChanged, this, [this](bool playing) {
        if (!playing && m_travelling && m_context.playhead.time() < timeOf(*stop()))
            stopTravelling();
    });
}

int LessonPlayer::pageCount() const {
    return running() ? int(m_lesson->stops.size()) + (m_lesson->question ? 1 : 0) : 0;
}

int LessonPlayer::questionPage() const {
    return running() && m_lesson->question ? int(m_lesson->question->before) : -1;
}

const LessonStop* LessonPlayer::stop() const {
    if (!running() || isQuestion())
        return nullptr;
    const bool behind = questionPage() >= 0 && m_page > questionPage();
    return &m_lesson->stops[std::size_t(m_page - (behind ? 1 : 0))];
}

const LessonSetting& LessonPlayer::settingOf(int page) const {
    const int question = questionPage();
    if (page == question)
        return m_lesson->settings[m_lesson->question->setting];
    const bool behind = question >= 0 && page > question;
    return m_lesson->settings[m_lesson->stops[std::size_t(page - (behind ? 1 : 0))].setting];
}

void LessonPlayer::start(const Lesson& lesson) {
    if (!running())
        m_engineBefore = m_context.session.run()->settings;
    stopTravelling();
    m_lesson = lesson;
    m_page = 0;
    emit started();
    open(0, true);
}

void LessonPlayer::leave() {
    if (!running())
        return;
    stopTravelling();
    m_context.playhead.setPlaying(false);
    m_lesson.reset();
    m_changed = false;
    if (!isSame(m_context.session.run()->settings, m_engineBefore)) {
        m_engineBefore.until = m_context.session.until();
        m_context.session.setEngine(m_engineBefore);
    }
    emit left();
}

void LessonPlayer::next() {
    if (!running())
        return;
    if (travelling())
        return arrive(m_travelling);
    if (m_page + 1 < pageCount())
        open(m_page + 1, true);
}

void LessonPlayer::back() {
    if (running() && m_page > 0)
        open(m_page - 1, false);
}

void LessonPlayer::goTo(int page) {
    if (running() && page >= 0 && page < pageCount())
        open(page, false);
}

void LessonPlayer::putBack() {
    goTo(m_page);
}

void LessonPlayer::open(int page, bool byPlaying) {
    stopTravelling();
    m_context.playhead.setPlaying(false);
    m_page = page;
    bring(settingOf(page));
    emit pageChanged();
    if (isQuestion())
        return holdAtQuestion();
    const LessonStop& there = *stop();
    if (there.show != LessonShow::Nothing)
        emit showRequested(there.show);
    if (byPlaying && !m_context.appearance.reducedMotion())
        travel(there);
    else
        arrive(false);
}

void LessonPlayer::bring(const LessonSetting& setting) {
    m_bringing = true;
    Session& session = m_context.session;
    if (!(session.scene() == setting.scene)) {
        if (setting.sceneId.empty())
            session.open(setting.scene);
        else
            session.openBuiltin(QString::fromStdString(setting.sceneId));
    }
    putEngine(setting.engine);
    m_bringing = false;
    watchRun();
}

void LessonPlayer::putEngine(const EngineSettings& engine) {
    if (!isSame(m_context.session.run()->settings, engine))
        m_context.session.setEngine(engine);
}

void LessonPlayer::watchRun() {
    if (!running() || m_bringing)
        return;
    const LessonSetting& setting = settingOf(m_page);
    const bool differs = !(m_context.session.scene() == setting.scene) ||
                         !isSame(m_context.session.run()->settings, setting.engine);
    if (differs == m_changed)
        return;
    if (differs)
        stopTravelling();
    m_changed = differs;
    emit changed(differs);
}

// Before that which is asked about has happened, so that nothing on the lane tells it.
void LessonPlayer::holdAtQuestion() {
    const LessonQuestion& q = *m_lesson->question;
    std::int64_t collision = q.kind == QuestionKind::Choice ? 0 : q.quantity.collision;
    if (q.kind == QuestionKind::Choice)
        for (const std::size_t near : {q.before, q.before - 1}) // of the one before, if it is of this scene
            if (near < m_lesson->stops.size() && m_lesson->stops[near].setting == q.setting &&
                m_lesson->stops[near].at == StopAt::Collision)
                collision = m_lesson->stops[near].collision;
    const Timeline& timeline = m_context.session.timeline();
    const bool known = collision >= 1 && collision <= std::int64_t(timeline.collisions().size());
    m_context.playhead.setTime(known ? justBefore(timeline, std::size_t(collision - 1)) : 0);
    emit arrived();
}

double LessonPlayer::timeOf(const LessonStop& there) const {
    if (there.at == StopAt::Start)
        return 0;
    double time = there.time;
    if (there.at == StopAt::Collision) {
        const auto collisions = m_context.session.timeline().collisions();
        const auto index = std::size_t(there.collision - 1);
        time = index < collisions.size() ? collisions[index].time : m_context.playhead.end();
    }
    return std::min(time, m_context.playhead.end());
}

void LessonPlayer::travel(const LessonStop& there) {
    Playhead& playhead = m_context.playhead;
    const double span = timeOf(there) - playhead.time();
    if (!(span > 0))
        return arrive(there.at == StopAt::Collision && playhead.selectedNumber() == there.collision);
    m_rateBefore = playhead.rate();
    playhead.setRate(rateFor(span));
    m_travelling = true;
    playhead.setPlaying(true);
}

// There, and to its stage: at once, or through the stages before it.
void LessonPlayer::arrive(bool stageByStage) {
    const LessonStop* there = stop();
    if (!there)
        return;
    Playhead& playhead = m_context.playhead;
    const double time = timeOf(*there);
    stopTravelling();
    playhead.setPlaying(false);
    if (there->at != StopAt::Collision) {
        playhead.setTime(time);
    } else {
        const bool isOpen = playhead.selectedNumber() == there->collision;
        playhead.selectNumber(there->collision);
        if (stageByStage && playhead.selected() && int(playhead.stage()) != there->stage) {
            m_stages.start();
            if (isOpen)
                stepToStage();
            return;
        }
        playhead.setStage(Stage(there->stage));
    }
    emit arrived();
}

void LessonPlayer::stepToStage() {
    const LessonStop* there = stop();
    Playhead& playhead = m_context.playhead;
    if (!there || m_changed || playhead.selectedNumber() != there->collision) {
        m_stages.stop();
        return;
    }
    const int way = there->stage - int(playhead.stage());
    playhead.stepStage(way > 0 ? 1 : way < 0 ? -1 : 0);
    if (int(playhead.stage()) == there->stage) {
        m_stages.stop();
        emit arrived();
    }
}

void LessonPlayer::stopTravelling() {
    m_stages.stop();
    if (!m_travelling)
        return;
    m_travelling = false;
    m_context.playhead.setRate(m_rateBefore);
}

} // namespace thetalane

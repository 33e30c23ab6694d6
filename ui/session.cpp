#include "ui/session.h"

#include "core/scene/builtin.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thetalane {
namespace {

constexpr int lookEvery = 50; // [ms] slower than the screen, faster than a glance

// What refuses settings refuses them whatever the scene.
std::optional<Refusal> refusalOf(EngineSettings settings) {
    Scene still;
    still.bodies = {{"A", BodyKind::Ball, 1, 1, {}, {}}};
    settings.kind = EngineKind::Event;
    const auto outcome = simulate(std::move(still), settings);
    const auto* refusal = std::get_if<Refusal>(&outcome);
    return refusal ? std::optional(*refusal) : std::nullopt;
}

} // namespace

Session::Session(QObject* parent)
    : Session(Limits{}, parent) {}

Session::Session(const Limits& limits, QObject* parent)
    : QObject(parent)
    , m_limits(limits) {
    m_settings.maxCollisions = limits.mostInChapters;
    m_look.setInterval(lookEvery);
    connect(&m_look, &QTimer::timeout, this, &Session::takeProgress);
    openBuiltin("two-balls");
}

RunPart Session::part() const {
    return {m_chapter->from,       m_chapter->to,         m_chapter->collisionsBefore, m_chapter->last,
            m_progress.collisions, m_progress.computedTo, m_progress.end.has_value()};
}

std::vector<SceneError> Session::setScene(const Scene& scene) {
    auto errors = validate(scene);
    if (errors.empty())
        edit({scene, {}, scene.lane ? currentThrow() : std::nullopt, standing()});
    return errors;
}

LaneConditions Session::laneConditions() const {
    return {scene().restitution, scene().friction};
}

std::vector<SceneError> Session::setThrow(const Throw& ballThrow, double restitution) {
    if (currentThrow())
        return setDelivery(ballThrow, standing(), {restitution, scene().friction});
    return setDelivery(ballThrow, allPins, {restitution, houseFriction()});
}

std::vector<SceneError> Session::setDelivery(const Throw& ballThrow, const PinSet& standing,
                                             const LaneConditions& lane) {
    const Scene scene = bowlingScene(ballThrow, lane.restitution, lane.friction, standing);
    auto errors = validate(scene);
    if (errors.empty())
        edit({scene, "bowling", ballThrow, standing});
    return errors;
}

void Session::edit(Subject subject) {
    const Subject before = std::exchange(m_subject, std::move(subject));
    begin();
    emit edited(before);
}

void Session::restore(const Subject& subject) {
    m_subject = subject;
    begin();
}

void Session::setForesight(Foresight foresight) {
    m_wishedForesight = foresight;
    foresee();
}

void Session::holdForesight(std::optional<Foresight> foresight) {
    m_heldForesight = foresight;
    foresee();
}

void Session::foresee() {
    const Foresight foresight = m_heldForesight.value_or(m_wishedForesight);
    if (foresight == m_foresight)
        return;
    m_foresight = foresight;
    if (currentThrow())
        begin();
}

std::optional<Refusal> Session::setEngine(const EngineSettings& asked) {
    EngineSettings settings = asked;
    const bool inChapters = settings.kind == EngineKind::Event;
    settings.maxCollisions = inChapters ? m_limits.mostInChapters : m_limits.mostWhole;
    if (inChapters) {
        if (const auto refusal = refusalOf(settings))
            return refusal;
        m_settings = settings;
        begin();
        return std::nullopt;
    }
    auto outcome = simulate(scene(), settings);
    if (const auto* refusal = std::get_if<Refusal>(&outcome))
        return *refusal;
    m_settings = settings;
    adopt(std::get<Run>(std::move(outcome)));
    return std::nullopt;
}

std::optional<Refusal> Session::setUntil(double until) {
    EngineSettings settings = m_settings;
    settings.until = until;
    return settings == m_settings ? std::nullopt : setEngine(settings);
}

bool Session::isLimitedByUntil() const {
    if (!m_progress.end)
        return true;
    return m_progress.end == EndReason::Until && m_progress.collisions > 0 && !scene().lane;
}

bool Session::openBuiltin(const QString& id) {
    auto scene = builtinScene(id.toStdString());
    if (!scene)
        return false;
    const bool isThrow = scene->lane.has_value();
    start({*std::move(scene), id, isThrow ? std::optional(Throw{}) : std::nullopt});
    return true;
}

std::vector<SceneError> Session::open(const Scene& scene) {
    auto errors = validate(scene);
    if (errors.empty())
        start({scene, {}});
    return errors;
}

std::vector<SceneError> Session::openDelivery(const Throw& ballThrow, const PinSet& standing,
                                              const LaneConditions& lane) {
    Scene scene = bowlingScene(ballThrow, lane.restitution, lane.friction, standing);
    auto errors = validate(scene);
    if (errors.empty())
        start({std::move(scene), "bowling", ballThrow, standing});
    return errors;
}

void Session::start(Subject subject) {
    m_opened = std::move(subject);
    m_settings.until = EngineSettings{}.until; // ten minutes were asked for of another scene
    reset();
}

void Session::reset() {
    m_subject = m_opened;
    begin();
    emit opened();
}

// The first chapter at once: of most scenes it is the whole run. The rest in its own time.
void Session::begin() {
    m_ahead.reset(); // it would only be in the way
    EngineSettings settings = m_settings;
    if (currentThrow() && m_foresight == Foresight::FirstContact)
        settings.maxCollisions = 1;
    if (settings.kind != EngineKind::Event)
        return adopt(std::get<Run>(simulate(m_subject.scene, settings)));
    auto run = std::make_unique<LongRun>(m_subject.scene, settings, m_limits.chapters);
    run->goOn();
    auto first = run->chapterAt(0);
    if (run->ended())
        run.reset();
    adoptFirst(std::move(first), std::move(run));
}

void Session::adopt(Run whole) {
    auto chapter = std::make_shared<Chapter>();
    static_cast<Run&>(*chapter) = std::move(whole);
    chapter->to = chapter->timeline.endTime();
    chapter->last = true;
    adoptFirst(std::move(chapter), nullptr);
}

void Session::adoptFirst(std::shared_ptr<const Chapter> chapter, std::unique_ptr<LongRun> rest) {
    m_ahead.reset();
    m_awaited = false;
    m_chapter = std::move(chapter);
    if (rest) {
        m_ahead = std::make_unique<RunAhead>(std::move(rest));
        m_progress = m_ahead->progress();
        m_look.start();
    } else {
        const Timeline& all = timeline();
        const auto collisions = all.collisions();
        m_progress = {all.endTime(), all.collisionCount(), all.endReason(),
                      collisions.empty() ? 0 : collisions.back().time};
        m_look.stop();
    }
    m_shownUntil = worthShowing();
    emit runChanged(m_chapter);
}

double Session::worthShowing() const {
    constexpr double afterLast = 1.5;
    constexpr double withoutAny = 4;
    if (!m_progress.end)
        return m_settings.until;
    const double end = m_progress.computedTo;
    if (m_progress.collisions == 0)
        return std::min(end, withoutAny);
    const bool goesOn = m_progress.end == EndReason::Until && !scene().lane;
    return goesOn ? end : std::min(end, m_progress.lastCollision + afterLast);
}

double Session::reach() const {
    return m_progress.end ? m_shownUntil : std::nextafter(m_progress.computedTo, 0.0);
}

std::shared_ptr<const Chapter> Session::chapter(const RunAhead::Place& place, int patience) {
    const double* time = std::get_if<double>(&place);
    if (time ? m_chapter->holdsTime(*time) : m_chapter->holdsCollision(std::get<std::int64_t>(place)))
        return m_chapter;
    if (!m_ahead)
        return nullptr;
    auto found = m_ahead->chapter(place, patience);
    if (!found) {
        m_awaited = true;
        m_look.start();
    }
    return found;
}

void Session::showChapter(std::shared_ptr<const Chapter> chapter) {
    if (chapter == m_chapter)
        return;
    m_chapter = std::move(chapter);
    emit chapterChanged(m_chapter);
}

void Session::expectTime(double time) {
    if (m_ahead && !m_chapter->holdsTime(time))
        m_ahead->expect(time);
}

void Session::waitFor(const RunAhead::Place& place) {
    if (!m_ahead)
        return;
    m_ahead->waitFor(place);
    takeProgress();
}

void Session::takeProgress() {
    m_progress = m_ahead->progress();
    m_shownUntil = worthShowing();
    m_awaited = false; // whoever waits asks again
    emit progressed();
    if (m_ahead && m_progress.end && !m_awaited)
        m_look.stop();
}

} // namespace thetalane

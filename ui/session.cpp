#include "ui/session.h"

#include "core/scene/builtin.h"

#include <algorithm>

namespace thetalane {
namespace {

// What a window keeps at the most: every collision with all its steps, about 60 MB. A class does not look at
// more.
constexpr std::int64_t mostCollisions = 125'000;

double worthShowing(const Run& run) {
    constexpr double afterLast = 1.5;
    constexpr double withoutAny = 4;
    const Timeline& timeline = run.timeline;
    if (timeline.collisions().empty())
        return std::min(timeline.endTime(), withoutAny);
    const bool goesOn = timeline.endReason() == EndReason::Until && !run.scene.lane;
    return goesOn ? timeline.endTime()
                  : std::min(timeline.endTime(), timeline.collisions().back().time + afterLast);
}

} // namespace

Session::Session(QObject* parent)
    : QObject(parent) {
    m_settings.maxCollisions = mostCollisions;
    openBuiltin("two-balls");
}

std::vector<SceneError> Session::setScene(const Scene& scene) {
    auto errors = validate(scene);
    if (!errors.empty())
        return errors;
    m_sceneId.clear();
    if (!scene.lane)
        m_throw.reset();
    adopt(std::get<Run>(simulate(scene, m_settings)));
    return {};
}

std::vector<SceneError> Session::setThrow(const Throw& ballThrow, double restitution) {
    const Scene scene = bowlingScene(ballThrow, restitution);
    auto errors = validate(scene);
    if (!errors.empty())
        return errors;
    m_sceneId = "bowling";
    m_throw = ballThrow;
    adopt(std::get<Run>(simulate(scene, m_settings)));
    return {};
}

std::optional<Refusal> Session::setEngine(const EngineSettings& settings) {
    auto outcome = simulate(m_run->scene, settings);
    if (const auto* refusal = std::get_if<Refusal>(&outcome))
        return *refusal;
    m_settings = settings;
    adopt(std::get<Run>(std::move(outcome)));
    return std::nullopt;
}

bool Session::openBuiltin(const QString& id) {
    auto scene = builtinScene(id.toStdString());
    if (!scene)
        return false;
    const bool isThrow = scene->lane.has_value();
    start(*std::move(scene), id, isThrow ? std::optional(Throw{}) : std::nullopt);
    return true;
}

std::vector<SceneError> Session::open(const Scene& scene) {
    auto errors = validate(scene);
    if (errors.empty())
        start(scene, QString(), std::nullopt);
    return errors;
}

void Session::start(Scene scene, const QString& id, std::optional<Throw> ballThrow) {
    m_opened = std::move(scene);
    m_openedId = id;
    m_openedThrow = ballThrow;
    reset();
}

void Session::reset() {
    m_sceneId = m_openedId;
    m_throw = m_openedThrow;
    adopt(std::get<Run>(simulate(m_opened, m_settings)));
}

void Session::adopt(Run run) {
    m_run = std::make_shared<const Run>(std::move(run));
    m_shownUntil = worthShowing(*m_run);
    emit runChanged(m_run);
}

} // namespace thetalane

#include "core/study/truth.h"

#include "core/engine/engine_in_steps.h"
#include "core/study/measure_cost.h"

#include <algorithm>
#include <chrono>

namespace thetalane {
namespace {

constexpr std::int64_t mostCollisions = 100'000; // that a truth keeps in memory

class Clock {
public:
    double seconds() const { return std::chrono::duration<double>(Time::now() - m_start).count(); }

private:
    using Time = std::chrono::steady_clock;
    Time::time_point m_start = Time::now();
};

std::unique_ptr<EngineInSteps> start(const Scene& scene, const EngineSettings& settings) {
    return settings.precision == Precision::Quad ? startNextEventQuad(scene, settings)
                                                 : startNextEvent(scene, settings);
}

} // namespace

Truth truthWithin(const StudyCases& cases, const Method& method, double patience, std::stop_token stop) {
    Truth truth{method, cases.until, nullptr};
    if (cases.scenes.front().bodies.size() > mostBodiesInQuad)
        truth.method.settings.precision = Precision::Double;
    const Clock clock;
    Scene scene = sceneFor(truth.method, cases.scenes.front());
    EngineSettings settings = settingsFor(truth.method, cases.until);
    const auto engine = start(scene, settings);
    std::optional<EndReason> end;
    do
        end = engine->goOn(16, mostCollisions);
    while (!end && engine->collisionCount() < mostCollisions && clock.seconds() < patience &&
           !stop.stop_requested());
    const double next = engine->nextContact();
    Timeline timeline = engine->finish();
    // Between the last contact and the one it paused before, so that nobody has to decide about either.
    if (!end || *end == EndReason::MaxCollisions)
        truth.until = (timeline.collisions().back().time + next) / 2;
    settings.until = truth.until;
    truth.first = std::make_shared<const Run>(Run{std::move(scene), settings, std::move(timeline)});
    return truth;
}

Run truthOf(const Truth& truth, const Scene& scene) {
    return std::get<Run>(runMethod(truth.method, scene, truth.until));
}

double expectedTime(const Method& method, const Scene& scene, double until) {
    if (method.settings.kind == EngineKind::Event) // as the truth, which is dearer, was in time
        return 0;
    constexpr double ofAPair = 3e-9, short_ = 0.02; // s
    const double n = double(scene.bodies.size());
    const double steps = until / method.settings.step;
    if (steps * n * n / 2 * ofAPair < short_)
        return 0;
    const double tried = std::clamp(short_ / (n * n / 2 * ofAPair), 2.0, steps);
    const double begin = threadTime();
    (void)runMethod(method, scene, tried * method.settings.step, false);
    return (threadTime() - begin) * steps / tried;
}

} // namespace thetalane

#include "tests/benchmarks/contestants.h"

#include "tests/benchmarks/timing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace thetalane::benchmarks {
namespace {

std::string atRate(const std::string& name, int stepsPerSecond) {
    return name + ", " + std::to_string(stepsPerSecond) + "/s";
}

int stepCount(double until, int stepsPerSecond) {
    return int(std::lround(until * stepsPerSecond));
}

void playOut(const Scene& scene, const EngineSettings& settings) {
    sink = sink + double(mustRun(scene, settings).collisionCount());
}

// The run, less a run that ends as soon as it has begun.
double ongoingOf(const Scene& scene, const EngineSettings& settings, const EngineSettings& startOnly) {
    const double start = timed([&] { playOut(scene, startOnly); });
    return timed([&] { playOut(scene, settings); }) - start;
}

// At every collision if they are few, else now and then; and where the reference waits.
std::vector<double> momentsOf(const Timeline& timeline, double until, double reference) {
    constexpr std::size_t few = 2000;
    std::vector<double> moments{until};
    if (reference >= 0)
        moments.push_back(reference);
    if (timeline.collisions().size() <= few)
        for (const Collision& c : timeline.collisions())
            moments.push_back(c.time);
    for (int k = 1; k < 32; ++k)
        moments.push_back(until * k / 32);
    std::sort(moments.begin(), moments.end());
    return moments;
}

void replayEvents(const Scene& scene, EngineSettings settings, Judge& judge) {
    settings.keepDetail = true;
    const Timeline timeline = mustRun(scene, settings);
    std::vector<BodyState> states;
    for (const double t : momentsOf(timeline, settings.until, judge.moment())) {
        timeline.stateAt(t, states);
        judge.see(t, states);
    }
    for (const Collision& c : timeline.collisions())
        if (!c.isWall())
            judge.touched(c);
}

void replaySteps(const Scene& scene, const EngineSettings& settings, int steps, Judge& judge) {
    const Timeline timeline = mustRun(scene, settings);
    std::vector<BodyState> states;
    for (int k = 1; k <= steps; ++k) {
        timeline.stateAt(k * settings.step, states);
        judge.see(k * settings.step, states);
    }
}

} // namespace

EngineSettings eventSettings(double until, bool keepDetail, Precision precision) {
    EngineSettings s;
    s.until = until;
    s.precision = precision;
    s.keepDetail = keepDetail;
    s.maxCollisions = 1'000'000'000;
    return s;
}

EngineSettings steppedSettings(double until, int stepsPerSecond) {
    EngineSettings s = eventSettings(until);
    s.kind = EngineKind::Stepped;
    s.step = 1.0 / stepsPerSecond;
    return s;
}

Timeline mustRun(const Scene& scene, const EngineSettings& settings) {
    auto result = simulate(scene, settings);
    if (!std::holds_alternative<Run>(result)) {
        std::fputs("a benchmark's own settings were refused\n", stderr);
        std::exit(1);
    }
    return std::move(std::get<Run>(result).timeline);
}

bool accepts(const Scene& scene, const EngineSettings& settings) {
    EngineSettings s = settings;
    s.maxCollisions = 1;
    s.until = std::min(s.until, s.step);
    return std::holds_alternative<Run>(simulate(scene, s));
}

Entry eventEntry(std::string name, const EngineSettings& settings) {
    EngineSettings startOnly = settings;
    startOnly.maxCollisions = 1;
    return {std::move(name), [settings](const Scene& s) { playOut(s, settings); },
            [settings, startOnly](const Scene& s) { return ongoingOf(s, settings, startOnly); },
            [settings](const Scene& s, Judge& judge) { replayEvents(s, settings, judge); }};
}

Entry steppedEntry(double until, int stepsPerSecond) {
    const EngineSettings settings = steppedSettings(until, stepsPerSecond);
    EngineSettings startOnly = settings;
    startOnly.until = settings.step / 2;
    const int steps = stepCount(until, stepsPerSecond);
    return {atRate("the paper's loop", stepsPerSecond), [settings](const Scene& s) { playOut(s, settings); },
            [settings, startOnly](const Scene& s) { return ongoingOf(s, settings, startOnly); },
            [settings, steps](const Scene& s, Judge& judge) { replaySteps(s, settings, steps, judge); }};
}

Entry worldEntry(const WorldKind& kind, double until, int stepsPerSecond) {
    const double h = 1.0 / stepsPerSecond;
    const int steps = stepCount(until, stepsPerSecond);
    const auto make = kind.make;
    const auto stepAll = [steps](World& world) {
        for (int k = 0; k < steps; ++k)
            world.step();
    };
    const auto play = [make, h, stepAll](const Scene& scene) {
        const auto world = make(scene, h);
        stepAll(*world);
        std::vector<BodyState> states;
        world->read(states);
        sink = sink + states[0].position.x;
    };
    // Its first step finds who is near whom.
    const auto ongoing = [make, h, stepAll](const Scene& scene) {
        const auto world = make(scene, h);
        world->step();
        return timed([&] { stepAll(*world); });
    };
    const auto replay = [make, h, steps](const Scene& scene, Judge& judge) {
        const auto world = make(scene, h);
        std::vector<BodyState> states;
        for (int k = 1; k <= steps; ++k) {
            world->step();
            world->read(states);
            judge.see(k * h, states);
        }
    };
    return {atRate(kind.name, stepsPerSecond), play, ongoing, replay};
}

} // namespace thetalane::benchmarks

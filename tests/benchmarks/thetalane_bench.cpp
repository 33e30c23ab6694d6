// thetalane_bench [--quick]: how long things take on this machine, as a Markdown table. It asserts nothing
// about time; ctest runs it with --quick, only to see that it works. What is compared is measured in turn,
// one repetition of each after another, so that a busy machine slows all of them alike.
#include "core/engine/engine.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "tests/benchmarks/prediction_cases.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

using namespace thetalane;

namespace {

// One repetition does `units` pieces of work; the table gives the time of one.
struct Case {
    std::string name;
    std::string unit;
    double units = 1;
    std::function<void()> once;
    std::vector<double> seconds{};
};

volatile double sink = 0; // keeps the work from being optimised away

Timeline mustRun(Scene scene, const EngineSettings& settings) {
    auto result = simulate(std::move(scene), settings);
    if (!std::holds_alternative<Run>(result)) {
        std::fputs("a benchmark's own settings were refused\n", stderr);
        std::exit(1);
    }
    return std::move(std::get<Run>(result).timeline);
}

EngineSettings settingsFor(double until, Precision precision = Precision::Double) {
    EngineSettings s;
    s.until = until;
    s.precision = precision;
    return s;
}

EngineSettings steppedFor(double until, double step) {
    EngineSettings s = settingsFor(until);
    s.kind = EngineKind::Stepped;
    s.step = step;
    return s;
}

// Eleven discs in a closed box, e = 1: collisions without end.
Scene elevenInABox() {
    Scene scene;
    scene.frame = Frame{-1.0, 1.0, -0.8, 0.8, 1.0};
    for (int i = 0; i < 11; ++i) {
        const double angle = 2.4 * i; // spread over the circle
        scene.bodies.push_back({std::to_string(i),
                                BodyKind::Ball,
                                1 + 0.1 * i,
                                0.08,
                                {-0.75 + 0.5 * (i % 4), -0.5 + 0.5 * double(i / 4)},
                                {3 * std::cos(angle), 3 * std::sin(angle)}});
    }
    return scene;
}

double timeOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string readable(double seconds) {
    char text[32];
    const double scale = seconds < 1e-6 ? 1e9 : seconds < 1e-3 ? 1e6 : 1e3;
    std::snprintf(text, sizeof text, "%.3g %s", seconds * scale,
                  scale == 1e9   ? "ns"
                  : scale == 1e6 ? "µs"
                                 : "ms");
    return text;
}

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
    return v[v.size() / 2];
}

// A throw, its scene made each time, `times` over.
Case throwCase(std::string name, int times, Scene (*make)(), EngineSettings settings) {
    return {std::move(name), "throw", double(times), [=] {
                for (int k = 0; k < times; ++k)
                    sink = sink + double(mustRun(make(), settings).collisionCount());
            }};
}

Scene rack() {
    return rackScene(0.0676, 0.0, 6.8);
}
Scene lane() {
    return bowlingScene(Throw{});
}

std::vector<Case> throwCases(int times) {
    EngineSettings summary = settingsFor(1);
    summary.keepDetail = false;
    return {
        throwCase("rack, 1 s, event, double", times, rack, settingsFor(1)),
        throwCase("rack, 1 s, event, double, summary only", times, rack, summary),
        throwCase("rack, 1 s, event, float", times, rack, settingsFor(1, Precision::Float)),
        throwCase("rack, 1 s, event, quad", std::max(1, times / 50), rack, settingsFor(1, Precision::Quad)),
        throwCase("rack, 1 s, stepped 1/60 s", times, rack, steppedFor(1, 1.0 / 60)),
        throwCase("rack, 1 s, stepped 1/1000 s", std::max(1, times / 10), rack, steppedFor(1, 1.0 / 1000)),
        throwCase("whole lane, 10 s, event, double", times, lane, settingsFor(10)),
    };
}

// What `timeline` is shared by must outlive the cases.
Case seekCase(const Timeline& timeline) {
    return {"seek at random over " + std::to_string(timeline.collisionCount()) + " collisions, 11 discs",
            "seek", 1000, [&timeline] {
                std::uint32_t random = 1;
                std::vector<BodyState> states;
                for (int k = 0; k < 1000; ++k) {
                    random = random * 1664525u + 1013904223u;
                    timeline.stateAt(timeline.endTime() * random / 4294967296.0, states);
                    sink = sink + states[0].position.x;
                }
            }};
}

Case boxCase(const char* name, double until, bool keepDetail) {
    EngineSettings settings = settingsFor(until);
    settings.keepDetail = keepDetail;
    const double events = double(mustRun(elevenInABox(), settings).collisionCount());
    return {name, "event", events,
            [settings] { sink = sink + double(mustRun(elevenInABox(), settings).collisionCount()); }};
}

// Time of impact of one pair.
Case predictionCase(const char* name, testing::ImpactCase (*make)(testing::Random&)) {
    return {name, "prediction", 4096,
            [cases = benchmarks::manyCases(make)] { sink = sink + benchmarks::sumOfTimes(cases); }};
}

void addPredictions(std::vector<Case>& cases) {
    cases.push_back(predictionCase("time of impact, free pins", benchmarks::freeCase));
    cases.push_back(predictionCase("time of impact, pins sliding to rest", benchmarks::pinsCase));
    cases.push_back(predictionCase("time of impact, generic (half are aimed)", testing::genericCase));
}

void printRejections() {
    std::printf("of the pairs that never meet, bounds alone turn away: pins %.1f %%, generic %.1f %%\n",
                100 * benchmarks::rejectedShare(benchmarks::manyCases(benchmarks::pinsCase)),
                100 * benchmarks::rejectedShare(benchmarks::manyCases(testing::genericCase)));
}

void print(const std::vector<Case>& cases) {
    std::puts("| what | min | median | of one | against the first |");
    std::puts("|---|---:|---:|---|---:|");
    const double first = median(cases.front().seconds) / cases.front().units;
    for (const Case& c : cases) {
        const double least = *std::min_element(c.seconds.begin(), c.seconds.end()) / c.units;
        const double middle = median(c.seconds) / c.units;
        std::printf("| %s | %s | %s | %s | %.3g |\n", c.name.c_str(), readable(least).c_str(),
                    readable(middle).c_str(), c.unit.c_str(), middle / first);
    }
}

} // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    if (argc > 1 && !quick) {
        std::fputs("usage: thetalane_bench [--quick]\n", stderr);
        return 2;
    }
    const int repetitions = quick ? 1 : 15;
    EngineSettings longRun = settingsFor(1e6);
    longRun.maxCollisions = 10'000;
    const Timeline seekable = mustRun(elevenInABox(), longRun);

    std::vector<Case> cases = throwCases(quick ? 10 : 500);
    cases.push_back(boxCase("eleven discs in a box, event, double", quick ? 1 : 100, true));
    cases.push_back(boxCase("eleven discs in a box, summary only", quick ? 1 : 100, false));
    addPredictions(cases);
    cases.push_back(seekCase(seekable));
    for (int r = 0; r < repetitions; ++r)
        for (Case& c : cases)
            c.seconds.push_back(timeOf(c.once));
    print(cases);
    const double thousand = median(cases.back().seconds);
    std::printf("\n1,000 random seeks over %lld collisions: %s\n",
                static_cast<long long>(seekable.collisionCount()), readable(thousand).c_str());
    printRejections();
    return 0;
}

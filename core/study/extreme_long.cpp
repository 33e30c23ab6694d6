// Many collisions: what rounding has done by then.
#include "core/scene/crowd_scenes.h"
#include "core/study/extreme_rows.h"

#include <algorithm>
#include <cmath>

namespace thetalane::extremes {
namespace {

// In the open any number of discs has finitely many collisions: a crowd so large that it comes to as many
// before it has dispersed.
Scene openCrowd(int count) {
    Scene scene = gasScene(count);
    scene.frame.reset();
    for (Body& b : scene.bodies) // inwards at first
        b.velocity = b.velocity - 2.0 * b.position;
    return scene;
}

Timeline summaryOf(const Scene& scene, std::int64_t collisions) {
    EngineSettings settings;
    settings.until = 1e9;
    settings.maxCollisions = collisions;
    settings.keepDetail = false;
    return runOf(scene, settings);
}

void longRun(Results& out, ExtremeCase kase, const Scene& scene, std::int64_t collisions) {
    const Timeline timeline = summaryOf(scene, collisions);
    const Totals before = totals(scene, startOf(scene));
    const auto states = timeline.stateAt(timeline.endTime());
    const Totals after = totals(scene, states);
    const auto add = [&](ExtremeMeasure asked, double exact, double got, double error, double bound) {
        out.push_back(
            {ExtremeRow::LongRun, kase, double(collisions), asked, exact, got, std::abs(error), bound});
    };
    const double count = double(timeline.collisionCount());
    add(ExtremeMeasure::Collisions, double(collisions), count, count - double(collisions), 0);
    const double drift = (after.energy - before.energy) / before.energy;
    add(ExtremeMeasure::EnergyDrift, 0, drift, drift, 1e-12);
    if (scene.frame)
        return; // walls take momentum
    double sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum += scene.bodies[i].mass * norm(states[i].velocity);
    const double moved = norm(after.momentum - before.momentum) / sum;
    add(ExtremeMeasure::MomentumDrift, 0, moved, moved, 1e-13);
}

// Three discs in a box: dilute enough that 40 collisions leave digits.
Scene fewInABox() {
    Scene scene =
        sceneOf(1, {ball(1, 1, 0.1, {-0.7, -0.3}, {0.9, 0.31}), ball(2, 2, 0.12, {0.1, 0.2}, {-0.4, 0.5}),
                    ball(3, 1.5, 0.11, {0.6, -0.4}, {-0.7, -0.2})});
    scene.frame = Frame{-1.0, 1.0, -0.7, 0.7, 1};
    return scene;
}

double furthest(const Scene& a, const Scene& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        most = std::max(most, norm(a.bodies[i].position - b.bodies[i].position));
    return most;
}

// The scene as it is at t; reversed: with every velocity turned about.
Scene sceneAt(const Scene& scene, const Timeline& timeline, double t, bool reversed) {
    Scene later = scene;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyState state = timeline.bodyAt(i, t);
        later.bodies[i].position = state.position;
        later.bodies[i].velocity = reversed ? -state.velocity : state.velocity;
    }
    return later;
}

// By how much the scene makes a small disturbance grow until t, in quad precision.
double growth(const Scene& scene, double t) {
    constexpr double small = 1e-15;
    EngineSettings settings;
    settings.until = t;
    settings.precision = Precision::Quad;
    const Scene end = sceneAt(scene, runOf(scene, settings), t, false);
    double most = 1;
    for (std::size_t i = 0; i < 2 * scene.bodies.size(); ++i) {
        Scene disturbed = scene;
        Vec2d& p = disturbed.bodies[i / 2].position;
        double& q = i % 2 ? p.y : p.x;
        const double before = q;
        q += small;
        const double by = q - before;
        most = std::max(most, furthest(end, sceneAt(disturbed, runOf(disturbed, settings), t, false)) / by);
    }
    return most;
}

} // namespace

void longRuns(Results& out, bool quick) {
    const std::int64_t collisions = quick ? 100'000 : 10'000'000;
    longRun(out, ExtremeCase::Gas, gasScene(1000), collisions);
    longRun(out, ExtremeCase::OpenCrowd, openCrowd(quick ? 10'000 : 100'000), collisions);
}

// Galperin: 1 kg between a wall and 100^k kg that comes; ⌊10^k π⌋ collisions.
void countingPi(Results& out) {
    constexpr std::int64_t exact[] = {3, 31, 314, 3'141, 31'415, 314'159, 3'141'592};
    Scene scene = countingScene();
    double ratio = 1;
    for (const std::int64_t count : exact) {
        scene.bodies[1].mass = ratio;
        const double got = double(summaryOf(scene, 10'000'000).collisionCount());
        out.push_back({ExtremeRow::CountingPi, ExtremeCase::PiDigits, ratio, ExtremeMeasure::Collisions,
                       double(count), got, std::abs(got - double(count)), 0});
        ratio *= 100;
    }
}

// Bound: the rounding of each collision there and back, 4 ε, grown as any disturbance of the scene grows.
void timeReversal(Results& out) {
    const Scene scene = fewInABox();
    const Timeline whole = runOf(scene, 200);
    for (const std::size_t collisions : {10, 20, 40}) {
        const double t = (whole.collisions()[collisions - 1].time + whole.collisions()[collisions].time) / 2;
        const Scene back = sceneAt(scene, runOf(scene, t), t, true);
        const Scene home = sceneAt(scene, runOf(back, t), t, true);
        const double off = furthest(scene, home);
        out.push_back({ExtremeRow::TimeReversal, ExtremeCase::ThereAndBack, double(collisions),
                       ExtremeMeasure::WayFromStart, 0, off, off,
                       2 * double(collisions) * 4 * epsilon * growth(scene, t)});
    }
}

} // namespace thetalane::extremes

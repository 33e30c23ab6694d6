// Where collisions run together: cascades, contacts that last, and mirror images.
#include "core/scene/bowling_scene.h"
#include "core/study/extreme_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace thetalane::extremes {
namespace {

void add(Results& out, ExtremeRow row, ExtremeCase kase, double value, ExtremeMeasure asked, double exact,
         double got, double error, double bound) {
    out.push_back({row, kase, value, asked, exact, got, error, bound});
}

double deepestOverlap(const Scene& scene, std::span<const BodyState> states) {
    double depth = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Vec2d p = states[i].position;
        const double r = scene.bodies[i].radius;
        for (std::size_t j = 0; j < i; ++j)
            depth = std::max(depth, r + scene.bodies[j].radius - norm(p - states[j].position));
        if (scene.frame && scene.frame->right)
            depth = std::max(depth, p.x + r - *scene.frame->right);
    }
    return depth;
}

struct Health {
    double rise = 0;
    double deepest = 0;
};
// Looked at 2,000 times, and at every collision.
Health healthOf(const Scene& scene, const Timeline& timeline) {
    std::vector<double> times;
    for (int k = 0; k <= 2000; ++k)
        times.push_back(timeline.endTime() * k / 2000);
    for (const Collision& c : timeline.collisions())
        times.push_back(c.time);
    std::sort(times.begin(), times.end());
    const double start = energyOf(scene, startOf(scene));
    double last = start;
    Health health;
    for (const double t : times) {
        const auto states = timeline.stateAt(t);
        const double energy = energyOf(scene, states);
        health.rise = std::max(health.rise, (energy - last) / start);
        health.deepest = std::max(health.deepest, deepestOverlap(scene, states));
        last = energy;
    }
    return health;
}

void addHealth(Results& out, ExtremeRow row, ExtremeCase kase, double value, const Scene& scene,
               const Timeline& timeline) {
    const Health h = healthOf(scene, timeline);
    add(out, row, kase, value, ExtremeMeasure::EnergyRise, 0, h.rise, h.rise, 1e-13);
    add(out, row, kase, value, ExtremeMeasure::Overlap, 0, h.deepest, h.deepest, 1e-12);
}

// Three equal balls in a line only ever meet the middle one in turn, whatever lies between them: how often is
// in the speeds of approach of left and right alone, of which one comes back as -e u, and gives (1 + e)/2 u
// to the other. Nothing if there is no end to it.
std::optional<int> collisionsInALine(const Quad& e, Quad left, Quad right) {
    for (int count = 0; count < 1000; ++count) {
        if (!(left > 0))
            return count;
        right += (1 + e) / 2 * left;
        left *= -e;
        std::swap(left, right);
    }
    return std::nullopt;
}

Scene threeInALine(double e) {
    return sceneOf(e, {ball(1, 1, 0.1, {-0.5, 0}, {1, 0}), ball(2, 1, 0.1, {0, 0}, {0, 0}),
                       ball(3, 1, 0.1, {0.7, 0}, {-0.5, 0})});
}

// Every pass to the left and back leaves a part of the approach; next to the limit 7 - 4√3 so small a one
// that it is below rounding before the last of the collisions, which then do not happen. Beyond it there are
// few.
void threeInALineAt(Results& out, double e) {
    constexpr ExtremeRow row = ExtremeRow::InelasticCollapse;
    constexpr ExtremeCase kase = ExtremeCase::ThreeInALine;
    constexpr int few = 20;
    const Scene scene = threeInALine(e);
    const Timeline timeline = runOf(scene, 5);
    const double got = double(timeline.collisionCount());
    const auto exact = collisionsInALine(Quad(e), 1, 0.5);
    if (exact && *exact <= few) {
        add(out, row, kase, e, ExtremeMeasure::Collisions, *exact, got, std::abs(got - *exact), 0);
    } else {
        constexpr double common = 0.5 / 3;
        const double most = exact ? *exact : 100;
        add(out, row, kase, e, ExtremeMeasure::CollisionsAtMost, most, got, std::max(0.0, got - most), 0);
        double furthest = -1, velocity = 0;
        for (const BodyState& s : timeline.stateAt(5))
            if (const double off = std::abs(s.velocity.x - common); !(off <= furthest)) {
                furthest = off;
                velocity = s.velocity.x;
            }
        add(out, row, kase, e, ExtremeMeasure::CommonVelocity, common, velocity, furthest, 64 * epsilon);
    }
    addHealth(out, row, kase, e, scene, timeline);
}

void chainAtAWall(Results& out, int count) {
    Scene scene = sceneOf(0, {});
    for (int i = 0; i < count; ++i)
        scene.bodies.push_back(
            ball(i + 1, 1, 0.1, {-0.2 * (count - i) - (i == 0 ? 1 : 0), 0}, {i == 0 ? 1.0 : 0.0, 0}));
    scene.frame = Frame{{}, 0.0 - 0.1, {}, {}, 0};
    const Timeline timeline = runOf(scene, 20);
    constexpr ExtremeRow row = ExtremeRow::InelasticCollapse;
    const double most = 2.0 * count * count, got = double(timeline.collisionCount());
    add(out, row, ExtremeCase::ChainAtAWall, count, ExtremeMeasure::CollisionsAtMost, most, got,
        std::max(0.0, got - most), 0);
    const double energy = energyOf(scene, timeline.stateAt(timeline.endTime()));
    add(out, row, ExtremeCase::ChainAtAWall, count, ExtremeMeasure::EnergyAfter, 0, energy, energy, 1e-30);
    addHealth(out, row, ExtremeCase::ChainAtAWall, count, scene, timeline);
}

Body pin(int number, Vec2d position) {
    return {std::to_string(number), BodyKind::Pin, 1.59, 0.06, position, {}};
}

Scene onFloor(double e, double rolling, std::vector<Body> bodies) {
    Scene scene = sceneOf(e, std::move(bodies));
    scene.friction = Friction{0.2, rolling, 0.4, standardGravity, {}};
    return scene;
}

struct Pressed {
    ExtremeCase kase;
    Scene scene;
};
std::vector<Pressed> pressedScenes() {
    Scene pushes = onFloor(0, 0.01, {ball(1, 6.8, 0.1, {0.01, -0.5}, {0, 2}), pin(2, {0, 0})});
    pushes.bodies[0].spin = {-20, 0, 0}; // it rolls
    const double up = std::sqrt(0.12 * 0.12 - 0.07 * 0.07);
    const Scene between = onFloor(
        0, 0.01,
        {ball(1, 6.8, 0.1, {0.01, -0.5}, {0, 2}), pin(2, {0, 0}), pin(3, {-0.07, up}), pin(4, {0.07, up})});
    Scene spun = onFloor(0.5, 0.01, {ball(1, 6.8, 0.1, {0, 0}, {1, 0.3})});
    spun.bodies[0].spin = {-20, 60, 3};
    spun.frame = Frame{{}, 0.5, {}, {}, 0.5};
    return {{ExtremeCase::BallPushesPin, pushes},
            {ExtremeCase::PinBetweenTwo, between},
            {ExtremeCase::BallSpunAtAWall, spun}};
}

Timeline runPressed(const Scene& scene, double contactTime) {
    EngineSettings settings;
    settings.until = 60;
    settings.contactTime = contactTime;
    return runOf(scene, settings);
}

// What becomes of a scene and of its mirror image in x = 0: body i's image is image[i].
double asymmetry(const Scene& scene, const std::vector<std::size_t>& image, double until) {
    const auto states = runOf(scene, until).stateAt(until);
    double most = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState &a = states[i], &b = states[image[i]];
        for (const double off : {a.position.x + b.position.x, a.position.y - b.position.y,
                                 a.velocity.x + b.velocity.x, a.velocity.y - b.velocity.y})
            if (!(std::abs(off) <= most))
                most = std::abs(off);
    }
    return most;
}

} // namespace

void collapse(Results& out) {
    for (const double e : {0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.0717, 0.0719, 0.1, 0.2})
        threeInALineAt(out, e);
    for (const int count : {3, 10})
        chainAtAWall(out, count);
}

void lasting(Results& out) {
    constexpr ExtremeRow row = ExtremeRow::LastingContact;
    const double contactTime = EngineSettings{}.contactTime;
    for (const auto& [kase, scene] : pressedScenes()) {
        const Timeline timeline = runPressed(scene, contactTime);
        constexpr double most = 200, mostStretches = 10'000;
        const double got = double(timeline.collisionCount());
        add(out, row, kase, contactTime, ExtremeMeasure::CollisionsAtMost, most, got,
            std::max(0.0, got - most), 0);
        double stretches = 0;
        for (std::size_t b = 0; b < timeline.bodyCount(); ++b)
            stretches += double(timeline.segments(b).size());
        add(out, row, kase, contactTime, ExtremeMeasure::StretchesAtMost, mostStretches, stretches,
            std::max(0.0, stretches - mostStretches), 0);
        addHealth(out, row, kase, contactTime, scene, timeline);
    }
}

// What the rule costs: where all end up, against a contact time of 0.1 µs. A contact that is held too long or
// too short by the contact time costs the way gone in it, at 2 m/s at most. Where dozens of contacts begin
// and end on each other, there is no such bound; a millimetre is what is promised.
void contactTimes(Results& out) {
    for (const auto& [kase, scene] : pressedScenes()) {
        const Timeline reference = runPressed(scene, 1e-7);
        const auto exact = reference.stateAt(reference.endTime());
        for (const double contactTime : {1e-4, 1e-5, 1e-6}) {
            const Timeline timeline = runPressed(scene, contactTime);
            const auto states = timeline.stateAt(timeline.endTime());
            double off = 0;
            for (std::size_t i = 0; i < states.size(); ++i)
                off = std::max(off, norm(states[i].position - exact[i].position));
            add(out, ExtremeRow::ContactTime, kase, contactTime, ExtremeMeasure::EndPosition, 0, off, off,
                kase == ExtremeCase::PinBetweenTwo ? 1e-3 : 2 * contactTime);
        }
    }
}

void mirror(Results& out) {
    for (const double e : {0.0, 0.5, 0.75, 1.0}) {
        const double rack = asymmetry(rackScene(0, 0, 6.8, e), {0, 1, 3, 2, 6, 5, 4, 10, 9, 8, 7}, 2);
        add(out, ExtremeRow::Mirror, ExtremeCase::RackHeadOn, e, ExtremeMeasure::Asymmetry, 0, rack, rack,
            1e-12);
        const Scene two = sceneOf(e, {ball(1, 1, 0.1, {0, -0.7}, {0, 1}), ball(2, 1, 0.1, {-0.1, 0}, {}),
                                      ball(3, 1, 0.1, {0.1, 0}, {})});
        const double cue = asymmetry(two, {0, 2, 1}, 2);
        add(out, ExtremeRow::Mirror, ExtremeCase::CueOnTwo, e, ExtremeMeasure::Asymmetry, 0, cue, cue, 1e-12);
    }
}

} // namespace thetalane::extremes

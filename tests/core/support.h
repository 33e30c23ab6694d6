// What the tests of the core share: seeded random scenes (the same on every machine), a run or a failure.
#pragma once

#include "core/engine/engine.h"
#include "core/scene/validation.h"
#include "tests/core/random.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace thetalane::testing {

inline Body disc(int number, double mass, double radius, Vec2d position, Vec2d velocity) {
    return {"d" + std::to_string(number), BodyKind::Ball, mass, radius, position, velocity};
}

// Sound by construction, or the test is at fault.
inline Timeline runOf(const Scene& scene, const EngineSettings& settings) {
    if (!validate(scene).empty())
        qFatal("the test's own scene is not sound: %s", validate(scene).front().path.c_str());
    auto result = simulate(scene, settings);
    if (!std::holds_alternative<Run>(result))
        qFatal("the test's own settings were refused");
    return std::move(std::get<Run>(result).timeline);
}

inline EngineSettings eventSettings(double until, Precision precision = Precision::Double) {
    EngineSettings s;
    s.until = until;
    s.precision = precision;
    return s;
}

inline EngineSettings steppedSettings(double until, double step, Precision precision = Precision::Double) {
    EngineSettings s = eventSettings(until, precision);
    s.kind = EngineKind::Stepped;
    s.step = step;
    return s;
}

// Discs thrown at random, none overlapping, into x in [-1, 1], y in [-0.7, 0.7]; `walls` closes that box.
inline Scene randomScene(Random& random, int count, double restitution, bool walls, double speed = 1) {
    Scene scene;
    scene.restitution = restitution;
    if (walls)
        scene.frame = Frame{-1.0, 1.0, -0.7, 0.7, restitution};
    while (int(scene.bodies.size()) < count) {
        const double r = random.in(0.05, 0.15);
        const double angle = random.in(-std::numbers::pi, std::numbers::pi);
        const double v = speed * random.in(0.2, 1.0);
        const Vec2d p{random.in(-1 + r, 1 - r), random.in(-0.7 + r, 0.7 - r)};
        bool free = true;
        for (const Body& b : scene.bodies)
            free = free && norm(b.position - p) > b.radius + r + 1e-3;
        // Without walls they are thrown inwards, or they would never meet.
        const Vec2d inwards = walls ? Vec2d{std::cos(angle), std::sin(angle)}
                                    : -1.0 * p + Vec2d{0.2 * std::cos(angle), 0.2 * std::sin(angle)};
        if (free)
            scene.bodies.push_back(disc(int(scene.bodies.size()), random.logUniform(0.2, 5), r, p,
                                        inwards * (v / (norm(inwards) + 1e-9))));
    }
    return scene;
}

// The deepest overlap of two bodies in play, of a body and a wall; negative where nothing touches [m].
inline double deepestOverlap(const Scene& scene, std::span<const BodyState> states) {
    double depth = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Vec2d p = states[i].position;
        const double r = scene.bodies[i].radius;
        for (std::size_t j = 0; j < i; ++j)
            if (states[i].place == Place::Play && states[j].place == Place::Play)
                depth = std::max(depth, r + scene.bodies[j].radius - norm(p - states[j].position));
        if (!scene.frame)
            continue;
        const Frame& f = *scene.frame;
        depth = std::max({depth, f.left ? *f.left - p.x + r : depth, f.right ? p.x + r - *f.right : depth,
                          f.bottom ? *f.bottom - p.y + r : depth, f.top ? p.y + r - *f.top : depth});
    }
    return depth;
}

inline double largestDifference(std::span<const BodyState> a, std::span<const BodyState> b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max({worst, norm(a[i].position - b[i].position), norm(a[i].velocity - b[i].velocity)});
    return worst;
}

} // namespace thetalane::testing

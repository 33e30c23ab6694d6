// Generated pairs of discs in quadratic motion, by category; the same on every machine.
#pragma once

#include "core/math/vec2.h"
#include "tests/core/random.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace thetalane::testing {

// One disc relative to the other [m, m/s, m/s²], within [0, horizon] s.
struct ImpactCase {
    Vec2d p, v, a;
    double reach = 0;
    double speed2 = 0;
    double horizon = 0;
};

struct ImpactCategory {
    const char* name;
    ImpactCase (*make)(Random&);
};

inline Vec2d direction(Random& random) {
    const double angle = random.in(-std::numbers::pi, std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
}

// Where it must be now to be at `at` with velocity `v` after t.
inline ImpactCase cameFrom(Vec2d at, Vec2d v, Vec2d a, double t, double reach) {
    const Vec2d start = v - a * t;
    return {at - start * t - a * (t * t / 2), start, a, reach, dot(start, start), 0};
}

// Half of them aimed: somewhere on the way they are within reach.
inline ImpactCase genericCase(Random& random) {
    const double t = random.in(0, 2), reach = random.in(0.1, 0.5);
    const Vec2d near = direction(random) * (reach * random.in(0.8, random.below(2) ? 1.0 : 6.0));
    ImpactCase c =
        cameFrom(near, direction(random) * random.in(0, 10), direction(random) * random.in(0, 5), t, reach);
    c.speed2 += random.in(0, 50);
    c.horizon = t * random.in(0.5, 2);
    return c;
}

// The gap has an extremum at the touch, missed by 10⁻¹⁷ to 10⁻³ of the reach either way.
inline ImpactCase grazingCase(Random& random) {
    const double reach = random.in(0.1, 0.5), t = random.in(0, 2);
    const Vec2d n = direction(random), across{-n.y, n.x};
    const double miss = random.logUniform(1e-17, 1e-3) * (random.below(2) ? 1 : -1);
    ImpactCase c = cameFrom(n * (reach * (1 + miss)), across * random.in(-8, 8),
                            direction(random) * random.in(0, 5), t, reach);
    c.horizon = t * random.in(0.9, 3);
    return c;
}

// Velocities of 10 m/s whose difference is 10⁻¹⁵ to 10⁻⁶ m/s.
inline ImpactCase equalVelocitiesCase(Random& random) {
    const double reach = random.in(0.1, 0.5), slow = random.logUniform(1e-15, 1e-6);
    const Vec2d n = direction(random);
    const double gap = random.logUniform(1e-15, 1);
    ImpactCase c{n * (reach + gap),
                 direction(random) * slow,
                 direction(random) * random.logUniform(1e-9, 5),
                 reach,
                 100,
                 random.logUniform(1e-2, 1e3)};
    if (random.below(2))
        c.a = n * -random.logUniform(1e-9, 5);
    return c;
}

// Two that slide side by side with all but the same friction.
inline ImpactCase parallelCase(Random& random) {
    ImpactCase c = genericCase(random);
    const double a = random.logUniform(1e-22, 1e-8);
    const double t = c.horizon * random.in(0.3, 1);
    const double horizon = c.horizon, speed2 = c.speed2;
    c = cameFrom(direction(random) * (c.reach * random.in(0.7, 1.3)), c.v, direction(random) * a, t, c.reach);
    c.horizon = horizon;
    c.speed2 = speed2;
    return c;
}

// One rests, the other slides towards it and stops at about the touch: the stop is the horizon.
inline ImpactCase restingCase(Random& random) {
    const double reach = random.in(0.1, 0.5), friction = random.in(0.3, 5),
                 speed = random.logUniform(1e-3, 10);
    const double way = speed * speed / (2 * friction);
    const double early = 1 + random.logUniform(1e-17, 0.9) * (random.below(2) ? 1 : -1);
    const Vec2d n = direction(random);
    const Vec2d heading = random.below(2) ? n : n + direction(random) * random.logUniform(1e-9, 0.3);
    const Vec2d unit = heading * (1 / norm(heading));
    return {
        n * -(reach + way * early), unit * speed, unit * -friction, reach, speed * speed, speed / friction};
}

// At the touch within a few roundings, with every kind of velocity and acceleration.
inline ImpactCase touchingCase(Random& random) {
    const double reach = random.in(0.1, 0.5);
    const Vec2d n = direction(random);
    const double speeds[] = {0, random.logUniform(1e-18, 1e-9), random.in(0, 3)};
    const Vec2d v =
        (random.below(2) ? n * (random.below(2) ? 1 : -1) : direction(random)) * speeds[random.below(3)];
    const Vec2d a = (random.below(2) ? n * (random.below(2) ? 1 : -1) : direction(random)) * random.in(0, 5);
    return {n * (reach * (1 + 0x1p-52 * random.in(-8, 8))),
            v,
            a,
            reach,
            dot(v, v) + random.below(2) * 10.0,
            random.in(0.01, 3)};
}

// Every quantity its own power of ten, 10⁻⁶ to 10⁶; half of them aimed.
inline ImpactCase mixedScalesCase(Random& random) {
    const auto any = [&random] { return random.logUniform(1e-6, 1e6); };
    const double reach = any(), speed = any(), slowing = any();
    if (random.below(2)) {
        const double t =
            random.logUniform(1e-3, 1) * std::min(reach / speed, std::sqrt(reach / slowing)) * 100;
        ImpactCase c = cameFrom(direction(random) * (reach * random.in(0.2, 1.2)), direction(random) * speed,
                                direction(random) * slowing, t, reach);
        c.horizon = t * random.logUniform(0.5, 1e6);
        return c;
    }
    ImpactCase c{direction(random) * (reach * random.logUniform(1, 1e6)),
                 direction(random) * speed,
                 direction(random) * slowing,
                 reach,
                 speed * speed,
                 any()};
    return c;
}

// It passes two, three times: turned round by the acceleration, close to the circle both times.
inline ImpactCase returningCase(Random& random) {
    const double reach = random.in(0.1, 0.5), a = random.in(0.5, 5), t = random.in(0.2, 2);
    const Vec2d n = direction(random), across{-n.y, n.x};
    const Vec2d turn = n * (reach * random.in(0.5, 1.5)) + across * (reach * random.in(-1, 1));
    const Vec2d drift = direction(random) * random.logUniform(1e-6, 1);
    ImpactCase c = cameFrom(turn, drift, n * (random.below(2) ? a : -a), t, reach);
    c.horizon = t * random.in(0.5, 4);
    return c;
}

inline std::array<ImpactCategory, 8> impactCategories() {
    return {{{"generic", genericCase},
             {"grazing", grazingCase},
             {"nearly equal velocities", equalVelocitiesCase},
             {"nearly parallel decelerations", parallelCase},
             {"at rest", restingCase},
             {"touching", touchingCase},
             {"mixed scales", mixedScalesCase},
             {"returning", returningCase}}};
}

} // namespace thetalane::testing

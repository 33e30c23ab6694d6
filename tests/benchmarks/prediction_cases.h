// Pairs to predict the impact of, as they come in play, and how many the bounds alone turn away.
#pragma once

#include "core/motion/quadratic_impact.h"
#include "tests/core/impact_cases.h"

#include <vector>

namespace thetalane::benchmarks {

inline double never() {
    return std::numeric_limits<double>::infinity();
}

// Two pins somewhere on the deck, μ = 0.4; each rests or slides at up to 5 m/s, until the first of them
// rests.
inline testing::ImpactCase pinsCase(testing::Random& random) {
    const double slowing = 0.4 * 9.80665, reach = 0.12105;
    testing::ImpactCase c;
    c.reach = reach;
    c.horizon = never();
    do
        c.p = {random.in(-1, 1), random.in(-0.8, 0.8)};
    while (norm(c.p) < reach);
    for (const int sign : {1, -1}) {
        const double speed = random.below(2) || (sign < 0 && c.speed2 == 0) ? random.in(0.05, 5) : 0;
        if (speed == 0)
            continue;
        const Vec2d along = testing::direction(random) * double(sign);
        c.v = c.v + along * speed;
        c.a = c.a - along * slowing;
        c.speed2 += speed * speed;
        c.horizon = std::min(c.horizon, speed / slowing);
    }
    return c;
}

// The same without friction.
inline testing::ImpactCase freeCase(testing::Random& random) {
    testing::ImpactCase c = pinsCase(random);
    c.a = {};
    c.horizon = never();
    return c;
}

inline std::vector<testing::ImpactCase> manyCases(testing::ImpactCase (*make)(testing::Random&)) {
    testing::Random random(1);
    std::vector<testing::ImpactCase> cases;
    for (int k = 0; k < 4096; ++k)
        cases.push_back(make(random));
    return cases;
}

inline double timeFor(const testing::ImpactCase& c) {
    return timeToImpact<double>(c.p, c.v, c.a, c.reach, c.speed2, c.horizon);
}

// Of those that never meet, the share that staysApart() finds.
inline double rejectedShare(const std::vector<testing::ImpactCase>& cases) {
    int apart = 0, rejected = 0;
    for (const testing::ImpactCase& c : cases) {
        apart += timeFor(c) == never();
        rejected += staysApart<double>(c.p, c.v, c.a, c.reach * c.reach, c.horizon);
    }
    return apart == 0 ? 1 : double(rejected) / apart;
}

inline double sumOfTimes(const std::vector<testing::ImpactCase>& cases) {
    double sum = 0;
    for (const testing::ImpactCase& c : cases) {
        const double t = timeFor(c);
        sum += t < never() ? t : 0;
    }
    return sum;
}

} // namespace thetalane::benchmarks

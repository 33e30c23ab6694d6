// Scenes on a floor with friction, and what must hold of every run.
#pragma once

#include "tests/core/support.h"

namespace thetalane::testing {

// Of translation and of the balls' rotation.
inline double energyOf(const Scene& scene, std::span<const BodyState> states) {
    double sum = totals(scene, states).energy;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& b = scene.bodies[i];
        const Spin<double>& w = states[i].spin;
        if (b.kind == BodyKind::Ball)
            sum += b.inertia * b.mass * b.radius * b.radius * (w.x * w.x + w.y * w.y) / 2;
    }
    return sum;
}

struct Health {
    double deepest = -1; // overlap [m]
    double gained = 0;   // energy, between two of the looks, of what there was at the start
    std::size_t events = 0;
    bool ended = true; // and finite
    bool finite = true;
};

inline Health healthOf(const Scene& scene, const Timeline& timeline, int looks) {
    Health h;
    const double start = energyOf(scene, timeline.stateAt(0));
    double last = start;
    for (int k = 1; k <= looks; ++k) {
        const auto states = timeline.stateAt(timeline.endTime() * k / looks);
        const double now = energyOf(scene, states);
        h.deepest = std::max(h.deepest, deepestOverlap(scene, states));
        h.gained = std::max(h.gained, (now - last) / start);
        last = now;
        h.finite = h.finite && std::isfinite(now);
        for (const BodyState& b : states)
            h.finite = h.finite && std::isfinite(b.position.x) && std::isfinite(b.position.y);
    }
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        h.events += timeline.segments(b).size();
    h.ended = h.finite && timeline.endReason() != EndReason::MaxCollisions;
    return h;
}

inline Scene randomFloorScene(Random& random, int count, double e, bool walls, double speed) {
    Scene scene = randomScene(random, count, e, walls, speed);
    scene.friction = Friction{random.logUniform(0.02, 0.8),
                              random.below(2) ? 0.0 : random.logUniform(1e-3, 0.1),
                              random.logUniform(0.05, 0.8),
                              standardGravity,
                              {}};
    if (random.below(2))
        scene.friction->oil = {{-0.3, random.in(-0.2, 0.4), random.logUniform(0.01, 0.2)}};
    for (Body& b : scene.bodies) {
        b.kind = random.below(2) ? BodyKind::Ball : BodyKind::Pin;
        b.inertia = random.in(0.3, 0.5);
        if (random.below(3) == 0)
            b.spin = {random.in(-20, 20) * speed, random.in(-20, 20) * speed, random.in(-20, 20) * speed};
        if (random.below(4) == 0)
            b.velocity = {};
    }
    return scene;
}

} // namespace thetalane::testing

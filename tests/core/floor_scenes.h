// Scenes on a floor with friction, and what must hold of every run.
#pragma once

#include "tests/core/support.h"

namespace thetalane::testing {

// Kinetic, of translation and, of a ball, of rotation [J].
inline double energyOf(const Body& body, const Vec2d& v, const Spin<double>& w) {
    double energy = body.mass * dot(v, v) / 2;
    if (body.kind == BodyKind::Ball)
        energy += body.inertia * body.mass * body.radius * body.radius * (w.x * w.x + w.y * w.y) / 2;
    return energy;
}

struct Health {
    double deepest = -1; // overlap at an event, or at one of the looks between [m]
    double gained =
        0; // the most by which energy rose above any earlier moment, of what there was at the start
    std::size_t events = 0;
    bool ended = true; // and finite
    bool finite = true;
};

// Of a timeline, event by event: just before and just after each.
class EventEnergies {
public:
    EventEnergies(const Scene& scene, const Timeline& timeline)
        : m_scene(scene)
        , m_timeline(timeline)
        , m_now(scene.bodies.size(), 0) {
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            for (const Segment& s : timeline.segments(b))
                m_times.push_back(s.start);
        m_times.push_back(timeline.endTime());
        std::sort(m_times.begin(), m_times.end());
        m_times.erase(std::unique(m_times.begin(), m_times.end()), m_times.end());
    }
    const std::vector<double>& times() const { return m_times; }

    double mostGained() {
        const double start = totalAt(0);
        double least = start, gained = 0;
        const auto see = [&](double energy) {
            gained = std::max(gained, energy - least);
            least = std::min(least, energy);
        };
        for (const double t : m_times) {
            see(totalAt(t));
            for (std::size_t b = 0; b < m_now.size(); ++b)
                while (m_now[b] + 1 < m_timeline.segments(b).size() &&
                       m_timeline.segments(b)[m_now[b] + 1].start <= t)
                    ++m_now[b];
            see(totalAt(t));
        }
        return start > 0 ? gained / start : gained;
    }

private:
    // On the segments of now.
    double totalAt(double t) const {
        double sum = 0;
        for (std::size_t b = 0; b < m_now.size(); ++b) {
            const Segment& s = m_timeline.segments(b)[m_now[b]];
            const double after = t - s.start;
            Spin<double> w = m_scene.bodies[b].spin;
            if (const auto rotations = m_timeline.rotations(b); !rotations.empty()) {
                const Rotation& r = rotations[m_now[b]];
                w = {r.spin.x + r.rate.x * after, r.spin.y + r.rate.y * after, r.spin.z};
            }
            sum += energyOf(m_scene.bodies[b], s.velocity + s.acceleration * after, w);
        }
        return sum;
    }

    const Scene& m_scene;
    const Timeline& m_timeline;
    std::vector<std::size_t> m_now; // of each body, which segment
    std::vector<double> m_times;
};

inline Health healthOf(const Scene& scene, const Timeline& timeline, int looks) {
    Health h;
    EventEnergies energies(scene, timeline);
    h.gained = energies.mostGained();
    const auto look = [&](double t) {
        const auto states = timeline.stateAt(t);
        h.deepest = std::max(h.deepest, deepestOverlap(scene, states));
        for (const BodyState& b : states)
            h.finite = h.finite && std::isfinite(b.position.x) && std::isfinite(b.position.y) &&
                       std::isfinite(b.velocity.x) && std::isfinite(b.velocity.y);
    };
    for (int k = 1; k <= looks; ++k)
        look(timeline.endTime() * k / looks);
    const std::vector<double>& times = energies.times(); // of tens of thousands, some thousands
    for (std::size_t k = 0; k < times.size(); k += 1 + times.size() / 4096)
        look(times[k]);
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

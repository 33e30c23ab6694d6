// The paper's loop, with its faults: it moves all bodies by a step and then exchanges every pair that
// overlaps, in the order of the scene, whether or not the two approach, then the walls. Fast bodies skip
// through each other, and a pair that still overlaps one step later is exchanged again. `approachingOnly`
// mends the second fault.
//
// A body moves by v·h; on a floor with friction, by what the closed form of its motion says for h.
#include "core/engine/engines.h"
#include "core/engine/step_motion.h"
#include "core/engine/surroundings.h"
#include "core/math/quad.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace thetalane {
namespace {

template <class Real, class Models> class SteppedEngine {
public:
    SteppedEngine(const Scene& scene, const EngineSettings& settings)
        : m_settings(settings)
        , m_restitution(scene.restitution)
        , m_around(scene)
        , m_motion(scene, Real(settings.step))
        , m_changed(scene.bodies.size(), true)
        , m_recorder(scene.bodies.size(), settings.keepDetail) {
        for (std::size_t i = 0; i < count(); ++i)
            m_discs.push_back(m_motion.discs().disc(i));
    }

    Timeline run() {
        recordChanged(0);
        const Real h(m_settings.step);
        // A whole number of steps that misses `until` by rounding alone is meant to reach it.
        const auto steps = std::int64_t(m_settings.until / m_settings.step * (1 + 1e-12));
        for (std::int64_t k = 1; k <= steps; ++k) {
            const double time = std::min(double(k) * m_settings.step, m_settings.until); // 3 · 0.1 > 0.3
            move(h, double(k - 1) * m_settings.step, time);
            const bool full = exchangePairs(time) || exchangeWithWalls(time);
            if constexpr (Models::lane)
                crossEdges(time);
            goOnChanged(time);
            recordChanged(time);
            if (full)
                return m_recorder.finish(time, EndReason::MaxCollisions);
            if (m_motion.allAtRest())
                return m_recorder.finish(time, EndReason::AtRest);
        }
        if constexpr (Models::friction) // who stops in what is left is not to turn back
            move(Real(std::max(0.0, m_settings.until - double(steps) * m_settings.step)),
                 double(steps) * m_settings.step, m_settings.until);
        return m_recorder.finish(m_settings.until, EndReason::Until);
    }

private:
    std::size_t count() const { return m_motion.discs().count(); }
    bool full() const { return m_recorder.collisionCount() >= m_settings.maxCollisions; }

    void move(const Real& step, double from, double to) {
        m_motion.advance(
            step, [this](std::size_t i) { return m_around.inPlay(i); },
            [&](std::size_t i, const Real& at) { record(i, std::min(from + static_cast<double>(at), to)); });
        const auto& moved = m_motion.discs();
        for (std::size_t i = 0; i < count(); ++i) {
            m_discs[i].position = moved.positionAt(i, Real(0));
            if constexpr (Models::friction)
                m_discs[i].velocity = moved.velocityAt(i, Real(0));
        }
    }

    // True when the most collisions allowed have happened.
    bool exchangePairs(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            for (std::size_t j = i + 1; j < count(); ++j) {
                if (!touch(i, j) || !m_around.inPlay(i) || !m_around.inPlay(j) ||
                    (m_settings.approachingOnly && !approach(i, j)))
                    continue;
                const auto steps = collide(m_discs[i], m_discs[j], m_restitution);
                m_discs[i].velocity = steps.after.first;
                m_discs[j].velocity = steps.after.second;
                m_changed[i] = m_changed[j] = true;
                m_recorder.collision(time, int(i), int(j), Side::Left, steps);
                if (full())
                    return true;
            }
        }
        return false;
    }

    // And with the plates beside the pins. True as above.
    bool exchangeWithWalls(double time) {
        bool filled = false;
        for (std::size_t i = 0; i < count() && !filled; ++i) {
            m_around.forEachWall(i, [&](EventKind kind, Side side, const Real& wall) {
                Disc<Real>& d = m_discs[i];
                const auto a = approachTo(side, wall, d.position, d.velocity, d.radius);
                if (filled || a.gap > 0 || (m_settings.approachingOnly && !(a.speed > 0)))
                    return;
                const auto steps = collideWithSide(d, side, m_around.restitutionOf(kind));
                d.velocity = steps.after.first;
                m_changed[i] = true;
                m_recorder.collision(time, int(i), -1, side, steps);
                filled = full();
            });
        }
        return filled;
    }

    // Z <= rA + rB, with the root taken only for pairs it could decide.
    bool touch(std::size_t i, std::size_t j) const {
        using std::sqrt;
        const Vec2<Real> d = m_discs[i].position - m_discs[j].position;
        const Real reach = m_discs[i].radius + m_discs[j].radius;
        const Real distance2 = d.x * d.x + d.y * d.y;
        return distance2 <= reach * reach * Real(1.0001f) && sqrt(distance2) <= reach;
    }

    bool approach(std::size_t i, std::size_t j) const {
        return dot(m_discs[i].position - m_discs[j].position, m_discs[i].velocity - m_discs[j].velocity) < 0;
    }

    void crossEdges(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            LanePlace& where = m_around.placeOf(i);
            Disc<Real>& d = m_discs[i];
            const auto edge =
                nextLaneEvent<Real>(m_around.lane(), d.position, d.velocity, {}, d.radius, where);
            if (edge.event == LaneEvent::None || edge.in > 0)
                continue;
            const Place before = where.place;
            applyLaneEvent(edge.event, m_around.lane(), d.position, d.velocity, where);
            if (where.place != before)
                m_recorder.departure({time, int(i), where.place});
            m_changed[i] = true;
        }
    }

    void goOnChanged(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            if constexpr (Models::lane && Models::friction)
                stopInTheGutter(i, time);
            if (!m_changed[i])
                continue;
            if constexpr (Models::friction)
                m_motion.moveTo(i, Real(0));
            m_motion.goOn(i, m_discs[i].velocity, Real(0), m_around.inPlay(i));
        }
    }

    // A pin that flies over the gutter falls into it where friction stops it.
    void stopInTheGutter(std::size_t i, double time) {
        if (m_around.placeOf(i).flying == 0 || !m_motion.atRest(i) || m_changed[i])
            return;
        m_around.placeOf(i) = {Place::Gutter};
        m_recorder.departure({time, int(i), Place::Gutter});
        m_changed[i] = true;
    }

    void record(std::size_t i, double time) { m_motion.record(m_recorder, i, time, m_around.place(i)); }

    void recordChanged(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            if (m_changed[i])
                record(i, time);
            m_changed[i] = false;
        }
    }

    EngineSettings m_settings;
    Real m_restitution;
    Surroundings<Real, Models> m_around;
    StepMotion<Real, Models::friction> m_motion;
    std::vector<Disc<Real>> m_discs; // where the step's motion put them
    std::vector<char> m_changed;
    Recorder m_recorder;
};

template <class Real> Timeline run(const Scene& scene, const EngineSettings& settings) {
    const Requirements needs = requirementsOf(scene);
    if (needs.friction)
        return SteppedEngine<Real, Models<true, true, true>>(scene, settings).run();
    if (needs.lane)
        return SteppedEngine<Real, Models<true, true, false>>(scene, settings).run();
    if (needs.frame)
        return SteppedEngine<Real, Models<true, false, false>>(scene, settings).run();
    return SteppedEngine<Real, Models<false, false, false>>(scene, settings).run();
}

} // namespace

Timeline runStepped(const Scene& scene, const EngineSettings& settings) {
    switch (settings.precision) {
    case Precision::Float:
        return run<float>(scene, settings);
    case Precision::Double:
        return run<double>(scene, settings);
    case Precision::Quad:
        break;
    }
    return run<Quad>(scene, settings);
}

} // namespace thetalane

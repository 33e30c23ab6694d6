// The paper's loop, with its faults: it moves all bodies by v·h and then exchanges every pair that overlaps,
// in the order of the scene, whether or not the two approach, then the walls. Fast bodies skip through each
// other, and a pair that still overlaps one step later is exchanged again. `approachingOnly` mends the second
// fault.
#include "core/engine/engines.h"
#include "core/engine/models.h"
#include "core/math/quad.h"
#include "core/timeline/recorder.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace thetalane {
namespace {

template <class Real> class SteppedEngine {
public:
    SteppedEngine(const Scene& scene, const EngineSettings& settings)
        : m_settings(settings)
        , m_restitution(scene.restitution)
        , m_hasFrame(scene.frame)
        , m_hasLane(scene.lane)
        , m_walls(scene.frame)
        , m_lane(scene.lane)
        , m_changed(scene.bodies.size(), true)
        , m_places(scene.bodies.size())
        , m_recorder(scene.bodies.size(), settings.keepDetail) {
        for (const Body& b : scene.bodies)
            m_discs.push_back(
                {Real(b.mass), Real(b.radius), convert<Real>(b.position), convert<Real>(b.velocity)});
    }

    Timeline run() {
        recordChanged(0);
        const Real h(m_settings.step);
        // A whole number of steps that misses `until` by rounding alone is meant to reach it.
        const auto steps = std::int64_t(m_settings.until / m_settings.step * (1 + 1e-12));
        for (std::int64_t k = 1; k <= steps; ++k) {
            const double time = std::min(double(k) * m_settings.step, m_settings.until); // 3 · 0.1 > 0.3
            for (Disc<Real>& d : m_discs)
                d.position = d.position + d.velocity * h;
            const bool full = exchangePairs(time) || (m_hasFrame && exchangeWithWalls(time));
            if (m_hasLane)
                crossEdges(time);
            recordChanged(time);
            if (full)
                return m_recorder.finish(time, EndReason::MaxCollisions);
            if (atRest())
                return m_recorder.finish(time, EndReason::AtRest);
        }
        return m_recorder.finish(m_settings.until, EndReason::Until);
    }

private:
    std::size_t count() const { return m_discs.size(); }
    bool inPlay(std::size_t i) const { return m_places[i].place == Place::Play; }
    bool full() const { return m_recorder.collisionCount() >= m_settings.maxCollisions; }

    // True when the most collisions allowed have happened.
    bool exchangePairs(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            for (std::size_t j = i + 1; j < count(); ++j) {
                if (!touch(i, j) || !inPlay(i) || !inPlay(j) ||
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

    bool exchangeWithWalls(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            for (const Side side : sides) {
                Disc<Real>& d = m_discs[i];
                const auto a = approachTo(side, m_walls.at[int(side)], d.position, d.velocity, d.radius);
                if (a.gap > 0 || (m_settings.approachingOnly && !(a.speed > 0)))
                    continue;
                const auto steps = collideWithSide(d, side, m_walls.restitution);
                d.velocity = steps.after.first;
                m_changed[i] = true;
                m_recorder.collision(time, int(i), -1, side, steps);
                if (full())
                    return true;
            }
        }
        return false;
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
            const auto edge = nextLaneEvent<Real>(m_lane, m_discs[i].position, m_discs[i].velocity, {},
                                                  m_discs[i].radius, m_places[i]);
            if (edge.event == LaneEvent::None || edge.in > 0)
                continue;
            const Place before = m_places[i].place;
            applyLaneEvent(edge.event, m_lane, m_discs[i].position, m_discs[i].velocity, m_places[i]);
            if (m_places[i].place != before)
                m_recorder.departure({time, int(i), m_places[i].place});
            m_changed[i] = true;
        }
    }

    void recordChanged(double time) {
        for (std::size_t i = 0; i < count(); ++i) {
            if (!m_changed[i])
                continue;
            m_recorder.segment(int(i), {time,
                                        convert<double>(m_discs[i].position),
                                        convert<double>(m_discs[i].velocity),
                                        {},
                                        m_places[i].place});
            m_changed[i] = false;
        }
    }

    bool atRest() const {
        for (const Disc<Real>& d : m_discs)
            if (!(d.velocity == Vec2<Real>{}))
                return false;
        return true;
    }

    EngineSettings m_settings;
    Real m_restitution;
    bool m_hasFrame;
    bool m_hasLane;
    Walls<Real> m_walls;
    LaneEdges<Real> m_lane;
    std::vector<Disc<Real>> m_discs;
    std::vector<char> m_changed;
    std::vector<LanePlace> m_places;
    Recorder m_recorder;
};

} // namespace

Timeline runStepped(const Scene& scene, const EngineSettings& settings) {
    switch (settings.precision) {
    case Precision::Float:
        return SteppedEngine<float>(scene, settings).run();
    case Precision::Double:
        return SteppedEngine<double>(scene, settings).run();
    case Precision::Quad:
        break;
    }
    return SteppedEngine<Quad>(scene, settings).run();
}

} // namespace thetalane

// The next-event engine: from contact to contact, each at its own instant, exact between them.
//
// Each disc keeps its own time (it moves only when something happens to it) and its one next event; a next
// event whose partner changed course meanwhile is found again. An impulse passes only between approaching
// bodies, and bodies that overlap by rounding and approach collide at once, so that none passes through
// another.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/models.h"
#include "core/motion/impact.h"
#include "core/timeline/recorder.h"

#include <limits>
#include <vector>

namespace thetalane {

template <class Real, bool HasFrame, bool HasLane> class NextEventEngine {
public:
    NextEventEngine(const Scene& scene, const EngineSettings& settings)
        : m_restitution(scene.restitution)
        , m_walls(scene.frame)
        , m_lane(scene.lane)
        , m_until(settings.until)
        , m_maxCollisions(settings.maxCollisions)
        , m_next(scene.bodies.size())
        , m_recorder(scene.bodies.size(), settings.keepDetail) {
        m_bodies.reserve(scene.bodies.size());
        for (const Body& b : scene.bodies)
            m_bodies.push_back(
                {{Real(b.mass), Real(b.radius), convert<Real>(b.position), convert<Real>(b.velocity)},
                 Real(0),
                 Place::Play});
    }

    Timeline run() {
        for (int i = 0; i < count(); ++i)
            record(i);
        for (int i = 0; i < count(); ++i)
            findNext(i);
        for (;;) {
            const int first = earliest();
            const Next next = m_next[std::size_t(first)];
            if (next.kind == Kind::None)
                return finish(atRest() ? EndReason::AtRest : EndReason::NoMoreCollisions);
            if (next.time > m_until)
                return finish(EndReason::Until);
            if (next.kind != Kind::LaneEdge && m_recorder.collisionCount() >= m_maxCollisions)
                return finish(EndReason::MaxCollisions);
            m_now = next.time;
            happen(first, next);
        }
    }

private:
    enum class Kind : unsigned char { None, Pair, Wall, LaneEdge };
    struct Next {
        Real time = never;
        int partner = -1; // of a pair
        Kind kind = Kind::None;
        unsigned char detail = 0; // which Side or LaneEvent
    };
    struct Moving {
        Disc<Real> disc; // as it was at `since`
        Real since{};
        Place place = Place::Play;
    };
    static inline const Real never = std::numeric_limits<Real>::infinity();

    int count() const { return int(m_bodies.size()); }
    Moving& body(int i) { return m_bodies[std::size_t(i)]; }
    const Moving& body(int i) const { return m_bodies[std::size_t(i)]; }
    Next& next(int i) { return m_next[std::size_t(i)]; }

    Vec2<Real> positionNow(const Moving& b) const {
        return b.disc.position + b.disc.velocity * Real(m_now - b.since);
    }

    int earliest() const {
        int best = 0;
        for (int i = 1; i < count(); ++i)
            if (m_next[std::size_t(i)].time < m_next[std::size_t(best)].time)
                best = i;
        return best;
    }

    bool atRest() const {
        for (const Moving& b : m_bodies)
            if (!(b.disc.velocity == Vec2<Real>{}))
                return false;
        return true;
    }

    // The next event of one body on its own: a wall, an edge of the lane.
    Next findOwn(const Moving& b, const Vec2<Real>& p) const {
        Next own;
        if constexpr (HasFrame) {
            for (const Side side : sides) {
                const auto a = approachTo(side, m_walls.at[int(side)], p, b.disc.velocity, b.disc.radius);
                if (!(a.speed > 0) || a.gap == never)
                    continue;
                const Real time = m_now + (a.gap > 0 ? Real(a.gap / a.speed) : Real(0));
                if (time < own.time)
                    own = {time, -1, Kind::Wall, static_cast<unsigned char>(side)};
            }
        }
        if constexpr (HasLane) {
            const auto edge = nextLaneEvent(m_lane, p, b.disc.velocity, b.disc.radius, b.place);
            if (edge.event != LaneEvent::None && m_now + edge.in < own.time)
                own = {m_now + edge.in, -1, Kind::LaneEdge, static_cast<unsigned char>(edge.event)};
        }
        return own;
    }

    // Finds body i's next event. A partner that would meet it sooner than anything else takes note of it too.
    void findNext(int i) {
        const Moving& a = body(i);
        const Vec2<Real> p = positionNow(a);
        const Vec2<Real> v = a.disc.velocity;
        const Real speed2 = dot(v, v);
        Next best = findOwn(a, p);
        for (int j = 0; j < count() && (!HasLane || a.place == Place::Play); ++j) {
            const Moving& b = body(j);
            if (j == i || (HasLane && b.place != Place::Play))
                continue;
            const Vec2<Real> u = b.disc.velocity;
            const Real in = timeToImpact<Real>(p - positionNow(b), v - u, a.disc.radius + b.disc.radius,
                                               speed2 + dot(u, u));
            const Real time = m_now + in;
            if (time < best.time)
                best = {time, j, Kind::Pair, 0};
            if (time < next(j).time)
                next(j) = {time, i, Kind::Pair, 0};
        }
        next(i) = best;
    }

    void happen(int i, const Next& event) {
        switch (event.kind) {
        case Kind::Pair:
            return collidePair(std::min(i, event.partner), std::max(i, event.partner));
        case Kind::Wall:
            return collideWall(i, Side(event.detail));
        case Kind::LaneEdge:
            return crossEdge(i, LaneEvent(event.detail));
        case Kind::None:
            return;
        }
    }

    void collidePair(int i, int j) {
        moveToNow(i);
        moveToNow(j);
        const auto steps = collide(body(i).disc, body(j).disc, m_restitution);
        body(i).disc.velocity = steps.after.first;
        body(j).disc.velocity = steps.after.second;
        recordCollision(i, j, Side::Left, steps);
        record(i);
        record(j);
        changedCourse(i, j);
    }

    void collideWall(int i, Side side) {
        moveToNow(i);
        const auto steps = collideWithSide(body(i).disc, side, m_walls.restitution);
        body(i).disc.velocity = steps.after.first;
        recordCollision(i, -1, side, steps);
        record(i);
        changedCourse(i, -1);
    }

    void crossEdge(int i, LaneEvent event) {
        moveToNow(i);
        const Place before = body(i).place;
        applyLaneEvent(event, body(i).disc.velocity, body(i).place);
        if (body(i).place != before)
            m_recorder.departure({static_cast<double>(m_now), i, body(i).place});
        record(i);
        changedCourse(i, -1);
    }

    void moveToNow(int i) {
        body(i).disc.position = positionNow(body(i));
        body(i).since = m_now;
    }

    // Bodies i and j (or i alone, j = -1) move otherwise from now on: whoever counted on them looks again.
    void changedCourse(int i, int j) {
        next(i) = Next{};
        if (j >= 0)
            next(j) = Next{};
        findNext(i);
        if (j >= 0)
            findNext(j);
        for (int k = 0; k < count(); ++k) {
            if (k == i || k == j || next(k).kind != Kind::Pair)
                continue;
            const int partner = next(k).partner;
            if (partner == i || partner == j)
                findNext(k);
        }
    }

    void record(int i) {
        const Moving& b = body(i);
        m_recorder.segment(i, {static_cast<double>(b.since),
                               convert<double>(b.disc.position),
                               convert<double>(b.disc.velocity),
                               {},
                               b.place});
    }

    void recordCollision(int i, int j, Side side, const PairCollision<Real>& steps) {
        m_recorder.collision({static_cast<double>(m_now), i, j, side, 0, convert<double>(steps)});
    }

    Timeline finish(EndReason reason) {
        const double end = reason == EndReason::Until || reason == EndReason::NoMoreCollisions
                               ? static_cast<double>(m_until)
                               : static_cast<double>(m_now);
        return m_recorder.finish(end, reason);
    }

    Real m_restitution;
    Walls<Real> m_walls;
    LaneEdges<Real> m_lane;
    Real m_until;
    std::int64_t m_maxCollisions;
    Real m_now{0};
    std::vector<Moving> m_bodies;
    std::vector<Next> m_next;
    Recorder m_recorder;
};

} // namespace thetalane

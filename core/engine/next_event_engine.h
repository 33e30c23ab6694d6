// The next-event engine: from contact to contact, each at its own instant, exact between them.
//
// Each disc keeps its own time (it moves only when something happens to it) and its one next event; a next
// event whose partner changed course meanwhile is found again. An impulse passes only between approaching
// bodies, and bodies that overlap by rounding and approach collide at once, so that none passes through
// another.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/models.h"
#include "core/engine/moving_discs.h"
#include "core/timeline/recorder.h"

#include <algorithm>
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
        , m_discs(scene.bodies)
        , m_places(HasLane ? m_discs.count() : 0, Place::Play)
        , m_next(m_discs.count())
        , m_in(m_discs.count())
        , m_recorder(m_discs.count(), settings.keepDetail) {}

    Timeline run() {
        for (Index i = 0; i < m_discs.count(); ++i)
            record(i);
        for (Index i = 0; i < m_discs.count(); ++i)
            findNext(i, i + 1);
        for (;;) {
            const Index first = earliest();
            const Next next = m_next[first];
            if (next.kind == Kind::None)
                return finish(m_discs.allAtRest() ? EndReason::AtRest : EndReason::NoMoreCollisions);
            if (next.time > m_until)
                return finish(EndReason::Until);
            if (next.kind != Kind::LaneEdge && m_recorder.collisionCount() >= m_maxCollisions)
                return finish(EndReason::MaxCollisions);
            m_now = next.time;
            happen(first, next);
        }
    }

private:
    using Index = std::size_t;
    static constexpr Index nobody = Index(-1);

    enum class Kind : unsigned char { None, Pair, Wall, LaneEdge };
    struct Next {
        Real time = std::numeric_limits<Real>::infinity();
        unsigned partner = 0; // of a pair
        Kind kind = Kind::None;
        unsigned char detail = 0; // which Side or LaneEvent
    };

    Place place(Index i) const { return HasLane ? m_places[i] : Place::Play; }
    bool inPlay(Index i) const { return place(i) == Place::Play; }

    Index earliest() const {
        Index best = 0;
        for (Index i = 1; i < m_next.size(); ++i)
            if (m_next[i].time < m_next[best].time)
                best = i;
        return best;
    }

    // The next event of one body on its own: a wall, an edge of the lane.
    Next findOwn(Index i) const {
        Next own;
        if constexpr (HasFrame || HasLane) {
            const Vec2<Real> p = m_discs.positionAt(i, m_now);
            const Vec2<Real> v = m_discs.velocity(i);
            const Real radius = m_discs.radiusOf(i);
            if constexpr (HasFrame)
                considerWalls(p, v, radius, own);
            if constexpr (HasLane) {
                const auto edge = nextLaneEvent(m_lane, p, v, radius, m_places[i]);
                if (edge.event != LaneEvent::None && m_now + edge.in < own.time)
                    own = {m_now + edge.in, 0, Kind::LaneEdge, static_cast<unsigned char>(edge.event)};
            }
        }
        return own;
    }

    void considerWalls(const Vec2<Real>& p, const Vec2<Real>& v, const Real& radius, Next& own) const {
        for (const Side side : sides) {
            const auto a = approachTo(side, m_walls.at[int(side)], p, v, radius);
            if (!(a.speed > 0) || a.gap == std::numeric_limits<Real>::infinity())
                continue;
            const Real time = m_now + (a.gap > 0 ? Real(a.gap / a.speed) : Real(0));
            if (time < own.time)
                own = {time, 0, Kind::Wall, static_cast<unsigned char>(side)};
        }
    }

    // Finds what happens next to body i, by itself or with bodies from `from` on. Each pair is looked at by
    // the one that changed course last, so a body that only waits to be struck keeps no event and is not
    // asked again.
    void findNext(Index i, Index from = 0) {
        m_next[i] = findOwn(i);
        if (!inPlay(i))
            return;
        m_discs.timesToImpact(i, from, m_now, m_in.data());
        for (Index j = from; j < m_discs.count(); ++j) {
            if (!(m_in[j] < std::numeric_limits<Real>::infinity()) || !inPlay(j))
                continue;
            const Real time = m_now + m_in[j];
            if (time < m_next[i].time)
                m_next[i] = {time, unsigned(j), Kind::Pair, 0};
        }
    }

    void happen(Index i, const Next& event) {
        switch (event.kind) {
        case Kind::Pair:
            return collidePair(std::min<Index>(i, event.partner), std::max<Index>(i, event.partner));
        case Kind::Wall:
            return collideWall(i, Side(event.detail));
        case Kind::LaneEdge:
            return crossEdge(i, LaneEvent(event.detail));
        case Kind::None:
            return;
        }
    }

    void collidePair(Index i, Index j) {
        m_discs.moveTo(i, m_now);
        m_discs.moveTo(j, m_now);
        const auto steps = collide(m_discs.disc(i), m_discs.disc(j), m_restitution);
        // Where they graze, rounding can bring them together as they already part: a contact never pulls.
        if (steps.rotated.first.x >= steps.rotated.second.x)
            return changedCourse(i, j);
        m_discs.setVelocity(i, steps.after.first);
        m_discs.setVelocity(j, steps.after.second);
        m_recorder.collision(static_cast<double>(m_now), int(i), int(j), Side::Left, steps);
        changedCourse(i, j);
    }

    void collideWall(Index i, Side side) {
        m_discs.moveTo(i, m_now);
        const auto steps = collideWithSide(m_discs.disc(i), side, m_walls.restitution);
        m_discs.setVelocity(i, steps.after.first);
        m_recorder.collision(static_cast<double>(m_now), int(i), -1, side, steps);
        changedCourse(i, nobody);
    }

    void crossEdge(Index i, LaneEvent event) {
        m_discs.moveTo(i, m_now);
        const Place before = m_places[i];
        Vec2<Real> v = m_discs.velocity(i);
        applyLaneEvent(event, v, m_places[i]);
        m_discs.setVelocity(i, v);
        if (m_places[i] != before)
            m_recorder.departure({static_cast<double>(m_now), int(i), m_places[i]});
        changedCourse(i, nobody);
    }

    // Bodies i and j (or i alone) move otherwise from now on: they and whoever counted on them look again.
    void changedCourse(Index i, Index j) {
        m_lookAgain.clear();
        for (Index k = 0; k < m_next.size(); ++k) {
            const bool countedOnThem =
                m_next[k].kind == Kind::Pair && (m_next[k].partner == i || m_next[k].partner == j);
            if (k == i || k == j || countedOnThem)
                m_lookAgain.push_back(k);
        }
        record(i);
        if (j != nobody)
            record(j);
        for (const Index k : m_lookAgain)
            findNext(k);
    }

    void record(Index i) {
        m_recorder.segment(int(i), {static_cast<double>(m_discs.since(i)),
                                    convert<double>(m_discs.position(i)),
                                    convert<double>(m_discs.velocity(i)),
                                    {},
                                    place(i)});
    }

    Timeline finish(EndReason reason) {
        const bool toTheEnd = reason == EndReason::Until || reason == EndReason::NoMoreCollisions;
        return m_recorder.finish(static_cast<double>(toTheEnd ? m_until : m_now), reason);
    }

    Real m_restitution;
    Walls<Real> m_walls;
    LaneEdges<Real> m_lane;
    Real m_until;
    std::int64_t m_maxCollisions;
    Real m_now{0};
    MovingDiscs<Real> m_discs;
    std::vector<Place> m_places; // of a scene with a lane
    std::vector<Next> m_next;
    std::vector<Real> m_in;         // of the last timesToImpact()
    std::vector<Index> m_lookAgain; // of the last changedCourse()
    Recorder m_recorder;
};

} // namespace thetalane

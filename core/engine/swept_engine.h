// The swept engine: fixed steps, and within each the instant at which two bodies touch.
//
// At the step's start it is found for every pair and wall when they will meet within the step, and contacts
// are exchanged in the order of time, the two moved to their instant; of one instant, in the order of the
// scene. A body looked at `passes` times goes on after its next contact unseen until the step ends: it may
// pass into others, and what approaches in overlap collides at the start of the next step; what parts, never.
// With passes without end this is the next-event engine, a step at a time, without its rules for ties and for
// contacts that last.
//
// What a body does by itself (its friction changes, it leaves the lane) is never missed.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/near_in_step.h"
#include "core/engine/step_motion.h"
#include "core/engine/surroundings.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace thetalane {

template <class Real, class Models> class SweptEngine {
public:
    SweptEngine(const Scene& scene, const EngineSettings& settings)
        : m_settings(settings)
        , m_restitution(scene.restitution)
        , m_around(scene)
        , m_motion(scene, Real(settings.step))
        , m_near(scene)
        , m_looks(scene.bodies.size(), settings.passes)
        , m_course(scene.bodies.size())
        , m_recorder(scene.bodies.size(), settings.keepDetail) {}

    Timeline run() {
        for (Index i = 0; i < count(); ++i)
            record(i, 0);
        if (m_motion.allAtRest())
            return m_recorder.finish(0, EndReason::AtRest);
        const double step = m_settings.step, until = m_settings.until;
        // A whole number of steps that misses `until` by rounding alone reaches it.
        const auto whole = std::int64_t(until / step * (1 + 1e-12));
        for (std::int64_t k = 0; k < whole; ++k) {
            m_from = double(k) * step;
            m_to = std::min(double(k + 1) * step, until);
            if (const auto reason = goThrough(Real(step)))
                return m_recorder.finish(m_last, *reason);
            m_motion.nextStep();
        }
        m_from = double(whole) * step;
        m_to = until;
        if (until - m_from > step * 1e-9)
            if (const auto reason = goThrough(Real(until - m_from)))
                return m_recorder.finish(m_last, *reason);
        return m_recorder.finish(until, EndReason::Until);
    }

private:
    using Index = std::size_t;
    static constexpr Index nobody = Index(-1);

    // What would happen in this step, if neither body changes course before.
    struct Candidate {
        Real time;
        Index first, second; // nobody: a body by itself, or with a wall
        EventKind kind;
        unsigned char detail; // which Side or LaneEvent
        unsigned firstCourse, secondCourse;

        auto order() const { return std::tuple(time, first, second, kind, detail); }
    };

    Index count() const { return m_motion.discs().count(); }
    const auto& discs() const { return m_motion.discs(); }
    bool seen(Index i) const { return m_looks[i] > 0; }
    double absolute(const Real& now) const { return std::min(m_from + static_cast<double>(now), m_to); }

    // One step of length `end`; a reason to go no further.
    std::optional<EndReason> goThrough(const Real& end) {
        m_end = end;
        m_near.forEachPair(discs(), end, [this](Index i, Index j) { lookAtPair(i, j, Real(0)); });
        for (Index i = 0; i < count(); ++i)
            lookAtOwn(i, Real(0));
        const bool eventful = !m_candidates.empty();
        while (!m_candidates.empty()) {
            const Candidate c = takeFirst();
            if (c.firstCourse != m_course[c.first] ||
                (c.second != nobody && c.secondCourse != m_course[c.second]))
                continue;
            if (isContact(c.kind) && m_recorder.collisionCount() >= m_settings.maxCollisions)
                return EndReason::MaxCollisions;
            m_last = absolute(c.time);
            happen(c);
        }
        for (const Index i : m_struck)
            m_looks[i] = m_settings.passes;
        m_struck.clear();
        return eventful && m_motion.allAtRest() ? std::optional(EndReason::AtRest) : std::nullopt;
    }

    static bool later(const Candidate& a, const Candidate& b) { return a.order() > b.order(); }

    void add(const Candidate& c) {
        m_candidates.push_back(c);
        std::push_heap(m_candidates.begin(), m_candidates.end(), later);
    }
    Candidate takeFirst() {
        std::pop_heap(m_candidates.begin(), m_candidates.end(), later);
        const Candidate c = m_candidates.back();
        m_candidates.pop_back();
        return c;
    }

    void lookAtPair(Index i, Index j, const Real& now) {
        if (!m_around.inPlay(i) || !m_around.inPlay(j))
            return;
        const Vec2<Real> v = discs().velocityAt(i, now), u = discs().velocityAt(j, now);
        const Vec2<Real> apart = discs().positionAt(i, now) - discs().positionAt(j, now);
        const Real reach = discs().radiusOf(i) + discs().radiusOf(j), speed2 = dot(v, v) + dot(u, u);
        Real horizon = m_end - now, in;
        if constexpr (Models::friction) {
            horizon = std::min(horizon, Real(std::min(discs().until(i), discs().until(j)) - now));
            in = timeToImpact<Real>(apart, v - u, discs().acceleration(i) - discs().acceleration(j), reach,
                                    speed2, horizon);
        } else {
            in = timeToImpact<Real>(apart, v - u, reach, speed2);
        }
        if (in <= horizon)
            add({now + in, std::min(i, j), std::max(i, j), EventKind::Pair, 0, m_course[std::min(i, j)],
                 m_course[std::max(i, j)]});
    }

    void addOwn(Index i, const Real& time, EventKind kind, int detail) {
        if (time <= m_end)
            add({time, i, nobody, kind, static_cast<unsigned char>(detail), m_course[i], 0});
    }

    void lookAtOwn(Index i, const Real& now) {
        if (m_motion.atRest(i))
            return;
        if constexpr (Models::friction)
            addOwn(i, std::max(discs().until(i), now), EventKind::StretchEnd, 0);
        if constexpr (!Models::frame && !Models::lane)
            return;
        const Vec2<Real> p = discs().positionAt(i, now), v = discs().velocityAt(i, now),
                         a = discs().acceleration(i);
        const Real r = discs().radiusOf(i);
        if (seen(i))
            m_around.forEachWall(i, [&](EventKind kind, Side side, const Real& wall) {
                const auto gap = approachTo(side, wall, p, v, r);
                const Real away = gap.gap > Real(0) ? gap.gap : Real(0);
                if (away == Real(0) && !(gap.speed > Real(0))) // it parts, or is just about to turn
                    return;
                const Real in = Models::friction      ? timeToCross<Real>(away, gap.speed,
                                                                     approachTo(side, wall, p, a, r).speed)
                                : gap.speed > Real(0) ? Real(away / gap.speed)
                                                      : std::numeric_limits<Real>::infinity();
                addOwn(i, now + in, kind, int(side));
            });
        if constexpr (Models::lane) {
            const auto edge = nextLaneEvent<Real>(m_around.lane(), p, v, a, r, m_around.placeOf(i));
            if (edge.event != LaneEvent::None)
                addOwn(i, now + edge.in, EventKind::LaneEdge, int(edge.event));
        }
    }

    void happen(const Candidate& c) {
        m_motion.moveTo(c.first, c.time);
        const Vec2<Real> v = discs().velocity(c.first);
        if (c.kind == EventKind::Pair) {
            m_motion.moveTo(c.second, c.time);
            return collidePair(c);
        }
        if (isContact(c.kind))
            return collideWall(c);
        if constexpr (Models::lane)
            if (c.kind == EventKind::LaneEdge)
                return crossEdge(c);
        goOn(c.first, v, c.time);
        look(c.first, c.time);
    }

    void collidePair(const Candidate& c) {
        const auto steps = collide(discs().disc(c.first), discs().disc(c.second), m_restitution);
        const bool approach = steps.rotated.first.x < steps.rotated.second.x; // a contact never pulls
        if (approach)
            m_recorder.collision(m_last, int(c.first), int(c.second), Side::Left, steps);
        struck(c.first);
        struck(c.second);
        goOn(c.first, approach ? steps.after.first : steps.before.first, c.time);
        goOn(c.second, approach ? steps.after.second : steps.before.second, c.time);
        look(c.first, c.time);
        look(c.second, c.time);
    }

    void collideWall(const Candidate& c) {
        const Side side = Side(c.detail);
        const auto steps = collideWithSide(discs().disc(c.first), side, m_around.restitutionOf(c.kind));
        m_recorder.collision(m_last, int(c.first), -1, side, steps);
        struck(c.first);
        goOn(c.first, steps.after.first, c.time);
        look(c.first, c.time);
    }

    void crossEdge(const Candidate& c) {
        LanePlace& where = m_around.placeOf(c.first);
        const Place before = where.place;
        Vec2<Real> v = discs().velocity(c.first);
        applyLaneEvent(LaneEvent(c.detail), m_around.lane(), discs().position(c.first), v, where);
        if (where.place != before)
            m_recorder.departure({m_last, int(c.first), where.place});
        goOn(c.first, v, c.time);
        look(c.first, c.time);
    }

    void struck(Index i) {
        --m_looks[i];
        m_struck.push_back(i);
    }

    // Body i, moved to `now`, on its new course.
    void goOn(Index i, const Vec2<Real>& v, const Real& now) {
        m_motion.goOn(i, v, now, m_around.inPlay(i));
        if constexpr (Models::friction && Models::lane)
            if (m_around.placeOf(i).flying != 0 && m_motion.atRest(i)) { // over the gutter
                m_around.placeOf(i) = {Place::Gutter};
                m_recorder.departure({m_last, int(i), Place::Gutter});
            }
        ++m_course[i];
        record(i, m_last);
    }

    void look(Index i, const Real& now) {
        lookAtOwn(i, now);
        if (!seen(i) || !m_around.inPlay(i))
            return;
        for (Index j = 0; j < count(); ++j)
            if (j != i && seen(j))
                lookAtPair(i, j, now);
    }

    void record(Index i, double time) { m_motion.record(m_recorder, i, time, m_around.place(i)); }

    EngineSettings m_settings;
    Real m_restitution;
    Surroundings<Real, Models> m_around;
    StepMotion<Real, Models::friction> m_motion;
    NearInStep<Real> m_near;
    std::vector<int> m_looks;       // left in this step; none: not seen until it ends
    std::vector<unsigned> m_course; // how often each has changed course
    std::vector<Index> m_struck;    // in this step
    std::vector<Candidate> m_candidates;
    Recorder m_recorder;
    double m_from = 0; // the present step [s]
    double m_to = 0;
    Real m_end{};      // its length
    double m_last = 0; // when something last happened [s]
};

} // namespace thetalane

// The next-event engine: from contact to contact, each at its own instant, exact between them.
//
// Each disc keeps its own time (it moves only when something happens to it) and its one next event; a next
// event whose partner changed course meanwhile is found again. An impulse passes only between approaching
// bodies, and bodies that overlap by rounding and approach collide at once, so that none passes through
// another. How partners and the earliest event are found is the Search's business: AllPairs or Cells.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/surroundings.h"
#include "core/timeline/recorder.h"

#include <algorithm>

namespace thetalane {

template <class Real, bool HasFrame, bool HasLane, template <class> class Search> class NextEventEngine {
public:
    NextEventEngine(const Scene& scene, const EngineSettings& settings)
        : m_restitution(scene.restitution)
        , m_settings(settings)
        , m_until(settings.until)
        , m_around(scene)
        , m_search(scene)
        , m_recorder(scene.bodies.size(), settings.keepDetail) {}

    Timeline run() {
        if (m_recorder.keepsDetail())
            recordAll();
        m_search.start(m_around);
        for (;;) {
            const auto found = m_search.earliest(m_around);
            const auto& next = found.event;
            if (next.kind == EventKind::None)
                return finish(discs().allAtRest() ? EndReason::AtRest : EndReason::NoMoreCollisions);
            if (next.time > m_until)
                return finish(EndReason::Until);
            if (next.kind != EventKind::LaneEdge && m_recorder.collisionCount() >= m_settings.maxCollisions)
                return finish(EndReason::MaxCollisions);
            m_now = next.time;
            happen(found.body, next);
            if constexpr (Search<Real>::rebasesTime)
                rebaseTime();
        }
    }

private:
    using Index = std::size_t;
    static constexpr Index nobody = Search<Real>::nobody;

    auto& discs() { return m_search.discs(); }

    void happen(Index i, const NextEvent<Real>& event) {
        switch (event.kind) {
        case EventKind::Pair:
            return collidePair(std::min<Index>(i, event.partner), std::max<Index>(i, event.partner));
        case EventKind::Wall:
            return collideWall(i, Side(event.detail));
        case EventKind::LaneEdge:
            return crossEdge(i, LaneEvent(event.detail));
        default:
            return;
        }
    }

    void collidePair(Index i, Index j) {
        discs().moveTo(i, m_now);
        discs().moveTo(j, m_now);
        const auto steps = collide(discs().disc(i), discs().disc(j), m_restitution);
        // Where they graze, rounding can bring them together as they already part: a contact never pulls.
        if (steps.rotated.first.x >= steps.rotated.second.x)
            return changedCourse(i, j);
        discs().setVelocity(i, steps.after.first);
        discs().setVelocity(j, steps.after.second);
        m_recorder.collision(absolute(m_now), int(i), int(j), Side::Left, steps);
        changedCourse(i, j);
    }

    void collideWall(Index i, Side side) {
        discs().moveTo(i, m_now);
        const auto steps = collideWithSide(discs().disc(i), side, m_around.walls().restitution);
        discs().setVelocity(i, steps.after.first);
        m_recorder.collision(absolute(m_now), int(i), -1, side, steps);
        changedCourse(i, nobody);
    }

    void crossEdge(Index i, LaneEvent event) {
        discs().moveTo(i, m_now);
        const Place before = m_around.place(i);
        Vec2<Real> v = discs().velocity(i);
        applyLaneEvent(event, v, m_around.placeOf(i));
        discs().setVelocity(i, v);
        if (m_around.place(i) != before)
            m_recorder.departure({absolute(m_now), int(i), m_around.place(i)});
        changedCourse(i, nobody);
    }

    void changedCourse(Index i, Index j) {
        if (m_recorder.keepsDetail()) {
            record(i);
            if (j != nobody)
                record(j);
        }
        m_search.changedCourse(m_around, i, j, m_now);
    }

    // A summary keeps the last segments alone: those are what the discs know at the end.
    void record(Index i) {
        m_recorder.segment(int(i), {absolute(discs().since(i)),
                                    convert<double>(discs().position(i)),
                                    convert<double>(discs().velocity(i)),
                                    {},
                                    m_around.place(i)});
    }

    void recordAll() {
        for (Index i = 0; i < discs().count(); ++i)
            record(i);
    }

    // Times in the engine count from m_epoch, which follows the run: the later, the less of a double would be
    // left for the gaps between discs. Once in many events of each disc; by few enough bits to be exact.
    void rebaseTime() {
        constexpr std::size_t eventsOfEach = 64;
        if (++m_events < eventsOfEach * discs().count())
            return;
        m_events = 0;
        const Real shift = Real(static_cast<float>(m_now) * 0.999f);
        m_epoch = m_epoch + shift;
        m_now = m_now - shift;
        m_until = m_until - shift;
        m_search.shiftTime(shift);
    }

    double absolute(const Real& time) const { return static_cast<double>(Real(m_epoch + time)); }

    Timeline finish(EndReason reason) {
        if (!m_recorder.keepsDetail())
            recordAll();
        const bool toTheEnd = reason == EndReason::Until || reason == EndReason::NoMoreCollisions;
        return m_recorder.finish(toTheEnd ? static_cast<double>(Real(m_settings.until)) : absolute(m_now),
                                 reason);
    }

    Real m_restitution;
    EngineSettings m_settings;
    Real m_epoch{0};
    Real m_now{0};
    Real m_until;
    std::size_t m_events = 0;
    Surroundings<Real, HasFrame, HasLane> m_around;
    Search<Real> m_search;
    Recorder m_recorder;
};

} // namespace thetalane

// The next-event engine: from contact to contact, each at its own instant, exact between them.
//
// Each disc keeps its own time (it moves only when something happens to it) and its one next event; a next
// event whose partner changed course meanwhile is found again. An impulse passes only between approaching
// bodies, and bodies that overlap by rounding and approach collide at once, so that none passes through
// another. How partners and the earliest event are found is the Search's business: AllPairs or Cells. Where
// more than two meet at once, and where friction presses them together, Settlement and Pressing decide.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/engine_state.h"
#include "core/engine/first_event.h"
#include "core/engine/settlement.h"

#include <algorithm>

namespace thetalane {

template <class Real, class Models, template <class, bool> class SearchFor>
class NextEventEngine : private EngineState<Real, Models, SearchFor<Real, Models::friction>> {
public:
    using Search = SearchFor<Real, Models::friction>;
    using State = EngineState<Real, Models, Search>;

    NextEventEngine(const Scene& scene, const EngineSettings& settings)
        : State(scene, settings.until)
        , m_restitution(scene.restitution)
        , m_settings(settings)
        , m_recorder(scene.bodies.size(), settings.keepDetail)
        , m_settlement(scene, m_search, m_around, m_recorder, settings.ties) {}

    // To go on from where another engine of the same scene and settings was; settings.keepDetail may differ.
    NextEventEngine(const Scene& scene, const EngineSettings& settings, const State& state)
        : State(state)
        , m_restitution(scene.restitution)
        , m_settings(settings)
        , m_recorder(scene.bodies.size(), settings.keepDetail)
        , m_settlement(scene, m_search, m_around, m_recorder, settings.ties) {}

    // The rooms refer to each other.
    NextEventEngine(const NextEventEngine&) = delete;
    NextEventEngine& operator=(const NextEventEngine&) = delete;

    Timeline run() {
        begin();
        return finish(
            goOn([this](const Real&) { return m_recorder.collisionCount() >= m_settings.maxCollisions; }));
    }

    // The same in steps. First begin(), or resume() in an engine made from a state; then goOn(), which ends
    // with MaxCollisions when `full(time)` says so before a contact at that time; finish().
    void begin() {
        if constexpr (Models::friction)
            for (Index i = 0; i < discs().count(); ++i)
                m_floor.begin(discs(), i, Real(0), true, {}, Real(0));
        if (m_recorder.keepsDetail())
            recordAll();
        m_search.start(m_around);
    }
    void resume() {
        if constexpr (requires(Search & search) { search.resume(); })
            m_search.resume();
        if (m_recorder.keepsDetail())
            recordAll();
    }
    template <class Full> EndReason goOn(Full&& full) {
        for (;;) {
            const FirstEvent<Real> first = m_search.earliest(m_around);
            if (first.event.kind == EventKind::None)
                return discs().allAtRest() ? EndReason::AtRest : EndReason::NoMoreCollisions;
            if (first.event.time > m_until)
                return EndReason::Until;
            if (isContact(first.event.kind) && full(first.event.time))
                return EndReason::MaxCollisions;
            m_now = first.event.time;
            happen(first);
            if constexpr (Search::rebasesTime)
                rebaseTime();
        }
    }
    Timeline finish(EndReason reason) {
        const bool toTheEnd = reason == EndReason::Until || reason == EndReason::NoMoreCollisions;
        return finish(reason, toTheEnd ? static_cast<double>(Real(m_settings.until)) : absolute(m_now));
    }
    Timeline finish(EndReason reason, double end) {
        if (!m_recorder.keepsDetail())
            recordAll();
        if constexpr (Models::friction)
            m_around.held().release([](const ContactName&) { return true; }, end, m_recorder);
        return m_recorder.finish(end, reason);
    }

    const State& state() const { return *this; }
    double now() const { return absolute(m_now); } // s
    double absolute(const Real& time) const { return static_cast<double>(Real(m_epoch + time)); }
    std::int64_t collisionCount() const { return m_recorder.collisionCount(); } // since it began or resumed

private:
    using Index = std::size_t;
    static constexpr Index nobody = Search::nobody;
    using State::m_around;
    using State::m_epoch;
    using State::m_events;
    using State::m_eventsNow;
    using State::m_floor;
    using State::m_lastContact;
    using State::m_now;
    using State::m_search;
    using State::m_started;
    using State::m_stuckAt;
    using State::m_until;

    auto& discs() { return m_search.discs(); }

    void happen(const FirstEvent<Real>& first) {
        const NextEvent<Real>& event = first.event;
        if (event.kind == EventKind::LaneEdge)
            return crossEdge(first.body, LaneEvent(event.detail));
        if constexpr (Models::friction)
            return settle(nameOf(first));
        if (const bool again = isSameInstant(); again || first.tied)
            return settle(nameOf(first));
        if (event.kind == EventKind::Pair)
            collidePair(std::min<Index>(first.body, event.partner),
                        std::max<Index>(first.body, event.partner));
        else
            collideWall(first.body, Side(event.detail), m_around.restitutionOf(event.kind));
    }

    static ContactName nameOf(const FirstEvent<Real>& first) {
        if (first.event.kind == EventKind::Pair)
            return {std::min<Index>(first.body, first.event.partner),
                    std::max<Index>(first.body, first.event.partner), Side::Left};
        return {first.body, nobody, Side(first.event.kind == EventKind::StretchEnd ? 0 : first.event.detail)};
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

    void collideWall(Index i, Side side, const Real& restitution) {
        discs().moveTo(i, m_now);
        const auto steps = collideWithSide(discs().disc(i), side, restitution);
        discs().setVelocity(i, steps.after.first);
        m_recorder.collision(absolute(m_now), int(i), -1, side, steps);
        changedCourse(i, nobody);
    }

    // All that touch at this instant, together.
    void settle(const ContactName& event) {
        m_settlement.gather(event, m_now, [this](Index b) { moveTo(b); });
        const auto& bodies = m_settlement.bodies();
        if constexpr (Models::friction) {
            Pressing<Real> pressing(m_floor, discs(), m_settings.contactTime);
            m_settlement.reflect(absolute(m_now), [&](const auto& touch, const auto& v) {
                return pressing.slowestRebound(m_settlement.touches(), touch, v);
            });
            const Real still = pressing.restingSpeed(m_settlement.touches(), m_settlement.velocities());
            m_settlement.stopBelow(still);
            for (Index k = 0; k < bodies.size(); ++k)
                m_floor.calm(bodies[k], m_settlement.velocities()[k], still);
            pressing.solve(bodies, m_settlement.touches(), m_settlement.velocities());
            hold(pressing);
            if (isStuck())
                for (const auto& touch : m_settlement.touches())
                    m_around.held().hold(touch.name, absolute(m_now));
            for (Index k = 0; k < bodies.size(); ++k)
                goOn(bodies[k], m_settlement.velocities()[k], pressing.pushes()[k], pressing.holdsFor());
        } else {
            m_settlement.reflect(absolute(m_now), [](const auto&, const auto&) { return Real(0); });
            for (Index k = 0; k < bodies.size(); ++k)
                discs().setVelocity(bodies[k], m_settlement.velocities()[k]);
        }
        if (m_recorder.keepsDetail())
            for (const Index b : bodies)
                record(b);
        m_search.changedCourse(m_around, std::span<const Index>(bodies), m_now);
    }

    // A contact at what is still the instant of the last one: bodies that touch pass something on, which may
    // go to and fro below all rounding. Then all that touch are looked at together.
    bool isSameInstant() {
        const bool again = m_now - m_lastContact <= tieWindow<Real>(m_now);
        m_lastContact = m_now;
        return again;
    }

    // Events without end at one instant, which only rounding can make: what touches is then held as it is.
    bool isStuck() {
        m_eventsNow = m_now == m_stuckAt ? m_eventsNow + 1 : 0;
        m_stuckAt = m_now;
        return m_eventsNow > 64 * discs().count();
    }

    void moveTo(Index i) {
        if constexpr (Models::friction)
            m_floor.moveTo(discs(), i, m_now);
        else
            discs().moveTo(i, m_now);
    }

    // Friction alone: body i goes on from where it is.
    void goOn(Index i, const Vec2<Real>& v, const Vec2<Real>& push, const Real& atMost) {
        discs().setVelocity(i, v);
        if constexpr (Models::lane)
            if (m_around.placeOf(i).flying != 0 && v == Vec2<Real>{} && push == Vec2<Real>{} &&
                m_around.inPlay(i))
                leavePlay(i, Place::Gutter);
        m_floor.begin(discs(), i, m_now, m_around.inPlay(i), push, atMost);
    }

    void hold(const Pressing<Real>& pressing) {
        const auto& touches = m_settlement.touches();
        const auto& bodies = m_settlement.bodies();
        const auto concerns = [&](Index b) {
            return std::find(bodies.begin(), bodies.end(), b) != bodies.end();
        };
        const auto stays = [&](const ContactName& name) {
            return std::any_of(pressing.pressed().begin(), pressing.pressed().end(),
                               [&](Index k) { return touches[k].name == name; });
        };
        m_around.held().release(
            [&](const ContactName& name) {
                return (concerns(name.first) || (!name.isWall() && concerns(name.second))) && !stays(name);
            },
            absolute(m_now), m_recorder);
        for (const Index k : pressing.pressed())
            m_around.held().hold(touches[k].name, absolute(m_now));
    }

    void crossEdge(Index i, LaneEvent event) {
        if constexpr (!Models::lane) {
            return;
        } else {
            moveTo(i);
            LanePlace& where = m_around.placeOf(i);
            const Place before = where.place;
            Vec2<Real> v = discs().velocity(i);
            applyLaneEvent(event, m_around.lane(), discs().position(i), v, where);
            discs().setVelocity(i, v);
            if (where.place != before)
                m_recorder.departure({absolute(m_now), int(i), where.place});
            if constexpr (Models::friction) {
                m_floor.begin(discs(), i, m_now, m_around.inPlay(i), {}, Real(0)); // with its new velocity
                const auto partners = m_around.held().partnersOf(i);
                settle({i, nobody, Side::Left});
                for (const Index partner : partners)
                    settle({partner, nobody, Side::Left});
            } else {
                changedCourse(i, nobody);
            }
        }
    }

    void leavePlay(Index i, Place place) {
        m_around.placeOf(i) = {place};
        m_recorder.departure({absolute(m_now), int(i), place});
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
        const Segment segment{startOf(i), convert<double>(discs().position(i)),
                              convert<double>(discs().velocity(i)), convert<double>(discs().acceleration(i)),
                              m_around.place(i)};
        if constexpr (Models::friction)
            m_recorder.segment(int(i), segment, m_floor.rotation(i));
        else
            m_recorder.segment(int(i), segment);
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
        std::vector<double> starts(discs().count());
        for (Index i = 0; i < starts.size(); ++i)
            starts[i] = startOf(i);
        m_epoch = m_epoch + shift;
        m_now = m_now - shift;
        m_until = m_until - shift;
        m_lastContact = m_lastContact - shift;
        m_search.shiftTime(shift);
        m_started.resize(starts.size());
        for (Index i = 0; i < starts.size(); ++i)
            m_started[i] = {discs().since(i), starts[i]};
    }

    // When body i's present stretch of motion began: as it was recorded then, whatever was shifted since.
    double startOf(Index i) const {
        if constexpr (Search::rebasesTime)
            if (!m_started.empty() && m_started[i].since == m_search.discs().since(i))
                return m_started[i].absolute;
        return absolute(m_search.discs().since(i));
    }

    Real m_restitution;
    EngineSettings m_settings;
    Recorder m_recorder;
    Settlement<Real, Models, Search> m_settlement;
};

} // namespace thetalane

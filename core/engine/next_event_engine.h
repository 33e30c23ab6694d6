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
            if (first.event.time > m_clock.until())
                return EndReason::Until;
            if (isContact(first.event.kind) && full(first.event.time))
                return EndReason::MaxCollisions;
            m_clock.set(first.event.time);
            happen(first);
            if constexpr (Search::rebasesTime)
                m_clock.followEvents(m_search);
        }
    }
    Timeline finish(EndReason reason) {
        const bool toTheEnd = reason == EndReason::Until || reason == EndReason::NoMoreCollisions;
        return finish(reason, toTheEnd ? static_cast<double>(Real(m_settings.until)) : now());
    }
    Timeline finish(EndReason reason, double end) {
        if (!m_recorder.keepsDetail())
            recordAll();
        if constexpr (Models::friction)
            m_around.held().release([](const ContactName&) { return true; }, end, m_recorder);
        return m_recorder.finish(end, reason);
    }

    const State& state() const { return *this; }
    double now() const { return m_clock.absolute(); } // s
    double absolute(const Real& time) const { return m_clock.absolute(time); }
    std::int64_t collisionCount() const { return m_recorder.collisionCount(); } // since it began or resumed

private:
    using Index = std::size_t;
    static constexpr Index nobody = Search::nobody;
    using State::m_around;
    using State::m_clock;
    using State::m_floor;
    using State::m_search;

    auto& discs() { return m_search.discs(); }

    void happen(const FirstEvent<Real>& first) {
        const NextEvent<Real>& event = first.event;
        if (event.kind == EventKind::LaneEdge)
            return crossEdge(first.body, LaneEvent(event.detail));
        if constexpr (Models::friction) {
            if (!isOnItsOwn(first))
                return settle(nameOf(first));
            if (event.kind == EventKind::StretchEnd)
                return goOnAlone(first.body);
            const ContactName pair = nameOf(first);
            return collidePair(pair.first, pair.second);
        }
        if (const bool again = m_clock.isInstantOfLastContact(); again || first.tied)
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
        moveTo(i);
        moveTo(j);
        const Disc<Real> first = discs().disc(i), second = discs().disc(j);
        // A summary is spared what it does not ask for: the check, and the writing down.
        const auto contact = contactOf(first.position, second.position);
        const auto rotated = rotateIn(VelocityPair<Real>{first.velocity, second.velocity}, contact);
        // Where they graze, rounding can bring them together as they already part: a contact never pulls.
        if (rotated.first.x >= rotated.second.x) {
            setOff(i, first.velocity);
            setOff(j, second.velocity);
            return changedCourse(i, j);
        }
        const auto after =
            rotateBack(exchangeAlong(rotated, first.mass, second.mass, m_restitution), contact);
        setOff(i, after.first);
        setOff(j, after.second);
        if (m_recorder.keepsDetail())
            m_recorder.collision(now(), int(i), int(j), Side::Left, collide(first, second, m_restitution));
        else
            m_recorder.countCollision(int(i), int(j), after);
        changedCourse(i, j);
    }

    void collideWall(Index i, Side side, const Real& restitution) {
        discs().moveTo(i, m_clock.now());
        const auto steps = collideWithSide(discs().disc(i), side, restitution);
        discs().setVelocity(i, steps.after.first);
        m_recorder.collision(now(), int(i), -1, side, steps);
        changedCourse(i, nobody);
    }

    // All that touch at this instant, together.
    void settle(const ContactName& event) {
        m_settlement.gather(event, m_clock.now(), [this](Index b) { moveTo(b); });
        const auto& bodies = m_settlement.bodies();
        if constexpr (Models::friction) {
            Pressing<Real> pressing(m_floor, discs(), m_settings.contactTime);
            const auto& touches = m_settlement.touches();
            const auto& velocities = m_settlement.velocities();
            m_settlement.reflect(now(),
                                 [&](const auto& v) { return pressing.slowestRebound(bodies, touches, v); });
            const Real still = pressing.restingSpeed(bodies, touches, velocities);
            m_settlement.stopBelow(still);
            m_settlement.change([&](Index k, Vec2<Real>& v) { m_floor.calm(bodies[k], v, still); });
            pressing.solve(bodies, touches, velocities);
            keepTogether(pressing);
            hold(pressing);
            if (m_clock.isStuck(discs().count(), m_settings.contactTime))
                return standStill();
            for (Index k = 0; k < bodies.size(); ++k)
                goOn(bodies[k], m_settlement.velocities()[k], pressing.pushes()[k], pressing.holdsFor());
        } else {
            m_settlement.reflect(now(), [](const auto&) { return Real(0); });
            for (Index k = 0; k < bodies.size(); ++k)
                discs().setVelocity(bodies[k], m_settlement.velocities()[k]);
        }
        if (m_recorder.keepsDetail())
            for (const Index b : bodies)
                record(b);
        m_search.changedCourse(m_around, std::span<const Index>(bodies), m_clock.now());
    }

    void moveTo(Index i) {
        if constexpr (Models::friction)
            m_floor.moveTo(discs(), i, m_clock.now());
        else
            discs().moveTo(i, m_clock.now());
    }

    // On a floor with friction: the end of a stretch of a body, or a meeting of two, that touches no contact
    // which lasts, begins none, and brings nobody to rest. Most events are such, and need no Settlement.
    bool isOnItsOwn(const FirstEvent<Real>& first) {
        const bool again = m_clock.isInstantOfLastContact();
        const EventKind kind = first.event.kind;
        if (again || first.tied || m_around.held().concerns(first.body))
            return false;
        if (kind == EventKind::StretchEnd)
            return true;
        const Index i = first.body, j = first.event.partner;
        return kind == EventKind::Pair && !m_around.held().concerns(j) && partsFast(i, j);
    }
    // After the collision, faster than friction can undo within the contact time.
    bool partsFast(Index i, Index j) {
        const Disc<Real> a{discs().massOf(i), Real(0), discs().positionAt(i, m_clock.now()),
                           discs().velocityAt(i, m_clock.now())};
        const Disc<Real> b{discs().massOf(j), Real(0), discs().positionAt(j, m_clock.now()),
                           discs().velocityAt(j, m_clock.now())};
        const auto contact = contactOf(a.position, b.position);
        const auto rotated = rotateIn(VelocityPair<Real>{a.velocity, b.velocity}, contact);
        const auto exchanged = exchangeAlong(rotated, a.mass, b.mass, m_restitution);
        const Real slow = 2 * m_floor.strongestFriction() * Real(m_settings.contactTime);
        return rotated.first.x < rotated.second.x && exchanged.first.x - exchanged.second.x > slow &&
               norm(exchanged.first) > slow && norm(exchanged.second) > slow;
    }
    void goOnAlone(Index i) {
        moveTo(i);
        setOff(i, discs().velocity(i));
        changedCourse(i, nobody);
    }

    // With a new velocity, nothing pushing.
    void setOff(Index i, const Vec2<Real>& v) {
        if constexpr (Models::friction)
            goOn(i, v, {}, Real(0));
        else
            discs().setVelocity(i, v);
    }

    // Friction alone: body i goes on from where it is.
    void goOn(Index i, const Vec2<Real>& v, const Vec2<Real>& push, const Real& atMost) {
        discs().setVelocity(i, v);
        if constexpr (Models::lane)
            if (m_around.placeOf(i).flying != 0 && v == Vec2<Real>{} && push == Vec2<Real>{} &&
                m_around.inPlay(i))
                leavePlay(i, Place::Gutter);
        m_floor.begin(discs(), i, m_clock.now(), m_around.inPlay(i), push, atMost);
    }

    // What rounding alone would keep busy without end rests where it is.
    void standStill() {
        m_settlement.standStill();
        for (const auto& touch : m_settlement.touches())
            m_around.held().hold(touch.name, now());
        for (const Index b : m_settlement.bodies()) {
            m_floor.roll(b, {});
            goOn(b, {}, {}, Real(0));
            if (m_recorder.keepsDetail())
                record(b);
        }
        m_search.changedCourse(m_around, std::span<const Index>(m_settlement.bodies()), m_clock.now());
    }

    // Balls that roll go on rolling.
    void keepTogether(Pressing<Real>& pressing) {
        if (pressing.pressed().empty())
            return;
        const auto& bodies = m_settlement.bodies();
        const auto& velocities = m_settlement.velocities();
        std::vector<Index> rolling;
        for (Index k = 0; k < bodies.size(); ++k)
            if (m_floor.slowness(bodies[k], velocities[k]) > Real(1))
                rolling.push_back(k);
        if (!m_settlement.keepTogether(pressing.pressed(), pressing.inverseMasses(bodies, velocities)))
            return;
        for (const Index k : rolling)
            m_floor.roll(bodies[k], velocities[k]);
        pressing.solve(bodies, m_settlement.touches(), velocities);
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
            now(), m_recorder);
        for (const Index k : pressing.pressed())
            m_around.held().hold(touches[k].name, now());
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
                m_recorder.departure({now(), int(i), where.place});
            if constexpr (Models::friction) {
                m_floor.begin(discs(), i, m_clock.now(), m_around.inPlay(i), {},
                              Real(0)); // with its new velocity
                if (!m_around.held().concerns(i))
                    return changedCourse(i, nobody);
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
        m_recorder.departure({now(), int(i), place});
    }

    void changedCourse(Index i, Index j) {
        if (m_recorder.keepsDetail()) {
            record(i);
            if (j != nobody)
                record(j);
        }
        m_search.changedCourse(m_around, i, j, m_clock.now());
    }

    // A summary keeps the last segments alone: those are what the discs know at the end.
    void record(Index i) {
        const Segment segment{m_clock.startOf(i, discs().since(i)), convert<double>(discs().position(i)),
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

    Real m_restitution;
    EngineSettings m_settings;
    Recorder m_recorder;
    Settlement<Real, Models, Search> m_settlement;
};

} // namespace thetalane

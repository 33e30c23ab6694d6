// The search for a few bodies: each disc is compared with all others, the earliest event is found by looking
// at all. Nothing is prepared and nothing kept, which no cleverness beats for a rack.
#pragma once

#include "core/engine/first_event.h"
#include "core/engine/moving_discs.h"
#include "core/engine/surroundings.h"

#include <span>
#include <vector>

namespace thetalane {

template <class Real, bool Accelerated> class AllPairs {
public:
    using Index = std::size_t;
    static constexpr Index nobody = Index(-1);
    static constexpr bool rebasesTime = false;

    explicit AllPairs(const Scene& scene)
        : m_discs(scene.bodies)
        , m_next(m_discs.count())
        , m_in(m_discs.count()) {}

    MovingDiscs<Real, Accelerated>& discs() { return m_discs; }
    const MovingDiscs<Real, Accelerated>& discs() const { return m_discs; }

    template <class Around> void start(const Around& around) {
        for (Index i = 0; i < m_discs.count(); ++i)
            findNext(around, i, Real(0), i + 1);
    }

    template <class Around> FirstEvent<Real> earliest(const Around&) const {
        Index best = 0;
        for (Index i = 1; i < m_next.size(); ++i)
            if (m_next[i].event.time < m_next[best].event.time)
                best = i;
        const NextEvent<Real>& event = m_next[best].event;
        return {best, event, m_next[best].tied || othersTie(best)};
    }

    // Bodies i and j (or i alone) move otherwise from now on: they and whoever counted on them look again.
    template <class Around> void changedCourse(const Around& around, Index i, Index j, const Real& now) {
        m_lookAgain.clear();
        for (Index k = 0; k < m_next.size(); ++k) {
            const NextEvent<Real>& next = m_next[k].event;
            const bool countedOnThem =
                next.kind == EventKind::Pair && (next.partner == i || next.partner == j);
            if (k == i || k == j || countedOnThem)
                m_lookAgain.push_back(k);
        }
        for (const Index k : m_lookAgain)
            findNext(around, k, now, 0);
    }
    template <class Around>
    void changedCourse(const Around& around, std::span<const Index> bodies, const Real& now) {
        const auto changed = [&](Index k) {
            return std::find(bodies.begin(), bodies.end(), k) != bodies.end();
        };
        m_lookAgain.clear();
        for (Index k = 0; k < m_next.size(); ++k)
            if (changed(k) || (m_next[k].event.kind == EventKind::Pair && changed(m_next[k].event.partner)))
                m_lookAgain.push_back(k);
        for (const Index k : m_lookAgain)
            findNext(around, k, now, 0);
    }

    // f(j) for every other body that could touch i.
    template <class F> void forEachNear(Index i, const Real&, F&& f) {
        for (Index j = 0; j < m_discs.count(); ++j)
            if (j != i)
                f(j);
    }

private:
    struct Slot {
        NextEvent<Real> event;
        bool tied = false; // another of the body's own contacts may come at the same instant
    };

    // Finds what happens next to body i, by itself or with bodies from `from` on. Each pair is looked at by
    // the one that changed course last, so a body that only waits to be struck keeps no event and is not
    // asked again.
    template <class Around> void findNext(const Around& around, Index i, const Real& now, Index from) {
        const Real never = std::numeric_limits<Real>::infinity();
        const Traveller<Real> traveller = travellerAt(i, now);
        NextEvent<Real> next;
        if constexpr (Around::hasFrame || Around::hasLane || Around::hasFriction)
            next = around.next(i, now, traveller);
        Real first = isContact(next.kind) ? next.time : never; // the first two contacts
        Real second = never;
        const auto meet = [&](Index j, const Real& time) {
            if (!(time < never) || j == i || !around.inPlay(j) || around.holdsPair(i, j))
                return;
            if (time < next.time)
                next = {time, unsigned(j), EventKind::Pair, 0};
            second = std::min(second, std::max(first, time));
            first = std::min(first, time);
        };
        if (!around.inPlay(i)) {
            // It meets nobody.
        } else if constexpr (Accelerated) { // whatever surely comes later than what is known need not be
                                            // solved
            for (Index pair = from / 2 * 2; pair < m_discs.count(); pair += 2) {
                const unsigned open = m_discs.mayMeet(traveller, pair, now, afterTies(next.time));
                for (Index j = std::max(from, pair); j < pair + 2; ++j)
                    if (j != i && (open >> (j - pair) & 1) != 0)
                        meet(j, now + m_discs.timeToImpactWith(traveller, j, now, afterTies(next.time)));
            }
        } else {
            m_discs.timesToImpact(i, from, now, m_in.data());
            for (Index j = from; j < m_discs.count(); ++j)
                meet(j, now + m_in[j]);
        }
        m_next[i] = {next, second - first <= tieWindow<Real>(first)};
    }

    static Real afterTies(const Real& time) { return time + 2 * tieWindow<Real>(time); }

    Traveller<Real> travellerAt(Index i, const Real& now) const {
        return {m_discs.positionAt(i, now), m_discs.velocityAt(i, now), m_discs.acceleration(i),
                m_discs.radiusOf(i), m_discs.until(i)};
    }

    // Another body's contact within the window, but for the partner's own entry of the same one.
    bool othersTie(Index best) const {
        const NextEvent<Real>& event = m_next[best].event;
        const Real last = event.time + tieWindow<Real>(event.time);
        bool tied = false;
        for (Index k = 0; k < m_next.size(); ++k) {
            const NextEvent<Real>& other = m_next[k].event;
            const bool same = other.kind == EventKind::Pair && other.partner == best &&
                              event.kind == EventKind::Pair && event.partner == k;
            tied |= k != best && other.time <= last && !same;
        }
        return tied;
    }

    MovingDiscs<Real, Accelerated> m_discs;
    std::vector<Slot> m_next;
    std::vector<Real> m_in;         // of the last timesToImpact()
    std::vector<Index> m_lookAgain; // of the last changedCourse()
};

} // namespace thetalane

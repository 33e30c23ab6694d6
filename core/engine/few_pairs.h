// The search for a few free bodies: all pairs, two at a time, in arrays of a fixed length. A body that was
// counted on and changed course meanwhile is noticed only when the event comes up: then it is found again.
#pragma once

#include "core/engine/few_discs.h"
#include "core/engine/first_event.h"
#include "core/motion/impact.h"

#include <array>
#include <bit>
#include <span>

namespace thetalane {

template <class Real, bool Accelerated> class FewPairs {
    static_assert(!Accelerated, "for free bodies");

public:
    using Index = std::size_t;
    static constexpr Index nobody = Index(-1);
    static constexpr Index most = FewDiscs<Real>::most;
    static constexpr bool rebasesTime = false;

    explicit FewPairs(const Scene& scene)
        : m_discs(scene.bodies) {
        for (Index k = 0; k < m_discs.pairs(); ++k)
            m_time[k] = both(never);
        for (Index i = 0; i < m_discs.count(); ++i) {
            m_next[i] = {};
            m_changes[i] = 0;
        }
    }

    FewDiscs<Real>& discs() { return m_discs; }
    const FewDiscs<Real>& discs() const { return m_discs; }

    // Each pair is looked at by one that moves; a body that only waits to be struck keeps no event.
    template <class Around> void start(const Around& around) {
        for (Index i = 0; i < m_discs.count(); ++i)
            if (!(m_discs.velocity(i) == Vec2<Real>{}))
                look<1>(around, {i}, Real(0));
    }

    template <class Around> FirstEvent<Real> earliest(const Around& around) {
        for (;;) {
            const Real time = leastTime();
            const unsigned tied = notAfter(time + tieWindow<Real>(time));
            const Index first = firstAt(time, tied);
            if (isVoid(m_next[first])) {
                look<1>(around, {first}, time);
                continue;
            }
            const Next& next = m_next[first];
            return {first,
                    {time, next.partner, next.kind, next.detail},
                    next.tied || othersTie(first, tied & ~(1u << first))};
        }
    }

    // Bodies i and j (or i alone), which are where they are now, move otherwise from now on.
    template <class Around> void changedCourse(const Around& around, Index i, Index j, const Real& now) {
        ++m_changes[i];
        if (j == nobody)
            return look<1>(around, {i}, now);
        ++m_changes[j];
        look<2>(around, {i, j}, now);
    }
    template <class Around>
    void changedCourse(const Around& around, std::span<const Index> bodies, const Real& now) {
        for (const Index i : bodies)
            ++m_changes[i];
        for (const Index i : bodies)
            look<1>(around, {i}, now);
    }

    // f(j) for every other body that could touch i.
    template <class F> void forEachNear(Index i, const Real&, F&& f) const {
        for (Index j = 0; j < m_discs.count(); ++j)
            if (j != i)
                f(j);
    }

private:
    static constexpr Real never = std::numeric_limits<Real>::infinity();
    using Two = thetalane::Two<Real>;
    static Two both(const Real& x) { return Two{x, x}; }

    // What comes next for one body, but for the time, and whether another of its own contacts may come at the
    // same instant. Void once the partner has changed course more often than was seen.
    struct Next {
        unsigned partner = 0;
        unsigned seen = 0;
        EventKind kind = EventKind::None;
        unsigned char detail = 0;
        bool tied = false;
    };
    bool isVoid(const Next& next) const {
        return next.kind == EventKind::Pair && m_changes[next.partner] != next.seen;
    }

    Real leastTime() const {
        Two least = m_time[0];
        for (Index k = 1; k < m_discs.pairs(); ++k)
            least = m_time[k] < least ? m_time[k] : least;
        return std::min(least[0], least[1]);
    }
    // Bit i: body i's event comes at `last` or before.
    unsigned notAfter(const Real& last) const {
        unsigned bits = 0;
        for (Index k = 0; k < m_discs.pairs(); ++k)
            bits |= bitsOf(m_time[k] <= both(last)) << 2 * k;
        return bits;
    }
    Index firstAt(const Real& time, unsigned bits) const {
        while (m_time[std::countr_zero(bits) / 2][std::countr_zero(bits) % 2] != time)
            bits &= bits - 1;
        return Index(std::countr_zero(bits));
    }
    // Another body's contact, but for the partner's own entry of the same one.
    bool othersTie(Index first, unsigned others) const {
        const Next& next = m_next[first];
        if (others == 0)
            return false;
        const bool onlyPartner = next.kind == EventKind::Pair && others == 1u << next.partner;
        const Next& partner = m_next[next.partner];
        return !(onlyPartner && partner.kind == EventKind::Pair && partner.partner == first);
    }

    // With whom one body could collide, and the terms of when; see timeToImpact() in core/motion/impact.h.
    struct Prospects {
        Two closing[most / 2], distance2[most / 2], discriminant[most / 2];
        unsigned approached = 0; // bit j
    };
    struct Asking {
        Two x, y, vx, vy, radius;
    };

    // Finds what happens next to each of `who`, in one pass over all.
    template <std::size_t Count, class Around>
    void look(const Around& around, const std::array<Index, Count>& who, const Real& now) {
        Prospects prospects[Count];
        compare(who, now, prospects);
        for (std::size_t n = 0; n < Count; ++n)
            choose(around, who[n], now, prospects[n]);
    }

    template <std::size_t Count>
    void compare(const std::array<Index, Count>& who, const Real& now, Prospects* prospects) const {
        Asking asking[Count];
        for (std::size_t n = 0; n < Count; ++n) {
            const Vec2<Real> p = m_discs.positionAt(who[n], now), v = m_discs.velocity(who[n]);
            asking[n] = {both(p.x), both(p.y), both(v.x), both(v.y), both(m_discs.radiusOf(who[n]))};
        }
        const Two zero = both(Real(0));
        unsigned approached[Count] = {};
        for (Index k = 0; k < m_discs.pairs(); ++k) {
            const auto other = m_discs.coupleAt(k, both(now));
            for (std::size_t n = 0; n < Count; ++n) {
                const Asking& a = asking[n];
                const Two dx = a.x - other.x, dy = a.y - other.y;
                const Two wx = a.vx - other.vx, wy = a.vy - other.vy;
                const Two reach = a.radius + other.radius;
                const Two closing = dx * wx + dy * wy;
                const Two side = dx * wy - dy * wx;
                const Two discriminant = (wx * wx + wy * wy) * (reach * reach) - side * side;
                prospects[n].closing[k] = closing;
                prospects[n].distance2[k] = dx * dx + dy * dy;
                prospects[n].discriminant[k] = discriminant;
                approached[n] |= (bitsOf(closing < zero) & bitsOf(discriminant > zero)) << 2 * k;
            }
        }
        for (std::size_t n = 0; n < Count; ++n)
            prospects[n].approached = approached[n];
    }

    template <class Around>
    void choose(const Around& around, Index i, const Real& now, const Prospects& prospects) {
        NextEvent<Real> next;
        if constexpr (Around::hasFrame || Around::hasLane)
            next = around.next(
                i, now, {m_discs.positionAt(i, now), m_discs.velocity(i), {}, m_discs.radiusOf(i), never});
        Real first = isContact(next.kind) ? next.time : never; // the first two contacts
        Real second = never;
        const Real speed2 = dot(m_discs.velocity(i), m_discs.velocity(i));
        const Real radius = m_discs.radiusOf(i);
        const unsigned approached = around.inPlay(i) ? prospects.approached : 0;
        for (unsigned bits = approached; bits != 0; bits &= bits - 1) {
            const Index j = Index(std::countr_zero(bits));
            const Real within = next.time + 2 * tieWindow<Real>(next.time) - now;
            const Real time = now + timeToMeet(j, radius, speed2, within, prospects);
            if (!(time < never) || !around.inPlay(j))
                continue;
            if (time < next.time)
                next = {time, unsigned(j), EventKind::Pair, 0};
            second = std::min(second, std::max(first, time));
            first = std::min(first, time);
        }
        putInto(m_time, i, next.time);
        m_next[i] = {next.partner, next.kind == EventKind::Pair ? m_changes[next.partner] : 0, next.kind,
                     next.detail, second - first <= tieWindow<Real>(first)};
    }

    // What timeToImpact() gives, to its very bits; infinity, and no root taken, also where it is surely later
    // than `within`.
    Real timeToMeet(Index j, const Real& radius, const Real& speed2, const Real& within,
                    const Prospects& prospects) const {
        using std::sqrt;
        const Real closing = prospects.closing[j / 2][j % 2], distance2 = prospects.distance2[j / 2][j % 2];
        const Real discriminant = prospects.discriminant[j / 2][j % 2];
        const Real reach = radius + m_discs.radiusOf(j), reach2 = reach * reach;
        const Vec2<Real> u = m_discs.velocity(j);
        const Real noise2 = approachNoise<Real>() * approachNoise<Real>() * (speed2 + dot(u, u));
        if (!(closing * closing > noise2 * distance2) || !(discriminant > noise2 * reach2))
            return never;
        const Real gap = std::max(distance2 - reach2, Real(0));
        // gap / (√discriminant - closing) > within
        const Real left = gap + within * closing;
        if (left > Real(0) && left * left > within * within * discriminant)
            return never;
        return gap / (sqrt(discriminant) - closing);
    }

    FewDiscs<Real> m_discs;
    Two m_time[most / 2]; // of each body's next event
    Next m_next[most];
    unsigned m_changes[most]; // of each body's course, so far
};

} // namespace thetalane

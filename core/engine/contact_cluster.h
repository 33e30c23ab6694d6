// The bodies that touch each other at one instant, found from those an event is about.
#pragma once

#include "core/engine/surroundings.h"

#include <cstddef>
#include <vector>

namespace thetalane {

// Two bodies, or a body and a wall, that touch within rounding.
template <class Real> struct Touch {
    ContactName name;
    EventKind kind = EventKind::Pair;
    std::size_t first = 0; // the bodies' places in the cluster
    std::size_t second = ContactName::nobody;
    Contact<Real> contact;
    Real restitution{};

    Vec2<Real> normal() const { return {contact.cosTheta, contact.sinTheta}; } // from second to first
};

// Gaps within this are rounding of the positions, and of the time at which they were reached [m].
template <class Real>
Real touchingSlack(const Vec2<Real>& a, const Vec2<Real>& b, const Real& reach, const Real& now,
                   const Vec2<Real>& relativeVelocity) {
    using std::abs;
    const Real scale = abs(a.x) + abs(a.y) + abs(b.x) + abs(b.y) + reach +
                       abs(now) * (abs(relativeVelocity.x) + abs(relativeVelocity.y));
    return 32 * std::numeric_limits<Real>::epsilon() * scale;
}

// What lasts may drift apart by a little between two looks [m].
template <class Real> Real heldSlack(const Real& reach) {
    return reach * Real(1e-9f);
}

template <class Real, class Models, class Search> class ContactCluster {
public:
    using Index = std::size_t;

    // e: between bodies.
    ContactCluster(Search& search, const Surroundings<Real, Models>& around, const Real& e)
        : m_search(search)
        , m_around(around)
        , m_restitution(e) {}

    // All that touch the event's bodies, those that touch these, and so on.
    void gather(const ContactName& event, const Real& now) {
        m_place.resize(m_search.discs().count(), absent); // a run without ties needs none
        for (const Index b : m_bodies)
            m_place[b] = absent;
        m_bodies.clear();
        m_touches.clear();
        join(event.first);
        if (!event.isWall())
            join(event.second);
        for (Index k = 0; k < m_bodies.size(); ++k) {
            const Index a = m_bodies[k];
            if constexpr (Models::friction) // they share a push, whether or not they touch still
                for (const Index b : m_around.partnersOf(a))
                    join(b);
            m_search.forEachNear(a, now, [&](Index b) {
                if (!m_around.inPlay(a) || !m_around.inPlay(b) || (m_place[b] != absent && m_place[b] < k))
                    return; // those before k have met all theirs
                if (touches(a, b, now))
                    addPair(k, join(b));
            });
            m_around.forEachWall(
                a, [&](EventKind kind, Side side, const Real& wall) { addWall(k, kind, side, wall, now); });
        }
    }

    const std::vector<Index>& bodies() const { return m_bodies; }
    const std::vector<Touch<Real>>& touches() const { return m_touches; }

    // The contact triangles; once the bodies have been moved to now.
    void measure() {
        const auto& discs = m_search.discs();
        for (Touch<Real>& t : m_touches)
            t.contact = t.name.isWall()
                            ? collideWithSide<Real>(discs.disc(t.name.first), t.name.side, Real(0)).contact
                            : contactOf<Real>(discs.position(t.name.first), discs.position(t.name.second));
    }

private:
    static constexpr Index absent = Index(-1);

    Index join(Index b) {
        if (m_place[b] == absent) {
            m_place[b] = m_bodies.size();
            m_bodies.push_back(b);
        }
        return m_place[b];
    }

    bool touches(Index a, Index b, const Real& now) const {
        const auto& discs = m_search.discs();
        const Vec2<Real> p = discs.positionAt(a, now), q = discs.positionAt(b, now);
        const Vec2<Real> d = p - q, v = discs.velocityAt(a, now) - discs.velocityAt(b, now);
        const Real reach = discs.radiusOf(a) + discs.radiusOf(b);
        const bool held = m_around.holdsPair(a, b);
        const Real limit =
            reach + touchingSlack<Real>(p, q, reach, now, v) + (held ? heldSlack<Real>(reach) : Real(0));
        return dot(d, d) <= limit * limit;
    }

    void addPair(Index k, Index l) {
        if (m_bodies[k] > m_bodies[l])
            std::swap(k, l);
        m_touches.push_back(
            {{m_bodies[k], m_bodies[l], Side::Left}, EventKind::Pair, k, l, {}, m_restitution});
    }

    void addWall(Index k, EventKind kind, Side side, const Real& wall, const Real& now) {
        const auto& discs = m_search.discs();
        const Index a = m_bodies[k];
        const Vec2<Real> p = discs.positionAt(a, now), v = discs.velocityAt(a, now);
        const Real r = discs.radiusOf(a);
        const auto approach = approachTo<Real>(side, wall, p, v, r);
        const bool held = Models::friction && m_around.holdsWall(a, side);
        const Real slack = touchingSlack<Real>(p, p, r, now, v) + (held ? heldSlack<Real>(r) : Real(0));
        if (approach.gap > slack)
            return;
        m_touches.push_back(
            {{a, ContactName::nobody, side}, kind, k, ContactName::nobody, {}, m_around.restitutionOf(kind)});
    }

    Search& m_search;
    const Surroundings<Real, Models>& m_around;
    Real m_restitution;
    std::vector<Index> m_place;
    std::vector<Index> m_bodies;
    std::vector<Touch<Real>> m_touches;
};

} // namespace thetalane

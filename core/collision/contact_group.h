// Contacts at the same instant, resolved together.
//
// Source: generalised reflections, after Smith, Kaufman, Vouga, Tamstorf and Grinspun, "Reflections on
// Simultaneous Impact" (2012): all contacts that approach, and only those, are reflected together.
#pragma once

#include "core/collision/pair_collision.h"

#include <algorithm>
#include <span>
#include <vector>

namespace thetalane {

// One contact of a group, of bodies counted within the group.
template <class Real> struct GroupContact {
    std::size_t first = 0;
    std::size_t second = wall;
    Vec2<Real> normal; // unit, from second to first: the x′ axis
    Real demand{};     // b; for impulses (1 + e) × the normal velocity [m/s], negative when they approach

    static constexpr std::size_t wall = std::size_t(-1);
};

// impulse: along each contact's normal, on first; change: of each body's velocity.
template <class Real> struct GroupSolution {
    std::vector<Real> impulse;
    std::vector<Vec2<Real>> change;
};

// The impulses λ >= 0 with (G λ)ₖ + bₖ >= 0, and λₖ > 0 only where that is an equality; (G λ)ₖ is by how much
// the impulses change the normal velocity of contact k. With bₖ = (1 + eₖ) uₖ, uₖ < 0 the normal velocity
// before, each contact either parts with its own -eₖ uₖ or is parted faster by the others and gets nothing.
// Kinetic energy changes by -½ Σ λₖ (1 - eₖ) |uₖ|, never up.
// Found in 113 bits, so that what is symmetric comes out symmetric after rounding; for more than 32 contacts
// by relaxation.
// inverseMass: of the group's bodies, 0 for one that cannot be moved.
template <class Real>
GroupSolution<Real> solveContacts(std::span<const GroupContact<Real>> contacts,
                                  std::span<const Real> inverseMass);

// The same for forces, with accelerations for b; in Real's own arithmetic, for it is asked often.
template <class Real>
GroupSolution<Real> solveForces(std::span<const GroupContact<Real>> contacts,
                                std::span<const Real> inverseMass);

template <class Real> Real largestDemand(const std::vector<GroupContact<Real>>& contacts) {
    using std::abs;
    Real largest(0);
    for (const GroupContact<Real>& c : contacts)
        largest = std::max(largest, Real(abs(c.demand)));
    return largest;
}
// The contact still closes, by more than the rounding of what was asked for: it is between bodies that cannot
// be moved.
template <class Real>
bool isUnmet(const GroupContact<Real>& c, const GroupSolution<Real>& solution, const Real& largest) {
    const Vec2<Real> second = c.second == c.wall ? Vec2<Real>{} : solution.change[c.second];
    const Real rounding = 65536 * std::numeric_limits<Real>::epsilon() * largest;
    return c.demand + dot(c.normal, solution.change[c.first] - second) < -rounding;
}

// The five steps for one contact of several that were resolved together: `impulse` is its own, `after` what
// all of them together left. `momentumResidual` is of the two bodies as if alone: the caller's to overwrite.
template <class Real>
PairCollision<Real> collideTogether(const Disc<Real>& first, const Disc<Real>& second,
                                    const Contact<Real>& contact, const Real& e, const Real& impulse,
                                    const VelocityPair<Real>& after) {
    PairCollision<Real> r;
    r.first = first;
    r.second = second;
    r.restitution = e;
    r.contact = contact;
    r.before = {first.velocity, second.velocity};
    r.rotated = {rotateIn(first.velocity, contact), rotateIn(second.velocity, contact)};
    r.after = after;
    r.exchanged = {rotateIn(after.first, contact), rotateIn(after.second, contact)};
    r.impulse = impulse;
    const Real approach = r.rotated.second.x - r.rotated.first.x;
    r.energyLoss = impulse * (Real(1) - e) * approach / Real(2);
    r.restitutionResidual = (r.exchanged.first.x - r.exchanged.second.x) - e * approach;
    return r;
}

} // namespace thetalane

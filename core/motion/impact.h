// When two free discs will touch and approach.
#pragma once

#include "core/math/vec2.h"

#include <limits>

namespace thetalane {

// An approach slower than the rounding of the velocities it is the difference of is not an approach: after a
// perfectly inelastic collision the two move on together, whatever the last bits say.
template <class Real> Real approachNoise() {
    return 8 * std::numeric_limits<Real>::epsilon();
}

// Time until |dp + dv t| = reach with the two approaching: the smaller root of
//     |dv|² t² + 2 (dp·dv) t + |dp|² - reach² = 0,
// 0 if they touch or overlap already and approach, infinity if it never comes.
// dp, dv: of one disc relative to the other, now [m, m/s]; reach: the sum of the radii [m];
// speed2: |vA|² + |vB|² [m²/s²], the scale of the velocities' rounding.
//
// Without a branch: over an array of partners the compiler makes it two at a time, and nothing is
// mispredicted.
template <class Real>
Real timeToImpact(const Vec2<Real>& dp, const Vec2<Real>& dv, const Real& reach, const Real& speed2) {
    using std::sqrt;
    const Real zero(0);
    const Real closing = dot(dp, dv);
    const Real distance2 = dot(dp, dp);
    const Real reach2 = reach * reach;
    const Real gap = distance2 - reach2;
    // (dp·dv)² - |dv|² gap, with the cancellation taken out: |dv|² reach² - (dp × dv)².
    const Real side = cross(dp, dv);
    const Real discriminant = dot(dv, dv) * reach2 - side * side;
    const Real arrival =
        (gap > zero ? gap : zero) / (sqrt(discriminant > zero ? discriminant : zero) - closing);
    // They must approach by more than noise now, also where rounding has left a gap between bodies that just
    // met, and when they touch: where the path misses or grazes there is no impulse to give.
    const Real noise2 = approachNoise<Real>() * approachNoise<Real>() * speed2;
    const bool meets =
        (closing < zero) & (closing * closing > noise2 * distance2) & (discriminant > noise2 * reach2);
    const Real never = std::numeric_limits<Real>::infinity();
    return meets ? arrival : never;
}

} // namespace thetalane

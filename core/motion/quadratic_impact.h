// When two discs whose motion is quadratic in time will touch and approach.
#pragma once

#include "core/motion/impact.h"
#include "core/motion/relative_motion.h"

#include <limits>

namespace thetalane {

// Where the rate rises (sign +1) or falls (-1) through zero. Newton squares an error: half the digits
// suffice.
template <class Real>
Real zeroOfRate(const RelativeMotion<Real>& m, const Real& low, const Real& high, const Real& start,
                int sign) {
    using std::sqrt;
    const Real little = sqrt(std::numeric_limits<Real>::epsilon());
    return bracketedZero<Real>(low, high, start, little, [&m, sign](const Real& t) {
        const Vec2<Real> q = m.at(t), w = m.velocityAt(t);
        const Real rate = dot(q, w) + m.noise, slope = dot(w, w) + dot(q, m.a);
        return Sight<Real>{sign > 0 ? rate < Real(0) : rate > Real(0), rate == Real(0), t - rate / slope};
    });
}

// Where they would be closest without acceleration, if that is between, else `high`.
template <class Real> Real closestWithout(const RelativeMotion<Real>& m, const Real& low, const Real& high) {
    const Real t = -dot(m.p, m.v) / dot(m.v, m.v);
    return t > low && t < high ? t : high;
}

// They approach from `from` to `to`. Each guess takes the velocity as constant and meets the circle exactly.
template <class Real> Real impactWithin(const RelativeMotion<Real>& m, const Real& from, const Real& to) {
    using std::sqrt;
    const Real zero(0), epsilon = std::numeric_limits<Real>::epsilon();
    const Real rounding = epsilon * m.reach2;
    if (m.gap(from) <= zero)
        return from;
    if (!(m.gap(to) < zero))
        return std::numeric_limits<Real>::infinity();
    return bracketedZero<Real>(from, to, from, epsilon, [&](const Real& t) {
        const Vec2<Real> q = m.at(t), w = m.velocityAt(t);
        const Real gap = dot(q, q) - m.reach2, side = cross(q, w);
        const Real discriminant = dot(w, w) * m.reach2 - side * side;
        const Real guess = t + gap / (sqrt(discriminant > zero ? discriminant : zero) - dot(q, w));
        return Sight<Real>{gap > zero, gap <= rounding && -gap <= rounding, guess};
    });
}

// Over the pieces on which they approach (at most two, for the rate is a cubic that rises in the end), the
// first impact.
template <class Real> Real firstImpact(const RelativeMotion<Real>& m, const Real& end) {
    const Real zero(0), never = std::numeric_limits<Real>::infinity();
    const auto [crest, trough] = m.turns(end);
    const bool pausesAtCrest = !(m.rate(crest) < zero);
    Real from = zero;
    if (pausesAtCrest) {
        if (m.rate(zero) < zero) {
            const Real in = impactWithin(
                m, zero, zeroOfRate<Real>(m, zero, crest, closestWithout<Real>(m, zero, crest), +1));
            if (in < never)
                return in;
        }
        if (!(m.rate(trough) < zero))
            return never;
        from = zeroOfRate<Real>(m, crest, trough, crest + (trough - crest) / 2, -1);
    }
    if (m.gap(trough) < zero)
        return impactWithin(m, from, trough);
    const bool toTheEnd = !(m.rate(end) > zero);
    return impactWithin(
        m, from, toTheEnd ? end : zeroOfRate<Real>(m, trough, end, closestWithout<Real>(m, trough, end), +1));
}

// The smallest t in [0, horizon] at which the two touch (or overlap) and approach by more than the rounding
// of their velocities; infinity for never. The same conventions as timeToImpact() in core/motion/impact.h,
// and its very bits when da = 0. A touch at the horizon itself may be left to the stretch that follows, where
// it is 0. dp, dv, da: of one disc relative to the other, now; reach: the sum of the radii [m]; speed2: |vA|²
// + |vB|².
//
// Two that rest against each other and are pressed together are reported when their approach has risen to
// twice the noise: a contact that lasts is a run of such impacts, and for its keeper to recognise.
template <class Real>
Real timeToImpact(const Vec2<Real>& dp, const Vec2<Real>& dv, const Vec2<Real>& da, const Real& reach,
                  const Real& speed2, const Real& horizon) {
    using std::sqrt;
    const Real zero(0), never = std::numeric_limits<Real>::infinity();
    const Real acceleration2 = dot(da, da);
    if (acceleration2 == zero) {
        const Real in = timeToImpact<Real>(dp, dv, reach, speed2);
        return in <= horizon ? in : never;
    }
    const Real reach2 = reach * reach;
    // Else the horizon is so far that its powers overflow.
    const bool bounded = isBounded<Real>(dv, da, horizon, never);
    if (bounded && staysApart<Real>(dp, dv, da, reach2, horizon))
        return never;
    const Real closing = dot(dp, dv), distance2 = dot(dp, dp);
    const Real noise2 = approachNoise<Real>() * approachNoise<Real>();
    if (distance2 <= reach2 && closing < zero && closing * closing > noise2 * speed2 * distance2)
        return zero;
    // √(|a| reach): the speed that the acceleration makes over their reach; velocities round by that, too.
    const Real noise = 2 * sqrt(noise2 * (speed2 + sqrt(acceleration2) * reach)) * reach;
    const RelativeMotion<Real> motion{dp, dv, da, reach2, noise};
    return firstImpact<Real>(motion, bounded ? horizon : lastPossible<Real>(motion, reach));
}

} // namespace thetalane

// One disc relative to another, both in quadratic motion, and what bounds alone tell of their meeting.
#pragma once

#include "core/math/roots.h"
#include "core/math/vec2.h"

namespace thetalane {

// One disc relative to the other: p + v t + ½ a t² [m, m/s, m/s²].
template <class Real> struct RelativeMotion {
    Vec2<Real> p, v, a;
    Real reach2{}; // (rA + rB)²
    Real noise{};  // reach × the approach speed that is no more than rounding [m²/s]

    Vec2<Real> at(const Real& t) const { return p + (v + a * (t / 2)) * t; }
    Vec2<Real> velocityAt(const Real& t) const { return v + a * t; }
    // Positive while apart: |Δp|² - reach².
    Real gap(const Real& t) const {
        const Vec2<Real> q = at(t);
        return dot(q, q) - reach2;
    }
    // Half the gap's derivative, and the noise: negative while they approach by more than that.
    Real rate(const Real& t) const { return dot(at(t), velocityAt(t)) + noise; }
    // The zeros of the rate's derivative |v|² + p·a + 3 (v·a) t + (3/2)|a|² t², within [0, end]: the rate
    // rises before the first, falls between them, rises after the second.
    Ordered<Real> turns(const Real& end) const {
        return quadraticZeros<Real>(Real(1.5) * dot(a, a), 3 * dot(v, a), dot(v, v) + dot(p, a), Real(0),
                                    end);
    }
};

// Certainly no impact within `end`, told by bounds alone. P(t) is at least as far away as its part along any
// direction: along the line of centres now, and across the velocity, where only ½ a t² moves it.
// Of two at a time, where Real is two numbers (core/engine/two.h).
template <class Real>
auto staysApart(const Vec2<Real>& p, const Vec2<Real>& v, const Vec2<Real>& a, const Real& reach2,
                const Real& end) {
    const Real zero{};
    const auto fall = [&zero](const Real& x) -> Real { return x < zero ? x : zero; };
    const Real end2 = end * end, distance2 = dot(p, p), speed2 = dot(v, v);
    const Real pv = dot(p, v), pa = dot(p, a);
    const Real along = distance2 + fall(pv * end) + fall(pa * end2 / 2);
    const Real across = cross(v, p), acrossLast = across + cross(v, a) * end2 / 2;
    const Real passing = reach2 * speed2;
    const auto tooFar = (along > zero) & (along * along > reach2 * distance2);
    const auto passes =
        (across * acrossLast > zero) & (across * across > passing) & (acrossLast * acrossLast > passing);
    // P·V is p·v + (|v|² + p·a) t + (3/2)(v·a) t² + ½|a|² t³.
    const auto parts = pv + fall((speed2 + pa) * end) + fall(3 * dot(v, a) / 2 * end2) > zero;
    return tooFar | passes | parts;
}

// Whether the powers of a time that the above takes are finite.
template <class Real>
auto isBounded(const Vec2<Real>& v, const Vec2<Real>& a, const Real& end, const Real& never) {
    return (dot(a, a) * end * end + dot(v, v)) * end * end < never;
}

// No root lies later: ½|a| t² <= |p| + reach + |v| t.
template <class Real> Real lastPossible(const RelativeMotion<Real>& m, const Real& reach) {
    using std::sqrt;
    const Real a = norm(m.a), v = norm(m.v);
    return 2 * (v + sqrt(v * v + 2 * a * (norm(m.p) + reach))) / a;
}

} // namespace thetalane

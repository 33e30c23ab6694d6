// Zeros of functions of one variable.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace thetalane {

// Two numbers in order.
template <class Real> struct Ordered {
    Real first{};
    Real second{};
};

// The real zeros of a t² + b t + c, a > 0, brought into [low, high] (a zero outside becomes the nearer end;
// with fewer than two distinct zeros both are `low`). Each by the formula that does not cancel: q = -(b ±
// √(b² - 4ac))/2 with the sign of b, zeros q/a and c/q (Press et al., Numerical Recipes, 5.6).
template <class Real>
Ordered<Real> quadraticZeros(const Real& a, const Real& b, const Real& c, const Real& low, const Real& high) {
    using std::sqrt;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant > Real(0)))
        return {low, low};
    const Real root = sqrt(discriminant);
    const Real q = (b < Real(0) ? Real(root - b) : Real(-root - b)) / 2;
    const Real one = std::clamp<Real>(q / a, low, high), other = std::clamp<Real>(c / q, low, high);
    return one < other ? Ordered<Real>{one, other} : Ordered<Real>{other, one};
}

// What a look at one place tells of a zero.
template <class Real> struct Sight {
    bool ahead = false;   // it lies at a larger t
    bool settled = false; // nothing more can be seen: the value is its own rounding
    Real guess{};         // where it should be
};

// The one zero between low and high, starting at t: the guesses as long as they stay between and their steps
// halve, else the middle (Dekker and Brent's safeguard); until a step is less than `little` of t.
template <class Real, class Look>
Real bracketedZero(Real low, Real high, Real t, const Real& little, const Look& look) {
    using std::abs;
    using Limits = std::numeric_limits<Real>;
    Real step = high - low, stepBefore = step;
    for (int k = 0; k < 8 * Limits::digits; ++k) {
        const Sight<Real> seen = look(t);
        (seen.ahead ? low : high) = t;
        Real to = seen.guess;
        if (seen.settled)
            return t;
        if (abs(to - t) <= little * t)
            return std::clamp<Real>(to, low, high);
        if (!(to > low && to < high && 2 * abs(to - t) <= stepBefore))
            to = low + (high - low) / 2;
        if (!(to > low && to < high))
            return t;
        stepBefore = step;
        step = abs(to - t);
        t = to;
    }
    return t;
}

} // namespace thetalane

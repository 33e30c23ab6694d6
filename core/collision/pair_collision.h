// One collision of two discs, in the five steps of the paper this program exists for:
//   Cho, Kwon and Kim, "An Implementation of 2-Dimension Collision Method for Bowling Game".
// Every intermediate value is kept, so that what a panel shows is what the engine computed.
//
// SI units; x to the right, y up (down the lane), seen from above. "first" is the paper's A, "second" its B.
#pragma once

#include "core/math/vec2.h"

#include <limits>

namespace thetalane {

// A disc at one instant. mass [kg], radius [m], position [m], velocity [m/s].
template <class Real> struct Disc {
    Real mass{};
    Real radius{};
    Vec2<Real> position;
    Vec2<Real> velocity;
};

// Step 0 (fig. 9): the right triangle between the centres. a = xA - xB, b = yA - yB, Z = sqrt(a² + b²) [m].
// The x′ axis is the line of centres, pointing from the second body to the first; θ is its angle to x.
template <class Real> struct Contact {
    Real a{};
    Real b{};
    Real Z{};
    Real cosTheta{};
    Real sinTheta{};
};

// The velocities of both bodies [m/s]: (x, y), or (along x′, across y′) in the rotated frame.
template <class Real> struct VelocityPair {
    Vec2<Real> first;
    Vec2<Real> second;
};

// Everything about one collision. A wall is a second body of infinite mass at rest; then `second` stays zero.
template <class Real> struct PairCollision {
    Disc<Real> first;  // as the bodies met: before the exchange
    Disc<Real> second; // for a wall: the point that was touched, radius 0, mass infinite
    Real restitution{};

    Contact<Real> contact;        // step 0 (fig. 9)
    VelocityPair<Real> before;    // step 1 (fig. 2): split along x and y
    VelocityPair<Real> rotated;   // step 2 (fig. 5): along x′ and across y′
    VelocityPair<Real> exchanged; // step 3 (figs 6, 7): x′ exchanged, y′ as it was
    VelocityPair<Real> after;     // step 4 (fig. 8): back to x and y

    // Step 5, the check.
    Real impulse{};    // on the first body along x′ [N·s]; positive when the bodies approached
    Real energyLoss{}; // ½ μ (1 - e²) (va′ - vb′)², μ the reduced mass [J]
    Vec2<Real>
        momentumResidual; // Σ m v after - Σ m v before [kg·m/s]; zero but for rounding; (0, 0) at a wall
    Real restitutionResidual{}; // (va′ - vb′) after + e (va′ - vb′) before [m/s]; zero but for rounding
};

// x, y -> x′, y′ (fig. 5).
template <class Real> Vec2<Real> rotateIn(const Vec2<Real>& v, const Contact<Real>& c) {
    return {v.x * c.cosTheta + v.y * c.sinTheta, v.y * c.cosTheta - v.x * c.sinTheta};
}

// x′, y′ -> x, y (fig. 8).
template <class Real> Vec2<Real> rotateBack(const Vec2<Real>& v, const Contact<Real>& c) {
    return {v.x * c.cosTheta - v.y * c.sinTheta, v.x * c.sinTheta + v.y * c.cosTheta};
}

// Step 0. Coincident centres have no line of centres: the declared rule is θ = 0.
template <class Real> Contact<Real> contactOf(const Vec2<Real>& first, const Vec2<Real>& second) {
    using std::sqrt;
    const Real a = first.x - second.x;
    const Real b = first.y - second.y;
    const Real Z2 = a * a + b * b;
    if (Z2 < std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon()) { // squares underflow
        using std::abs;
        const Real scale = abs(a) > abs(b) ? Real(abs(a)) : Real(abs(b));
        if (scale == Real(0))
            return {a, b, scale, Real(1), Real(0)};
        const Real p = a / scale, q = b / scale, z = sqrt(p * p + q * q);
        return {a, b, scale * z, p / z, q / z};
    }
    const Real Z = sqrt(Z2);
    return {a, b, Z, a / Z, b / Z};
}

// Steps 2 to 4 on both bodies.
template <class Real> VelocityPair<Real> rotateIn(const VelocityPair<Real>& v, const Contact<Real>& c) {
    return {rotateIn(v.first, c), rotateIn(v.second, c)};
}
template <class Real>
VelocityPair<Real> exchangeAlong(const VelocityPair<Real>& rotated, const Real& ma, const Real& mb,
                                 const Real& e) {
    const Real total = ma + mb;
    const Real va = rotated.first.x;
    const Real vb = rotated.second.x;
    return {{((ma - e * mb) * va + (Real(1) + e) * mb * vb) / total, rotated.first.y},
            {((Real(1) + e) * ma * va + (mb - e * ma) * vb) / total, rotated.second.y}};
}
template <class Real> VelocityPair<Real> rotateBack(const VelocityPair<Real>& v, const Contact<Real>& c) {
    return {rotateBack(v.first, c), rotateBack(v.second, c)};
}

// The five steps for two bodies in contact; restitution e in [0, 1]. Whether they touch or approach is the
// caller's business: the paper's own loop exchanges bodies that part, and this function shows what that does.
template <class Real>
PairCollision<Real> collide(const Disc<Real>& first, const Disc<Real>& second, const Real& e) {
    PairCollision<Real> r;
    r.first = first;
    r.second = second;
    r.restitution = e;
    r.contact = contactOf(first.position, second.position);
    r.before = {first.velocity, second.velocity};
    r.rotated = rotateIn(r.before, r.contact);
    const Real& ma = first.mass;
    const Real& mb = second.mass;
    r.exchanged = exchangeAlong(r.rotated, ma, mb, e);
    r.after = rotateBack(r.exchanged, r.contact);

    const Real reduced = ma * mb / (ma + mb);
    const Real approach = r.rotated.second.x - r.rotated.first.x;
    r.impulse = (Real(1) + e) * reduced * approach;
    r.energyLoss = reduced * (Real(1) - e) * (Real(1) + e) * approach * approach / Real(2);
    r.momentumResidual =
        (ma * r.after.first + mb * r.after.second) - (ma * r.before.first + mb * r.before.second);
    r.restitutionResidual = (r.exchanged.first.x - r.exchanged.second.x) - e * approach;
    return r;
}

// The same steps against a wall that is touched at `point`: (ma - e mb)/(ma + mb) -> -e as mb grows without
// bound.
template <class Real>
PairCollision<Real> collideWithWall(const Disc<Real>& first, const Vec2<Real>& point,
                                    const Contact<Real>& contact, const Real& e) {
    PairCollision<Real> r;
    r.first = first;
    r.second.mass = std::numeric_limits<Real>::infinity();
    r.second.position = point;
    r.restitution = e;
    r.contact = contact;
    r.before.first = first.velocity;
    r.rotated.first = rotateIn(first.velocity, contact);
    r.exchanged.first = {-e * r.rotated.first.x, r.rotated.first.y};
    r.after.first = rotateBack(r.exchanged.first, contact);
    r.impulse = -(Real(1) + e) * first.mass * r.rotated.first.x;
    r.energyLoss =
        first.mass * (Real(1) - e) * (Real(1) + e) * r.rotated.first.x * r.rotated.first.x / Real(2);
    r.restitutionResidual = r.exchanged.first.x + e * r.rotated.first.x;
    return r;
}

template <class To, class From> Disc<To> convert(const Disc<From>& d) {
    return {static_cast<To>(d.mass), static_cast<To>(d.radius), convert<To>(d.position),
            convert<To>(d.velocity)};
}

template <class To, class From> VelocityPair<To> convert(const VelocityPair<From>& v) {
    return {convert<To>(v.first), convert<To>(v.second)};
}

template <class To, class From> PairCollision<To> convert(const PairCollision<From>& c) {
    return {convert<To>(c.first),
            convert<To>(c.second),
            static_cast<To>(c.restitution),
            {static_cast<To>(c.contact.a), static_cast<To>(c.contact.b), static_cast<To>(c.contact.Z),
             static_cast<To>(c.contact.cosTheta), static_cast<To>(c.contact.sinTheta)},
            convert<To>(c.before),
            convert<To>(c.rotated),
            convert<To>(c.exchanged),
            convert<To>(c.after),
            static_cast<To>(c.impulse),
            static_cast<To>(c.energyLoss),
            convert<To>(c.momentumResidual),
            static_cast<To>(c.restitutionResidual)};
}

} // namespace thetalane

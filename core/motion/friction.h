// What a body on a floor with Coulomb friction does next, in closed form: one stretch of motion, at most
// quadratic in time, how long it lasts and what it changes into. Never by stepping.
//
// Source: the sliding and rolling sphere of any mechanics book, e.g. Marlow, The Physics of Pocket Billiards:
// a = -μ g û while the point of contact slips by u = v + ω × (-R ẑ), whose direction û does not change.
#pragma once

#include "core/math/vec2.h"
#include "core/motion/impact.h"
#include "core/motion/zones.h"

namespace thetalane {

enum class FloorPhase { Rest, Sliding, Rolling };
enum class FloorChange { None, Rests, Rolls, UpperZone, LowerZone };

template <class Real> struct Spin { // [rad/s], world axes, z up
    Real x{};
    Real y{};
    Real z{}; // does not touch the path; kept as it is
};

template <class Real> struct Floor {
    Real gravity{}; // [m/s²]
    FrictionZones<Real> zones;
};

// A disc that cannot roll (a pin) is the body of no arm: it slips by its velocity, and when that ends, rests.
template <class Real> struct FloorBody {
    Real arm{};             // R [m]; 0 for a disc
    Real inverseInertia{};  // 1/β, β = I/(m R²); 0 for a disc
    Real rollingFriction{}; // μr

    bool rolls() const { return inverseInertia > Real(0); }
    Real slipLoss() const { return 1 + inverseInertia; } // |u| falls at μ g (1 + 1/β)
    Vec2<Real> slip(const Vec2<Real>& v, const Spin<Real>& w) const {
        return {v.x - arm * w.y, v.y + arm * w.x};
    }
};

template <class Real> struct FloorState {
    Vec2<Real> position; // [m]
    Vec2<Real> velocity; // [m/s]
    Spin<Real> spin;
    FloorPhase phase = FloorPhase::Rest;
    Vec2<Real> slipDirection; // û, while it slides
    Real slip{};              // |u| [m/s]
    int zone = 0;             // while it slides
};

// position + velocity t + ½ acceleration t² for t in [0, lasts], then the change.
template <class Real> struct Stretch {
    Vec2<Real> acceleration;
    Real lasts = std::numeric_limits<Real>::infinity();
    FloorChange change = FloorChange::None;
};

// A rolling body's spin is its velocity's.
template <class Real> void rollWith(FloorState<Real>& s, const FloorBody<Real>& body) {
    s.spin.x = -s.velocity.y / body.arm;
    s.spin.y = s.velocity.x / body.arm;
    s.slip = Real(0);
    s.slipDirection = {};
    s.phase = s.velocity == Vec2<Real>{} ? FloorPhase::Rest : FloorPhase::Rolling;
}

template <class Real> void rest(FloorState<Real>& s) {
    s.velocity = s.slipDirection = {};
    s.spin.x = s.spin.y = s.slip = Real(0);
    s.phase = FloorPhase::Rest;
}

// A body put on the floor, or just struck: which phase it is in. A slip within the rounding of v and R ω is
// none.
template <class Real>
FloorState<Real> onFloor(const Vec2<Real>& position, const Vec2<Real>& velocity, const Spin<Real>& spin,
                         const FloorBody<Real>& body, const Floor<Real>& floor) {
    FloorState<Real> s{position, velocity, spin, FloorPhase::Sliding, {}, {}, 0};
    const Vec2<Real> u = body.slip(velocity, spin);
    s.slip = norm(u);
    const Real scale = norm(velocity) + body.arm * norm(Vec2<Real>{spin.x, spin.y});
    if (scale == Real(0))
        rest(s);
    else if (!(s.slip > approachNoise<Real>() * scale))
        rollWith(s, body);
    else
        s.slipDirection = u * (1 / s.slip);
    const bool up = velocity.y > Real(0) || (velocity.y == Real(0) && !(s.slipDirection.y > Real(0)));
    s.zone = floor.zones.zoneAt(position.y, up);
    return s;
}

// How fast friction slows it in its phase [m/s²]. Rolling resistance is the same in every zone.
template <class Real>
Real deceleration(const FloorState<Real>& s, const FloorBody<Real>& body, const Floor<Real>& floor) {
    if (s.phase == FloorPhase::Sliding)
        return floor.zones.friction[std::size_t(s.zone)] * floor.gravity;
    return s.phase == FloorPhase::Rolling ? Real(body.rollingFriction * floor.gravity) : Real(0);
}

template <class Real>
Stretch<Real> nextStretch(const FloorState<Real>& s, const FloorBody<Real>& body, const Floor<Real>& floor) {
    Stretch<Real> next;
    const Real slowing = deceleration(s, body, floor);
    const bool slides = s.phase == FloorPhase::Sliding;
    if (slowing > Real(0)) {
        const Real speed = slides ? s.slip : norm(s.velocity);
        next.acceleration = (slides ? s.slipDirection : s.velocity * (1 / speed)) * -slowing;
        // t = β|u|/((1 + β) μ g), or |v|/(μr g).
        next.lasts = speed / (slides ? Real(slowing * body.slipLoss()) : slowing);
        next.change = slides && body.rolls() ? FloorChange::Rolls : FloorChange::Rests;
    }
    if (!slides)
        return next;
    const Real y = s.position.y, vy = s.velocity.y, ay = next.acceleration.y;
    if (const Real up = floor.zones.timeToUpper(s.zone, y, vy, ay); up < next.lasts) {
        next.lasts = up;
        next.change = FloorChange::UpperZone;
    }
    if (const Real down = floor.zones.timeToLower(s.zone, y, vy, ay); down < next.lasts) {
        next.lasts = down;
        next.change = FloorChange::LowerZone;
    }
    return next;
}

// The state t into the stretch, t in [0, lasts].
template <class Real>
FloorState<Real> stateWithin(const FloorState<Real>& s, const Stretch<Real>& stretch,
                             const FloorBody<Real>& body, const Floor<Real>& floor, const Real& t) {
    FloorState<Real> n = s;
    n.position = s.position + (s.velocity + stretch.acceleration * (t / 2)) * t;
    n.velocity = s.velocity + stretch.acceleration * t;
    if (s.phase == FloorPhase::Rolling) {
        rollWith(n, body);
    } else if (s.phase == FloorPhase::Sliding) {
        const Real lost = deceleration(s, body, floor) * t;
        const Real left = s.slip - lost * body.slipLoss();
        n.slip = left > Real(0) ? left : Real(0);
        if (body.rolls()) { // ω̇ = (μ g/βR) (-ûy, ûx)
            const Real turned = lost * body.inverseInertia / body.arm;
            n.spin.x -= turned * s.slipDirection.y;
            n.spin.y += turned * s.slipDirection.x;
        }
    }
    return n;
}

// The state at the stretch's end, with what holds there exactly: rest is 0, a ball that rolls does not slip
// (v = v₀ - β/(1 + β) u₀), a body on an edge lies on it and moves across.
template <class Real>
FloorState<Real> stateAfter(const FloorState<Real>& s, const Stretch<Real>& stretch,
                            const FloorBody<Real>& body, const Floor<Real>& floor) {
    FloorState<Real> n = stateWithin(s, stretch, body, floor, stretch.lasts);
    const Real zero(0);
    if (stretch.change == FloorChange::Rests) {
        n.position = s.position + s.velocity * (stretch.lasts / 2);
        rest(n);
    } else if (stretch.change == FloorChange::Rolls) {
        n.velocity = s.velocity - s.slipDirection * (s.slip / body.slipLoss());
        if (norm(n.velocity) > approachNoise<Real>() * (norm(s.velocity) + s.slip))
            rollWith(n, body);
        else
            rest(n);
    } else if (stretch.change != FloorChange::None) {
        const bool up = stretch.change == FloorChange::UpperZone;
        n.position.y = floor.zones.edges[std::size_t(up ? s.zone : s.zone - 1)];
        n.zone = up ? s.zone + 1 : s.zone - 1;
        if (up ? n.velocity.y < zero : n.velocity.y > zero)
            n.velocity.y = zero;
    }
    return n;
}

} // namespace thetalane

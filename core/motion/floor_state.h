// A body on a floor with Coulomb friction: what it is, and in which phase it moves.
//
// Source: the sliding and rolling sphere of any mechanics book, e.g. Marlow, The Physics of Pocket Billiards:
// the point of contact slips by u = v + ω × (-R ẑ), and while it slides a = -μ g û, û constant.
#pragma once

#include "core/math/vec2.h"
#include "core/motion/impact.h"
#include "core/motion/zones.h"

namespace thetalane {

enum class FloorPhase { Rest, Sliding, Rolling };

template <class Real> struct Spin { // [rad/s], world axes, z up
    Real x{};
    Real y{};
    Real z{}; // does not touch the path; kept as it is

    friend bool operator==(const Spin&, const Spin&) = default;
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

} // namespace thetalane

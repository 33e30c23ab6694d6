// What a body on a floor with Coulomb friction does next, in closed form: one stretch of motion, at most
// quadratic in time, how long it lasts and what it changes into. Never by stepping.
#pragma once

#include "core/motion/floor_state.h"

namespace thetalane {

enum class FloorChange { None, Rests, Rolls, UpperZone, LowerZone };

// position + velocity t + ½ acceleration t² for t in [0, lasts], then the change.
template <class Real> struct Stretch {
    Vec2<Real> acceleration;
    Real lasts = std::numeric_limits<Real>::infinity();
    FloorChange change = FloorChange::None;
};

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

// The bodies of a running engine on a floor with friction: in which phase each is, and its stretch of motion.
#pragma once

#include "core/engine/moving_discs.h"
#include "core/motion/friction.h"
#include "core/timeline/timeline.h"

#include <vector>

namespace thetalane {

template <class Real> class FloorMotion {
public:
    using Discs = MovingDiscs<Real, true>;

    explicit FloorMotion(const Scene& scene) {
        if (!scene.friction)
            return;
        const Friction& f = *scene.friction;
        m_ballFloor = {Real(f.gravity), zonesOf(f)};
        m_strongest = Real(std::max({f.ball, f.pin, f.rolling, mostOf(f.oil)}) * f.gravity);
        m_pinFloor = {Real(f.gravity), {{}, {Real(f.pin)}}};
        for (const Body& b : scene.bodies) {
            const bool ball = b.kind == BodyKind::Ball;
            m_bodies.push_back({ball ? FloorBody<Real>{Real(b.radius), 1 / Real(b.inertia), Real(f.rolling)}
                                     : FloorBody<Real>{},
                                {},
                                {},
                                {}});
            m_bodies.back().state.spin = {Real(b.spin.x), Real(b.spin.y), Real(b.spin.z)};
        }
    }

    // How friction alone would accelerate body i, were it where it is with velocity v.
    Vec2<Real> frictionAt(std::size_t i, const Vec2<Real>& p, const Vec2<Real>& v) const {
        const FloorState<Real> s = onFloor<Real>(p, v, m_bodies[i].state.spin, m_bodies[i].body, floorOf(i));
        return nextStretch<Real>(s, m_bodies[i].body, floorOf(i)).acceleration;
    }
    bool wouldRest(std::size_t i, const Vec2<Real>& v) const {
        return onFloor<Real>({}, v, m_bodies[i].state.spin, m_bodies[i].body, floorOf(i)).phase ==
               FloorPhase::Rest;
    }
    // A ball that slides: friction opposes its slip, whichever way it moves.
    bool slips(std::size_t i, const Vec2<Real>& v) const {
        return m_bodies[i].body.rolls() && !(slowness(i, v) > Real(1));
    }
    // The most that holds a resting body against a push [m/s²].
    Real holding(std::size_t i) const {
        const Real mu =
            m_bodies[i].body.rolls() ? m_bodies[i].body.rollingFriction : m_pinFloor.zones.friction[0];
        return mu * m_ballFloor.gravity;
    }
    // A rolling body is harder to push along: 1 + β times.
    Real slowness(std::size_t i, const Vec2<Real>& v) const {
        const FloorBody<Real>& b = m_bodies[i].body;
        const bool slides =
            onFloor<Real>({}, v, m_bodies[i].state.spin, b, floorOf(i)).phase == FloorPhase::Sliding;
        return slides || !b.rolls() ? Real(1) : Real(1 + 1 / b.inverseInertia);
    }

    // What friction does to a body, at most [m/s²].
    const Real& strongestFriction() const { return m_strongest; }

    // A ball that rolls on with velocity v.
    void roll(std::size_t i, const Vec2<Real>& v) {
        OneBody& b = m_bodies[i];
        if (!b.body.rolls())
            return;
        b.state.spin.x = -v.y / b.body.arm;
        b.state.spin.y = v.x / b.body.arm;
    }

    // A ball that slips by less than `still` rolls: no faster than friction would have it roll, which takes
    // v - u/(1 + 1/β), and along v, since that is what its contacts let it do. So kinetic energy falls.
    void calm(std::size_t i, Vec2<Real>& v, const Real& still) {
        const OneBody& b = m_bodies[i];
        const Vec2<Real> u = b.body.slip(v, b.state.spin);
        if (!b.body.rolls() || !(norm(u) < still))
            return;
        const Real slowed = dot(u, v) / b.body.slipLoss(), square = dot(v, v);
        if (slowed > Real(0))
            v = slowed < square ? v * (1 - slowed / square) : Vec2<Real>{};
        roll(i, v);
    }

    // Body i, at `now` where `discs` says, goes on under friction and `push`, at most for `atMost`.
    void begin(Discs& discs, std::size_t i, const Real& now, bool inPlay, const Vec2<Real>& push,
               const Real& atMost) {
        OneBody& b = m_bodies[i];
        const Vec2<Real> p = discs.position(i), v = discs.velocity(i);
        if (!inPlay) {
            b.state.position = p;
            b.state.velocity = v;
            b.state.phase = FloorPhase::Rest;
            if (v == Vec2<Real>{})
                b.state.spin = {};
            b.stretch = {};
        } else {
            b.state = onFloor<Real>(p, v, b.state.spin, b.body, floorOf(i));
            b.stretch = nextStretch<Real>(b.state, b.body, floorOf(i));
        }
        b.push = b.state.phase == FloorPhase::Rest ? withoutRounding(push) : push;
        if (!(b.push == Vec2<Real>{}))
            limit(b, floorOf(i), b.push, atMost);
        discs.setAcceleration(i, b.stretch.acceleration, now + b.stretch.lasts);
    }

    // Body i to `now`, within its stretch or at its very end.
    void moveTo(Discs& discs, std::size_t i, const Real& now) {
        OneBody& b = m_bodies[i];
        const Real elapsed = now - discs.since(i);
        const Real speed = norm(b.state.velocity);
        b.state = now >= discs.until(i) ? stateAfter<Real>(b.state, b.stretch, b.body, floorOf(i))
                                        : stateWithin<Real>(b.state, b.stretch, b.body, floorOf(i), elapsed);
        // Pushed to a stop: what is left of its speed is rounding.
        if (!(b.push == Vec2<Real>{}) && norm(b.state.velocity) <= stopped * speed) {
            b.state.velocity = {};
            if (b.state.phase != FloorPhase::Sliding)
                rest(b.state);
        }
        discs.put(i, b.state.position, b.state.velocity, now);
    }

    Rotation rotation(std::size_t i) const {
        const OneBody& b = m_bodies[i];
        Spin<Real> rate;
        if (b.body.rolls() && b.state.phase == FloorPhase::Rolling)
            rate = {-b.stretch.acceleration.y / b.body.arm, b.stretch.acceleration.x / b.body.arm, Real(0)};
        else if (b.body.rolls() && b.state.phase == FloorPhase::Sliding) {
            const Real turned =
                deceleration<Real>(b.state, b.body, floorOf(i)) * b.body.inverseInertia / b.body.arm;
            rate = {-turned * b.state.slipDirection.y, turned * b.state.slipDirection.x, Real(0)};
        }
        const Spin<Real>& w = b.state.spin;
        const auto plain = [](const Spin<Real>& s) {
            return Spin<double>{static_cast<double>(s.x), static_cast<double>(s.y), static_cast<double>(s.z)};
        };
        return {plain(w), plain(rate), b.state.phase};
    }

private:
    static inline const Real stopped = 4096 * std::numeric_limits<Real>::epsilon();

    struct OneBody {
        FloorBody<Real> body;
        FloorState<Real> state;
        Stretch<Real> stretch; // with the push in its acceleration
        Vec2<Real> push;
    };

    static double mostOf(const std::vector<OilZone>& oil) {
        double most = 0;
        for (const OilZone& zone : oil)
            most = std::max(most, zone.friction);
        return most;
    }
    static FrictionZones<Real> zonesOf(const Friction& f) {
        FrictionZones<Real> zones{{}, {Real(f.ball)}};
        for (const OilZone& oil : f.oil) {
            const bool follows = !zones.edges.empty() && zones.edges.back() == Real(oil.from);
            if (follows)
                zones.friction.back() = Real(oil.friction);
            else {
                zones.edges.push_back(Real(oil.from));
                zones.friction.push_back(Real(oil.friction));
            }
            zones.edges.push_back(Real(oil.to));
            zones.friction.push_back(Real(f.ball));
        }
        return zones;
    }

    const Floor<Real>& floorOf(std::size_t i) const {
        return m_bodies[i].body.rolls() ? m_ballFloor : m_pinFloor;
    }

    // Forces that balance leave rounding, which must not press a resting body anywhere.
    Vec2<Real> withoutRounding(const Vec2<Real>& push) const {
        using std::abs;
        const Real least = stopped * m_ballFloor.gravity;
        return {abs(push.x) > least ? push.x : Real(0), abs(push.y) > least ? push.y : Real(0)};
    }

    // Under a push the phase's closed form holds for a short while only, and no longer than until what
    // friction opposes would turn back, a ball's slip or else the velocity: then it is asked anew.
    static void limit(OneBody& b, const Floor<Real>& floor, const Vec2<Real>& push, const Real& atMost) {
        Real lasts = atMost;
        b.stretch.acceleration = b.stretch.acceleration + push;
        if (b.state.phase == FloorPhase::Sliding && b.body.rolls()) {
            const Real slowing = deceleration<Real>(b.state, b.body, floor) * b.body.slipLoss() -
                                 dot(push, b.state.slipDirection);
            if (slowing > Real(0))
                lasts = std::min(lasts, Real(b.state.slip / slowing));
        } else if (const Real slowing = -dot(b.stretch.acceleration, b.state.velocity); slowing > Real(0)) {
            lasts = std::min(lasts, Real(dot(b.state.velocity, b.state.velocity) / slowing));
        }
        b.stretch.lasts = lasts;
        b.stretch.change = FloorChange::None;
    }

    Floor<Real> m_ballFloor;
    Floor<Real> m_pinFloor;
    Real m_strongest{};
    std::vector<OneBody> m_bodies;
};

} // namespace thetalane

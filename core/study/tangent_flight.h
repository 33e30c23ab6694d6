// Small errors of one body carried along its way between contacts, to first order.
//
// Free: δp += δv τ. On a floor with friction the stretches of its timeline are followed: while it slides
// a = -|a| û with û the direction of the slip u = v + ω × (-R ẑ), so δa = -|a| δu⊥/|u|; while it rolls v
// stands for u, and the spin follows it. Where one stretch ends and the next begins (it rolls, it rests, it
// comes to other oil) the instant itself shifts by δt, and δv += (a before - a after) δt.
#pragma once

#include "core/timeline/timeline.h"

#include <array>

namespace thetalane {

inline constexpr int tangentSamples = 24;

struct Tangent {
    Vec2d position; // δp [m]
    Vec2d velocity; // δv [m/s]
    Vec2d spin;     // δω about x and y [rad/s]
};
using Tangents = std::array<Tangent, tangentSamples>;

class TangentFlight {
public:
    TangentFlight(const Scene& scene, const Timeline& timeline, std::size_t body);

    // To `time`, before whatever happens there.
    void flyTo(double time);
    // From the stretch that begins at `time`, where it last flew to: another after a contact.
    void goOn();

    Tangents errors{};

    Vec2d acceleration() const { return m_segments[m_stretch].acceleration; }
    Vec2d spinRate() const;

private:
    void drift(double from, double to);
    void change(double time);
    Vec2d velocityAt(double time) const;
    Vec2d slipAt(double time) const;
    Vec2d slipOf(const Vec2d& v, const Vec2d& spin) const {
        return {v.x - m_arm * spin.y, v.y + m_arm * spin.x};
    }
    FloorPhase phase(std::size_t stretch) const { return m_rotations[stretch].phase; }

    std::span<const Segment> m_segments;
    std::span<const Rotation> m_rotations; // none without friction
    double m_arm = 0;                      // R of a ball on a floor [m]; 0: it cannot roll
    double m_inverseInertia = 0;           // 1/β
    std::size_t m_stretch = 0;
    double m_since = 0; // s
};

} // namespace thetalane

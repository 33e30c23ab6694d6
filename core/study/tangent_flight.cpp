#include "core/study/tangent_flight.h"

#include <cmath>

namespace thetalane {
namespace {

constexpr double least = 1e-12; // m/s; slower has no direction

// How the direction of u turns, times |u|: what of du lies across it.
Vec2d across(const Vec2d& u, const Vec2d& du) {
    const Vec2d unit = u * (1 / norm(u));
    return du - unit * dot(unit, du);
}

} // namespace

TangentFlight::TangentFlight(const Scene& scene, const Timeline& timeline, std::size_t body)
    : m_segments(timeline.segments(body))
    , m_rotations(timeline.rotations(body)) {
    const Body& b = scene.bodies[body];
    if (scene.friction && b.kind == BodyKind::Ball) {
        m_arm = b.radius;
        m_inverseInertia = 1 / b.inertia;
    }
}

Vec2d TangentFlight::velocityAt(double time) const {
    const Segment& s = m_segments[m_stretch];
    return s.velocity + s.acceleration * (time - s.start);
}

Vec2d TangentFlight::slipAt(double time) const {
    const Rotation& r = m_rotations[m_stretch];
    const double t = time - m_segments[m_stretch].start;
    return slipOf(velocityAt(time), {r.spin.x + r.rate.x * t, r.spin.y + r.rate.y * t});
}

Vec2d TangentFlight::spinRate() const {
    return m_rotations.empty() ? Vec2d{}
                               : Vec2d{m_rotations[m_stretch].rate.x, m_rotations[m_stretch].rate.y};
}

void TangentFlight::flyTo(double time) {
    while (m_stretch + 1 < m_segments.size() && m_segments[m_stretch + 1].start < time) {
        const double next = m_segments[m_stretch + 1].start;
        drift(m_since, next);
        if (!m_rotations.empty())
            change(next);
        ++m_stretch;
    }
    drift(m_since, time);
}

void TangentFlight::goOn() {
    while (m_stretch + 1 < m_segments.size() && m_segments[m_stretch + 1].start <= m_since)
        ++m_stretch;
}

void TangentFlight::drift(double from, double to) {
    const double t = to - from;
    m_since = to;
    const bool turns = !m_rotations.empty() && phase(m_stretch) != FloorPhase::Rest;
    const bool slides = turns && phase(m_stretch) == FloorPhase::Sliding;
    const Vec2d u = slides ? slipAt(from) : turns ? velocityAt(from) : Vec2d{};
    const double a = norm(acceleration()), speed = norm(u);
    const bool curved = turns && a > 0 && speed > least;
    for (Tangent& e : errors) {
        Vec2d da;
        if (curved)
            da = across(u, slides ? slipOf(e.velocity, e.spin) : e.velocity) * (-a / speed);
        e.position = e.position + (e.velocity + da * (t / 2)) * t;
        e.velocity = e.velocity + da * t;
        if (slides && m_arm > 0) {
            const double turning = m_inverseInertia / m_arm; // ω̇ = (a.y, -a.x) × turning
            e.spin = e.spin + Vec2d{da.y * turning, -da.x * turning} * t;
        } else if (turns && m_arm > 0) {
            e.spin = {-e.velocity.y / m_arm, e.velocity.x / m_arm};
        }
    }
}

// From this stretch to the next, without a contact.
void TangentFlight::change(double time) {
    const FloorPhase now = phase(m_stretch), next = phase(m_stretch + 1);
    const Vec2d before = acceleration(), after = m_segments[m_stretch + 1].acceleration;
    const Vec2d v = velocityAt(time), rate = spinRate();
    const Rotation& r = m_rotations[m_stretch + 1];
    const double a = norm(before);
    if (next == FloorPhase::Rest) {
        for (Tangent& e : errors)
            e.velocity = e.spin = {};
        return;
    }
    const Vec2d slip = slipAt((m_segments[m_stretch].start + time) / 2); // at the end it has no direction
    const bool rolls =
        now == FloorPhase::Sliding && next == FloorPhase::Rolling && a > 0 && norm(slip) > least;
    const Vec2d along = rolls ? slip * (1 / norm(slip)) : Vec2d{};
    for (Tangent& e : errors) {
        double shift = 0;
        if (rolls)
            shift = dot(along, slipOf(e.velocity, e.spin)) / (a * (1 + m_inverseInertia));
        else if (now == next && std::abs(v.y) > least) // other oil, at a line across the lane
            shift = -e.position.y / v.y;
        e.velocity = e.velocity + (before - after) * shift;
        e.spin = e.spin + (rate - Vec2d{r.rate.x, r.rate.y}) * shift;
        if (next == FloorPhase::Rolling)
            e.spin = {-e.velocity.y / m_arm, e.velocity.x / m_arm};
    }
}

} // namespace thetalane

#include "ui/lane/turning.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double longestTurn = 0.15; // [rad] a step while the axis moves
constexpr double mostSteps = 20'000; // a segment; faster than that nothing can be seen

using Vector = Spin<double>;

Vector plus(const Vector& a, const Vector& b, double factor) {
    return {a.x + b.x * factor, a.y + b.y * factor, a.z + b.z * factor};
}

Vector times(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double length(const Vector& a) {
    return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

Orientation unit(const Orientation& q) {
    const double n = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {q.w / n, q.x / n, q.y / n, q.z / n};
}

// Of ω linear in time, from `from` to `to`: ∫ω, and the first term of how its parts do not commute.
Orientation step(const Rotation& r, double from, double to) {
    const double h = to - from;
    const Vector middle = plus(r.spin, r.rate, (from + to) / 2);
    Vector angle{middle.x * h, middle.y * h, middle.z * h};
    angle = plus(angle, times(middle, r.rate), -h * h * h / 12);
    return turnBy(angle);
}

} // namespace

Orientation operator*(const Orientation& a, const Orientation& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Orientation turnBy(const Spin<double>& angle) {
    const double all = length(angle);
    if (all == 0)
        return {};
    const double s = std::sin(all / 2) / all;
    return {std::cos(all / 2), angle.x * s, angle.y * s, angle.z * s};
}

Direction turned(const Orientation& q, const Direction& d) {
    const Vector axis{q.x, q.y, q.z};
    const Vector v{d.x, d.y, d.z};
    const Vector twice = plus({}, times(axis, v), 2);
    const Vector moved = plus(plus(v, twice, q.w), times(axis, twice), 1);
    return {moved.x, moved.y, moved.z};
}

Orientation turnDuring(const Rotation& r, double duration) {
    const Vector last = plus(r.spin, r.rate, duration);
    const double fastest = std::max(length(r.spin), length(last));
    const bool fixedAxis = length(times(r.spin, r.rate)) <= 1e-14 * length(r.spin) * length(r.rate);
    if (fixedAxis)
        return step(r, 0, duration);
    const double h = longestTurn / std::max(fastest, std::sqrt(length(r.rate)));
    const double steps = std::clamp(std::ceil(duration / h), 1.0, mostSteps);
    Orientation q;
    for (double k = 0; k < steps; ++k)
        q = step(r, duration * (k / steps), duration * ((k + 1) / steps)) * q;
    return unit(q);
}

Turning::Turning(std::span<const Segment> segments, std::span<const Rotation> rotations)
    : m_rotations(rotations.begin(), rotations.end()) {
    Orientation q;
    for (std::size_t k = 0; k < m_rotations.size(); ++k) {
        m_times.push_back(segments[k].start);
        if (k > 0)
            q = unit(turnDuring(m_rotations[k - 1], m_times[k] - m_times[k - 1]) * q);
        m_starts.push_back(q);
    }
}

Orientation Turning::at(double time) const {
    if (!isKnown())
        return {};
    const auto after = std::upper_bound(m_times.begin(), m_times.end(), time);
    const std::size_t k = after == m_times.begin() ? 0 : std::size_t(after - m_times.begin()) - 1;
    return turnDuring(m_rotations[k], std::max(0.0, time - m_times[k])) * m_starts[k];
}

} // namespace thetalane

#include "core/timeline/timeline.h"

#include <algorithm>

namespace thetalane {
namespace {

using Collisions = std::vector<Collision>;

// Where the run of collisions that are the same in `what` as the one at `begin` ends.
template <class What> std::size_t endOfSame(const Collisions& collisions, std::size_t begin, What&& what) {
    std::size_t end = begin + 1;
    while (end < collisions.size() && what(collisions[begin], collisions[end]))
        ++end;
    return end;
}

// The engine's passes are any numbers; those of a group count from 1, and 0 is a pass of its own.
void numberPasses(Collisions& collisions, std::size_t begin, std::size_t groupEnd) {
    int pass = 0;
    while (begin < groupEnd) {
        const std::size_t end =
            endOfSame(collisions, begin, [](auto& a, auto& b) { return a.pass != 0 && a.pass == b.pass; });
        ++pass;
        for (std::size_t k = begin; k < end; ++k) {
            collisions[k].pass = pass;
            collisions[k].together = int(end - begin);
        }
        begin = end;
    }
}

// Contacts at the same instant belong together; a contact alone belongs to no group.
void numberGroups(Collisions& collisions) {
    int group = 0;
    for (std::size_t i = 0; i < collisions.size();) {
        const std::size_t end = endOfSame(collisions, i, [](auto& a, auto& b) { return a.time == b.time; });
        if (end - i > 1) {
            numberPasses(collisions, i, end);
            ++group;
            for (std::size_t k = i; k < end; ++k)
                collisions[k].group = group;
        } else {
            collisions[i].pass = 0;
        }
        i = end;
    }
}

BodyState along(const Segment& s, double t) {
    const double tau = t - s.start;
    return {s.position + s.velocity * tau + s.acceleration * (tau * tau / 2),
            s.velocity + s.acceleration * tau, s.place};
}

void turnAlong(const Rotation& r, double tau, BodyState& state) {
    state.spin = {r.spin.x + r.rate.x * tau, r.spin.y + r.rate.y * tau, r.spin.z + r.rate.z * tau};
    state.phase = r.phase;
}

} // namespace

Timeline::Timeline(std::size_t bodyCount, TimelineRecord record)
    : m_segments(record.segments.size())
    , m_firstSegment(bodyCount + 1, 0)
    , m_collisions(std::move(record.collisions))
    , m_departures(std::move(record.departures))
    , m_lasting(std::move(record.lasting))
    , m_struckSpeeds(std::move(record.struckSpeeds))
    , m_collisionCount(record.collisionCount)
    , m_endTime(record.endTime)
    , m_endReason(record.endReason) {
    // A counting sort by body keeps each body's segments in the order of time.
    for (const auto& s : record.segments)
        ++m_firstSegment[std::size_t(s.body) + 1];
    for (std::size_t i = 0; i < bodyCount; ++i)
        m_firstSegment[i + 1] += m_firstSegment[i];
    std::vector<std::size_t> next(m_firstSegment.begin(), m_firstSegment.end() - 1);
    m_rotations.resize(record.rotations.size());
    for (std::size_t k = 0; k < record.segments.size(); ++k) {
        const std::size_t place = next[std::size_t(record.segments[k].body)]++;
        m_segments[place] = record.segments[k].segment;
        if (!m_rotations.empty())
            m_rotations[place] = record.rotations[k];
    }
    numberGroups(m_collisions);
}

std::span<const Segment> Timeline::segments(std::size_t body) const {
    return std::span(m_segments)
        .subspan(m_firstSegment[body], m_firstSegment[body + 1] - m_firstSegment[body]);
}

std::span<const Rotation> Timeline::rotations(std::size_t body) const {
    if (m_rotations.empty())
        return {};
    return std::span(m_rotations)
        .subspan(m_firstSegment[body], m_firstSegment[body + 1] - m_firstSegment[body]);
}

BodyState Timeline::bodyAt(std::size_t body, double t) const {
    t = std::clamp(t, 0.0, m_endTime);
    const auto own = segments(body);
    const auto after = std::upper_bound(own.begin(), own.end(), t,
                                        [](double time, const Segment& s) { return time < s.start; });
    const std::size_t k = after == own.begin() ? 0 : std::size_t(after - own.begin()) - 1;
    BodyState state = along(own[k], t);
    if (!m_rotations.empty())
        turnAlong(rotations(body)[k], t - own[k].start, state);
    return state;
}

std::vector<BodyState> Timeline::stateAt(double t) const {
    std::vector<BodyState> states;
    stateAt(t, states);
    return states;
}

void Timeline::stateAt(double t, std::vector<BodyState>& states) const {
    states.resize(bodyCount());
    for (std::size_t i = 0; i < states.size(); ++i)
        states[i] = bodyAt(i, t);
}

std::optional<std::size_t> Timeline::collisionBefore(double t) const {
    const auto it = std::lower_bound(m_collisions.begin(), m_collisions.end(), t,
                                     [](const Collision& c, double time) { return c.time < time; });
    if (it == m_collisions.begin())
        return std::nullopt;
    return std::size_t(it - m_collisions.begin()) - 1;
}

std::optional<std::size_t> Timeline::collisionAfter(double t) const {
    const auto it = std::upper_bound(m_collisions.begin(), m_collisions.end(), t,
                                     [](double time, const Collision& c) { return time < c.time; });
    if (it == m_collisions.end())
        return std::nullopt;
    return std::size_t(it - m_collisions.begin());
}

Totals totals(const Scene& scene, std::span<const BodyState> states) {
    Totals sum;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double mass = scene.bodies[i].mass;
        sum.momentum = sum.momentum + mass * states[i].velocity;
        sum.energy += mass * dot(states[i].velocity, states[i].velocity) / 2;
    }
    return sum;
}

} // namespace thetalane

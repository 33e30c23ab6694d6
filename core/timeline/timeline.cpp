#include "core/timeline/timeline.h"

#include <algorithm>

namespace thetalane {
namespace {

// Contacts at the same instant belong together; a contact alone belongs to no group.
void numberGroups(std::vector<Collision>& collisions) {
    int group = 0;
    for (std::size_t i = 0; i < collisions.size();) {
        std::size_t j = i + 1;
        while (j < collisions.size() && collisions[j].time == collisions[i].time)
            ++j;
        if (j - i > 1) {
            ++group;
            for (std::size_t k = i; k < j; ++k)
                collisions[k].group = group;
        }
        i = j;
    }
}

BodyState along(const Segment& s, double t) {
    const double tau = t - s.start;
    return {s.position + s.velocity * tau + s.acceleration * (tau * tau / 2),
            s.velocity + s.acceleration * tau, s.place};
}

} // namespace

Timeline::Timeline(std::size_t bodyCount, TimelineRecord record)
    : m_segments(record.segments.size())
    , m_firstSegment(bodyCount + 1, 0)
    , m_collisions(std::move(record.collisions))
    , m_departures(std::move(record.departures))
    , m_collisionCount(record.collisionCount)
    , m_endTime(record.endTime)
    , m_endReason(record.endReason) {
    // A counting sort by body keeps each body's segments in the order of time.
    for (const auto& s : record.segments)
        ++m_firstSegment[std::size_t(s.body) + 1];
    for (std::size_t i = 0; i < bodyCount; ++i)
        m_firstSegment[i + 1] += m_firstSegment[i];
    std::vector<std::size_t> next(m_firstSegment.begin(), m_firstSegment.end() - 1);
    for (const auto& s : record.segments)
        m_segments[next[std::size_t(s.body)]++] = s.segment;
    numberGroups(m_collisions);
}

std::span<const Segment> Timeline::segments(std::size_t body) const {
    return std::span(m_segments)
        .subspan(m_firstSegment[body], m_firstSegment[body + 1] - m_firstSegment[body]);
}

BodyState Timeline::bodyAt(std::size_t body, double t) const {
    t = std::clamp(t, 0.0, m_endTime);
    const auto own = segments(body);
    const auto after = std::upper_bound(own.begin(), own.end(), t,
                                        [](double time, const Segment& s) { return time < s.start; });
    return along(after == own.begin() ? own.front() : *(after - 1), t);
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

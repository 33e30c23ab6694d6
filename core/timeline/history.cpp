#include "core/timeline/history.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr std::size_t mostLookups = 600'000; // bodies times moments: some tens of milliseconds
constexpr std::size_t fewest = 24;
constexpr std::size_t mostBetween = 24; // of a parabola between two events

// When anything begins to move in another way, from `from` to `to` without the ends; ascending.
std::vector<double> eventTimes(const Timeline& timeline, double from, double to) {
    std::vector<double> times;
    for (std::size_t body = 0; body < timeline.bodyCount(); ++body)
        for (const Segment& s : timeline.segments(body))
            if (s.start > from && s.start < to)
                times.push_back(s.start);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

void addEvenly(std::vector<double>& times, double from, double to, std::size_t between) {
    for (std::size_t k = 1; k <= between; ++k)
        times.push_back(from + (to - from) * double(k) / double(between + 1));
}

std::vector<double> evenTimes(double from, double to, std::size_t count) {
    std::vector<double> times{from};
    addEvenly(times, from, to, count - 2);
    times.push_back(to);
    return times;
}

std::vector<double> aroundEvents(const std::vector<double>& events, double from, double to,
                                 std::size_t between) {
    std::vector<double> times{from};
    double last = from;
    for (const double event : events) {
        addEvenly(times, last, event, between);
        times.push_back(std::nextafter(event, from));
        times.push_back(event);
        last = event;
    }
    addEvenly(times, last, to, between);
    times.push_back(to);
    return times;
}

} // namespace

CentreOfMass centreOfMass(const Scene& scene, std::span<const BodyState> states) {
    CentreOfMass centre;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double mass = scene.bodies[i].mass;
        centre.mass += mass;
        centre.position = centre.position + mass * states[i].position;
        centre.velocity = centre.velocity + mass * states[i].velocity;
    }
    if (centre.mass > 0) {
        centre.position = centre.position * (1 / centre.mass);
        centre.velocity = centre.velocity * (1 / centre.mass);
    }
    return centre;
}

History history(const Scene& scene, const Timeline& timeline, double from, double to, std::size_t most) {
    if (timeline.bodyCount() == 0 || !(to >= from))
        return {};
    most = std::max(fewest, std::min(most, mostLookups / timeline.bodyCount()));
    const std::vector<double> events = eventTimes(timeline, from, to);
    History result;
    result.everyEvent = 2 * events.size() + 2 <= most;
    const std::size_t left = result.everyEvent ? most - 2 * events.size() - 2 : 0;
    const std::size_t between = scene.friction ? std::min(mostBetween, left / (events.size() + 1)) : 0;
    const std::vector<double> times =
        result.everyEvent ? aroundEvents(events, from, to, between) : evenTimes(from, to, most);
    std::vector<BodyState> states;
    for (const double t : times) {
        timeline.stateAt(t, states);
        result.moments.push_back({t, totals(scene, states), centreOfMass(scene, states)});
    }
    return result;
}

} // namespace thetalane

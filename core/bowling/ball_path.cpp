#include "core/bowling/ball_path.h"

#include "core/motion/friction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

using namespace regulation;

// Where the entry is taken.
constexpr double lineBeforePins = -(ballRadius + pinRadius);
constexpr double edge = laneWidth / 2;

FloorBody<double> ballOf(const Friction& friction) {
    return {ballRadius, 1 / Body{}.inertia, friction.rolling};
}

Floor<double> floorFor(const Friction& friction) {
    Floor<double> floor{friction.gravity, {{}, {friction.ball}}};
    for (const OilZone& oil : friction.oil) {
        floor.zones.edges.insert(floor.zones.edges.end(), {oil.from, oil.to});
        floor.zones.friction.insert(floor.zones.friction.end(), {oil.friction, friction.ball});
    }
    return floor;
}

// Whether x leaves the lane within the first `time` of a stretch: at an end, or where it turns back.
bool leavesLane(const FloorState<double>& s, double ax, double time) {
    const auto out = [&](double t) {
        return std::abs(s.position.x + (s.velocity.x + ax * t / 2) * t) > edge;
    };
    const double turns = ax != 0 ? -s.velocity.x / ax : -1;
    return out(0) || out(time) || (turns > 0 && turns < time && out(turns));
}

// The entry with its lateral bounds watched or not: the search may look over the edge of the lane.
std::optional<Entry> followed(const Throw& t, const Floor<double>& floor, const FloorBody<double>& ball,
                              bool onLane) {
    const Vec2d v{t.speed * std::sin(t.direction), t.speed * std::cos(t.direction)};
    FloorState<double> s = onFloor<double>({t.position, -foulLineToHeadPin}, v, throwSpin(t), ball, floor);
    constexpr int mostStretches = 64; // a few zones, slid through and rolled through
    for (int k = 0; k < mostStretches && s.phase != FloorPhase::Rest; ++k) {
        const Stretch<double> stretch = nextStretch(s, ball, floor);
        const double there = timeToCross(lineBeforePins - s.position.y, s.velocity.y, stretch.acceleration.y);
        const double time = std::min(there, stretch.lasts);
        if (onLane && leavesLane(s, stretch.acceleration.x, time))
            return std::nullopt;
        if (there <= stretch.lasts) {
            s = stateWithin(s, stretch, ball, floor, there);
            const double slope = s.velocity.x / s.velocity.y;
            return Entry{s.position.x - lineBeforePins * slope, -std::atan(slope), norm(s.velocity)};
        }
        s = stateAfter(s, stretch, ball, floor);
    }
    return std::nullopt;
}

// Newton's method in direction and axis, the derivatives by differences. Both answer nearly in proportion, so
// that a few rounds do.
std::optional<Throw> solved(Throw t, double offset, double angle, const Friction& f) {
    constexpr double nudge = 1e-6, closeEnough = 1e-10, furthestAxis = 1.5; // rad, and m
    constexpr int mostRounds = 40;
    const Floor<double> floor = floorFor(f);
    const FloorBody<double> ball = ballOf(f);
    t.direction = 0;
    t.axis = angle < 0 ? -0.5 : 0.5;
    for (int round = 0; round < mostRounds; ++round) {
        const auto at = followed(t, floor, ball, false);
        if (!at)
            return std::nullopt;
        const Vec2d miss{offset - at->offset, angle - at->angle};
        if (std::abs(miss.x) < closeEnough && std::abs(miss.y) < closeEnough)
            return followed(t, floor, ball, true) ? std::optional(t) : std::nullopt;
        Throw turned = t, tilted = t;
        turned.direction += nudge;
        tilted.axis += nudge;
        const auto byDirection = followed(turned, floor, ball, false);
        const auto byAxis = followed(tilted, floor, ball, false);
        if (!byDirection || !byAxis)
            return std::nullopt;
        const Vec2d d{(byDirection->offset - at->offset) / nudge, (byDirection->angle - at->angle) / nudge};
        const Vec2d a{(byAxis->offset - at->offset) / nudge, (byAxis->angle - at->angle) / nudge};
        const double det = cross(d, a);
        if (!(std::abs(det) > 1e-9)) // without spin the axis changes nothing
            return std::nullopt;
        constexpr double longestStep = 0.5;
        const auto step = [=](double s) { return std::clamp(s, -longestStep, longestStep); };
        t.direction += step(cross(miss, a) / det);
        t.axis = std::clamp(t.axis + step(cross(d, miss) / det), -furthestAxis, furthestAxis);
    }
    return std::nullopt;
}

} // namespace

std::optional<Entry> entryOf(const Throw& t, const std::optional<Friction>& friction) {
    const Friction none;
    const Friction& f = friction ? *friction : none;
    return followed(t, floorFor(f), ballOf(f), true);
}

std::optional<Throw> throwArriving(Throw base, double offset, double angle,
                                   const std::optional<Friction>& friction) {
    if (friction)
        return solved(base, offset, angle, *friction);
    base.direction = -angle;
    base.position = offset + foulLineToHeadPin * std::tan(angle);
    return entryOf(base, friction) ? std::optional(base) : std::nullopt;
}

} // namespace thetalane

#include "ui/aim/aim_geometry.h"

#include "ui/panels/throw_terms.h"

#include <QString>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double edge = regulation::laneWidth / 2; // of the lane, where a ball's centre may still be
constexpr double slowest = 1, fastest = 16;        // m/s: what the arrow has room for
constexpr double foulLine = -regulation::foulLineToHeadPin;

// Only where the hand wants further out than both the span and where it was: a number that was typed stays
// where it is until it is moved.
double held(double value, double low, double high, double before, AimLimit below, AimLimit above,
            AimLimit& limit) {
    low = std::min(low, before);
    high = std::max(high, before);
    if (value < low)
        limit = below;
    else if (value > high)
        limit = above;
    return std::clamp(value, low, high);
}

// Twelve digits: 0.1 + 0.2 is to be 0.3.
double rounded(double value) {
    return QString::number(value, 'g', 12).toDouble();
}

Aimed atPosition(const Throw& from, double position) {
    Aimed aimed{from};
    aimed.ballThrow.position =
        held(position, -edge, edge, from.position, AimLimit::EdgeOfLane, AimLimit::EdgeOfLane, aimed.limit);
    return aimed;
}

Aimed inDirection(const Throw& from, double direction) {
    Aimed aimed{from};
    aimed.ballThrow.direction = held(direction, radians(directionSpan.low), radians(directionSpan.high),
                                     from.direction, AimLimit::Steepest, AimLimit::Steepest, aimed.limit);
    return aimed;
}

Aimed atSpeed(const Throw& from, double speed) {
    Aimed aimed{from};
    aimed.ballThrow.speed =
        held(speed, slowest, fastest, from.speed, AimLimit::Slowest, AimLimit::Fastest, aimed.limit);
    return aimed;
}

Aimed turning(const Throw& from, double spin, double axis) {
    Aimed aimed{from};
    aimed.ballThrow.axis = held(axis, radians(axisSpan.low), radians(axisSpan.high), from.axis,
                                AimLimit::SideSpin, AimLimit::SideSpin, aimed.limit);
    aimed.ballThrow.spin = held(spin, 0, rotationSpan.high * perRpm, from.spin, AimLimit::None,
                                AimLimit::MostRotation, aimed.limit);
    return aimed;
}

Aimed turnedTo(const Throw& from, const Vec2d& place) {
    const Vec2d v = place - placeOf(AimPart::Ball, from);
    const double distance = norm(v);
    const double spin = std::max(0.0, (distance - rotationRing) / metresPerRotation) * perRpm;
    if (distance < rotationRing / 2) // too near to have a bearing
        return turning(from, 0, from.axis);
    const double bearing = std::atan2(v.x, v.y); // to the right of straight down the lane
    return turning(from, spin, std::remainder(from.direction - bearing, 2 * std::numbers::pi));
}

} // namespace

Vec2d pullOf(const Throw& t) {
    return {std::sin(t.direction - t.axis), std::cos(t.direction - t.axis)};
}

Vec2d placeOf(AimPart part, const Throw& t) {
    const Vec2d ball{t.position, foulLine};
    switch (part) {
    case AimPart::Direction:
        return ball + Vec2d{aimDistance * std::tan(t.direction), aimDistance};
    case AimPart::Speed: {
        const double length = std::min(t.speed, fastest) * metresPerAimedSpeed;
        return ball + Vec2d{std::sin(t.direction), std::cos(t.direction)} * length;
    }
    case AimPart::Rotation:
        return ball + pullOf(t) * (rotationRing + metresPerRotation * t.spin / perRpm);
    case AimPart::Ball:
        break;
    }
    return ball;
}

Aimed movedBy(const Throw& from, AimPart part, const Vec2d& way) {
    switch (part) {
    case AimPart::Direction:
        return way.x == 0 ? Aimed{from}
                          : inDirection(from, std::atan(std::tan(from.direction) + way.x / aimDistance));
    case AimPart::Speed: {
        const double along = way.x * std::sin(from.direction) + way.y * std::cos(from.direction);
        return along == 0 ? Aimed{from}
                          : atSpeed(from, std::min(from.speed, fastest) + along / metresPerAimedSpeed);
    }
    case AimPart::Rotation:
        return way == Vec2d{} ? Aimed{from} : turnedTo(from, placeOf(AimPart::Rotation, from) + way);
    case AimPart::Ball:
        break;
    }
    return way.x == 0 ? Aimed{from} : atPosition(from, from.position + way.x);
}

Aimed steppedBy(const Throw& from, AimPart part, int right, int up, bool fine) {
    const double share = fine ? 0.1 : 1;
    switch (part) {
    case AimPart::Direction:
        return inDirection(from,
                           radians(rounded(from.direction / perDegree + right * directionSpan.step * share)));
    case AimPart::Speed:
        return atSpeed(from, rounded(from.speed + (up ? up : right) * 0.1 * share));
    case AimPart::Rotation: {
        // Right turns the bead to the right: towards a hook to the right.
        const double axis = right ? radians(rounded(from.axis / perDegree - right * 5 * share)) : from.axis;
        const double spin =
            up ? std::max(0.0, rounded(from.spin / perRpm + up * rotationSpan.step * share)) * perRpm
               : from.spin;
        return turning(from, spin, axis);
    }
    case AimPart::Ball:
        break;
    }
    return atPosition(from, rounded(from.position + right * positionSpan.step * share));
}

} // namespace thetalane

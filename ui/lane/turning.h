// How a ball has turned: its orientation at any time, out of the spins that the timeline keeps.
#pragma once

#include "core/timeline/timeline.h"

#include <span>
#include <vector>

namespace thetalane {

// How something is turned in space; world axes, z up.
struct Orientation {
    double w = 1, x = 0, y = 0, z = 0; // a unit quaternion

    friend bool operator==(const Orientation&, const Orientation&) = default;
    friend Orientation operator*(const Orientation& a, const Orientation& b); // b first, then a
};

// By |angle| about angle's direction [rad].
Orientation turnBy(const Spin<double>& angle);

struct Direction {
    double x = 0, y = 0, z = 0;
};
Direction turned(const Orientation& turn, const Direction& direction);

// The turn after `duration` [s] of ω(t) = spin + rate t. Exact where the axis stays; where it moves, in short
// steps of fourth order (Magnus), always the same ones.
Orientation turnDuring(const Rotation& rotation, double duration);

// One ball's. The orientation at the start of each segment is kept, so any time is one look-up and one
// segment: the same bits however one got there.
class Turning {
public:
    Turning() = default;
    Turning(std::span<const Segment> segments, std::span<const Rotation> rotations);

    bool isKnown() const { return !m_starts.empty(); }
    Orientation at(double time) const; // [s]

private:
    std::vector<double> m_times;
    std::vector<Rotation> m_rotations;
    std::vector<Orientation> m_starts;
};

} // namespace thetalane

// How a ball has turned: its orientation at any time, out of the spins that the timeline keeps.
#pragma once

#include "core/timeline/timeline.h"

#include <span>
#include <vector>

namespace thetalane {

// A turn of space; world axes, z up.
struct Turn {
    double w = 1, x = 0, y = 0, z = 0; // a unit quaternion

    friend bool operator==(const Turn&, const Turn&) = default;
    friend Turn operator*(const Turn& a, const Turn& b); // b first, then a
};

// By |angle| about angle's direction [rad].
Turn turnBy(const Spin<double>& angle);

struct Direction {
    double x = 0, y = 0, z = 0;
};
Direction turned(const Turn& turn, const Direction& direction);

// The turn after `duration` [s] of ω(t) = spin + rate t. Exact where the axis stays; where it moves, in short
// steps of fourth order (Magnus), always the same ones.
Turn turnDuring(const Rotation& rotation, double duration);

// One ball's. The orientation at the start of each segment is kept, so any time is one look-up and one
// segment: the same bits however one got there.
class Turning {
public:
    Turning() = default;
    Turning(std::span<const Segment> segments, std::span<const Rotation> rotations);

    bool isKnown() const { return !m_starts.empty(); }
    Turn at(double time) const; // [s]

private:
    std::vector<double> m_times;
    std::vector<Rotation> m_rotations;
    std::vector<Turn> m_starts;
};

} // namespace thetalane

// A floor whose friction changes along y, and when a body crosses a line.
#pragma once

#include "core/math/vec2.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace thetalane {

// Time until a body at `gap` >= 0 before a line, nearing it with `speed` and `acceleration` (both positive
// towards it), passes it; infinity if it only touches it or never comes. The smallest t >= 0 with
// gap - speed t - ½ acceleration t² = 0 at which it moves across.
template <class Real> Real timeToCross(const Real& gap, const Real& speed, const Real& acceleration) {
    using std::sqrt;
    const Real zero(0), never = std::numeric_limits<Real>::infinity();
    if (gap == zero && speed == zero)
        return acceleration > zero ? zero : never;
    const Real passing2 = speed * speed + 2 * acceleration * gap; // its speed at the line, squared
    if (!(passing2 > zero))
        return never;
    const Real passing = sqrt(passing2);
    if (speed >= zero)
        return 2 * gap / (speed + passing);
    return acceleration > zero ? (passing - speed) / acceleration : never;
}

// Zone k lies between edges[k - 1] and edges[k]; one more friction than there are edges.
template <class Real> struct FrictionZones {
    std::vector<Real> edges;             // y [m], ascending
    std::vector<Real> friction{Real(0)}; // μ of each zone

    // The zone of a body at y; on an edge, of the side to which it moves (up for a positive direction).
    int zoneAt(const Real& y, bool up) const {
        int zone = 0;
        while (zone < int(edges.size()) &&
               (edges[std::size_t(zone)] < y || (up && edges[std::size_t(zone)] == y)))
            ++zone;
        return zone;
    }

    Real timeToUpper(int zone, const Real& y, const Real& vy, const Real& ay) const {
        if (zone == int(edges.size()))
            return std::numeric_limits<Real>::infinity();
        return timeToCross<Real>(notNegative(edges[std::size_t(zone)] - y), vy, ay);
    }

    Real timeToLower(int zone, const Real& y, const Real& vy, const Real& ay) const {
        if (zone == 0)
            return std::numeric_limits<Real>::infinity();
        return timeToCross<Real>(notNegative(y - edges[std::size_t(zone - 1)]), -vy, -ay);
    }

private:
    static Real notNegative(const Real& x) { return x > Real(0) ? x : Real(0); }
};

} // namespace thetalane

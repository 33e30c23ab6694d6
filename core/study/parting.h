// When and where a run leaves another one, for ghosts drawn over each other.
#pragma once

#include "core/engine/engine.h"

#include <optional>

namespace thetalane {

struct Parting {
    double time = 0; // s
    int body = 0;    // which is the first to be off by more than the tolerance
    Vec2d truth;     // where it is in the one, and in the other [m]
    Vec2d run;
};

// Nothing where they stay together to the end of the shorter one.
std::optional<Parting> firstParting(const Run& truth, const Run& run, double tolerance); // m

// The first contact that differs, as an index into truth's collisions (one past the last where run has more);
// nothing where all are the same. Contacts at one instant of either have no order.
std::optional<std::size_t> firstDifference(const Timeline& truth, const Timeline& run);

} // namespace thetalane

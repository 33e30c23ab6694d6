// When a pin goes down, and which way: what is seen of it on the lane, where the physics knows discs alone.
#pragma once

#include "core/engine/engine.h"

#include <optional>
#include <vector>

namespace thetalane {

struct Fall {
    double time = 0; // s
    Vec2d along;     // unit: the way it was struck
};

// Of each body: the collision that left a pin with more than its tipping speed, or its leaving the lane; as
// pinsDown() counts.
std::vector<std::optional<Fall>> fallsOf(const Run& run);

// How far it has gone down: 0 upright, 1 lying. A falling pin takes about so long; the engine has no such
// motion, so this is a picture and nothing is read from it.
double tipped(const Fall& fall, double time);

} // namespace thetalane

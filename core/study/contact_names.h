// Who met whom, as a number that can be compared and sorted.
#pragma once

#include "core/timeline/timeline.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace thetalane {

using MetName = std::int64_t;

// Of two bodies, or of a body and a wall.
inline MetName nameOf(const Collision& c) {
    return c.first * (std::int64_t(1) << 32) + (c.isWall() ? -1 - int(c.side) : c.second);
}

inline std::vector<MetName> namesOf(std::span<const Collision> collisions) {
    std::vector<MetName> names;
    names.reserve(collisions.size());
    for (const Collision& c : collisions)
        names.push_back(nameOf(c));
    return names;
}

inline std::vector<MetName> sortedNames(std::span<const Collision> collisions) {
    auto names = namesOf(collisions);
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace thetalane

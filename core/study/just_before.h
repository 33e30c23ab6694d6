// The moment to hold at before a collision: the two are seen to be about to meet, and nothing of it has
// happened yet.
#pragma once

#include "core/timeline/timeline.h"

namespace thetalane {

// [s] The two are about a seventh of their distance from each other, unless something else happens so shortly
// before; then halfway to that.
double justBefore(const Timeline& timeline, std::size_t collision);

} // namespace thetalane

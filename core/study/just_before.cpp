#include "core/study/just_before.h"

#include <algorithm>

namespace thetalane {

double justBefore(const Timeline& timeline, std::size_t collision) {
    const Collision& c = timeline.collisions()[collision];
    const auto earlier = timeline.collisionBefore(c.time);
    const double since = earlier ? timeline.collisions()[*earlier].time : 0;
    const double approach = c.steps.rotated.second.x - c.steps.rotated.first.x;
    const double half = (c.time - since) / 2;
    return c.time - (approach > 0 ? std::min(half, 0.15 * c.steps.contact.Z / approach) : half);
}

} // namespace thetalane

#include "tests/benchmarks/worlds.h"

#include <algorithm>

namespace thetalane::benchmarks {

std::vector<WorldKind> worlds() {
    std::vector<WorldKind> all;
#ifdef THETALANE_HAS_BOX2D
    all.push_back({box2dName(), makeBox2d, 10'000});
    all.push_back({box2dName() + ", bullets", makeBox2dBullets, 1000});
#endif
#ifdef THETALANE_HAS_CHIPMUNK
    all.push_back({chipmunkName(), makeChipmunk});
#endif
    return all;
}

std::string missingWorlds() {
    std::string missing;
#ifndef THETALANE_HAS_BOX2D
    missing += "Box2D 2.4 was not found when this was configured (libbox2d-dev): its rows are left out.\n";
#endif
#ifndef THETALANE_HAS_CHIPMUNK
    missing +=
        "Chipmunk 7 was not found when this was configured (libchipmunk-dev): its rows are left out.\n";
#endif
    return missing;
}

double smallestDiameter(const Scene& scene) {
    double least = 2 * scene.bodies.front().radius;
    for (const Body& b : scene.bodies)
        least = std::min(least, 2 * b.radius);
    return least;
}

double highestSpeed(const Scene& scene) {
    double most = 0;
    for (const Body& b : scene.bodies)
        most = std::max(most, norm(b.velocity));
    return most;
}

std::vector<WallBox> wallBoxes(const Frame& frame, double thick) {
    const double left = *frame.left, right = *frame.right, bottom = *frame.bottom, top = *frame.top;
    const Vec2d middle{(left + right) / 2, (bottom + top) / 2};
    const double t = thick / 2, w = (right - left) / 2 + thick, h = (top - bottom) / 2 + thick;
    return {{{left - t, middle.y}, {t, h}},
            {{right + t, middle.y}, {t, h}},
            {{middle.x, bottom - t}, {w, t}},
            {{middle.x, top + t}, {w, t}}};
}

} // namespace thetalane::benchmarks

// Other people's physics libraries, each behind the same few calls: bodies and walls of a scene, friction 0.
#pragma once

#include "core/scene/scene.h"
#include "core/timeline/timeline.h"

#include <memory>
#include <string>
#include <vector>

namespace thetalane::benchmarks {

class World {
public:
    virtual ~World() = default;
    virtual void step() = 0;
    virtual void read(std::vector<BodyState>& states) const = 0; // in the scene's own units
};

struct WorldKind {
    std::string name;
    // Bodies, walls and restitution of the scene, to be moved by steps of h.
    std::unique_ptr<World> (*make)(const Scene& scene, double h);
    std::size_t mostBodies = std::size_t(-1); // with more, a step takes seconds
};

// Those that were found when this was configured; and in words, which were not.
std::vector<WorldKind> worlds();
std::string missingWorlds();

// What both libraries need to be given fairly.
double smallestDiameter(const Scene& scene);
double highestSpeed(const Scene& scene);

// The four walls as boxes, `thick` metres outwards, so that nothing skips through within a step.
struct WallBox {
    Vec2d middle;
    Vec2d half;
};
std::vector<WallBox> wallBoxes(const Frame& frame, double thick);

#ifdef THETALANE_HAS_BOX2D
std::unique_ptr<World> makeBox2d(const Scene& scene, double h);
std::unique_ptr<World> makeBox2dBullets(const Scene& scene, double h);
std::string box2dName();
#endif
#ifdef THETALANE_HAS_CHIPMUNK
std::unique_ptr<World> makeChipmunk(const Scene& scene, double h);
std::string chipmunkName(); // says so if it is a debug build
#endif

} // namespace thetalane::benchmarks

// Scenes of many bodies: gases, the break of a triangle, and two masses that count π.
#pragma once

#include "core/scene/scene.h"

namespace thetalane {

// `count` equal elastic discs of 1 kg in a closed square of 2 m, which they fill to `packing` (up to 0.5); at
// random a little off the points of a square lattice. Velocities are normally distributed as nearly as twelve
// summed uniform numbers are, of 1 m/s (rms) and no total momentum. The same bits on every machine.
Scene gasScene(int count, double packing = 0.4);

Scene breakScene();
Scene countingScene(); // of 314 collisions

} // namespace thetalane

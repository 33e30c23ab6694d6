// What a study runs: one scene, or many throws. The same seed gives the same throws on every machine.
#pragma once

#include "core/scene/bowling_scene.h"

#include <cstdint>
#include <vector>

namespace thetalane {

struct StudyCases {
    std::vector<Scene> scenes;
    double until = 2; // [s]
};

inline constexpr int standardThrows = 4000;
inline constexpr std::uint64_t standardSeed = 2026;

// A ball of 6.8 kg at 6.8 m/s at the rack, without friction, 2 s: the offset of its path from the
// head pin is uniform in -16 to 16 cm, its entry angle in 0 to 6°. Random numbers: std::mt19937_64(seed), its
// upper 53 bits, offset before angle.
StudyCases rackThrows(int count, std::uint64_t seed = standardSeed,
                      double restitution = defaultPinRestitution);

// The whole lane with friction, oil and spin, 6 s: position uniform in -40 to 40 cm, direction in -2.5° to
// 2.5°, speed in 7 to 9 m/s, spin in 0 to 35 rad/s, axis in -30° to 30°, drawn in this order, all five again
// where the ball would not come to the head pin's row within 16 cm of the head pin.
StudyCases laneThrows(int count, std::uint64_t seed = standardSeed,
                      double restitution = defaultPinRestitution);

StudyCases oneScene(Scene scene, double until);

} // namespace thetalane

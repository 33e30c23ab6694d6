// Eleven discs in a closed box, e = 1: collisions without end.
#pragma once

#include "core/scene/scene.h"

#include <cmath>

namespace thetalane::benchmarks {

inline Scene elevenInABox() {
    Scene scene;
    scene.frame = Frame{-1.0, 1.0, -0.8, 0.8, 1.0};
    scene.bodies.reserve(11);
    for (int i = 0; i < 11; ++i) {
        const double angle = 2.4 * i; // spread over the circle
        scene.bodies.push_back({std::to_string(i),
                                BodyKind::Ball,
                                1 + 0.1 * i,
                                0.08,
                                {-0.75 + 0.5 * (i % 4), -0.5 + 0.5 * double(i / 4)},
                                {3 * std::cos(angle), 3 * std::sin(angle)}});
    }
    return scene;
}

} // namespace thetalane::benchmarks

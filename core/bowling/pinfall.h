// Which pins were touched, and which went down, by a given time.
#pragma once

#include "core/scene/scene.h"
#include "core/timeline/timeline.h"

#include <vector>

namespace thetalane {

// A pin that gets this speed tips over its base [m/s]: ½ v² = g (√(h² + r²) - h), with the centre of gravity
// h up and a base of radius r. About 0.21 m/s for a regulation pin.
double pinTippingSpeed();

// Body indices, in the order of the scene.
std::vector<int> pinsTouched(const Scene& scene, const Timeline& timeline, double t);
std::vector<int> pinsDown(const Scene& scene, const Timeline& timeline, double t);

} // namespace thetalane

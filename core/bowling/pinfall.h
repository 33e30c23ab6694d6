// Which pins were touched, and which went down, by a given time.
#pragma once

#include "core/scene/bowling_scene.h"
#include "core/timeline/timeline.h"

#include <vector>

namespace thetalane {

// A pin that gets this speed tips over its base [m/s]: ½ v² = g (√(h² + r²) - h), with the centre of gravity
// h up and a base of radius r. About 0.21 m/s for a regulation pin.
double pinTippingSpeed();

// Body indices, in the order of the scene. Down is what a collision left with more than the tipping speed,
// and what left the lane.
std::vector<int> pinsTouched(const Scene& scene, const Timeline& timeline, double t);
std::vector<int> pinsDown(const Scene& scene, const Timeline& timeline, double t);

// The pins of the rack that went down by the end of a run, of a summary as well; the scene's pins are named
// "1" to "10".
PinSet fallenPins(const Scene& scene, const Timeline& timeline);

} // namespace thetalane

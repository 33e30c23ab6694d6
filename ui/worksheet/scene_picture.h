// The moment of the collision as a drawing: the bodies in their sizes, the velocities they come with, the
// line of centres and θ, without its value.
#pragma once

#include "core/timeline/timeline.h"
#include "ui/steps/figure_canvas.h"

#include <span>

namespace thetalane {

// Pixels; `pass`: the collision itself, and those resolved together with it.
FigureCanvas scenePicture(const Scene& scene, const Collision& collision, std::span<const Collision> pass,
                          const Appearance& appearance, QSizeF size);

} // namespace thetalane

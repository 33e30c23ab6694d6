// How much of the plane a run needs: rectangles in units.
#pragma once

#include "core/engine/engine.h"

#include <QRectF>

namespace thetalane {

// What the view shows at first: the frame, the rack of a lane, or the bodies and where they will go until
// `until` [s], as far as they can still be made out.
QRectF fitRect(const Run& run, double until);

// All of a lane, from a little before the foul line to the back of the pit; else fitRect().
QRectF wholeRect(const Run& run, double until);

// Of a lane: its pins alone, and from a little before the foul line to the arrows that one aims over.
QRectF rackRect(const Run& run);
QRectF foulLineRect(const Run& run);

// The square about a collision's contact that its overlay needs.
QRectF pairRect(const Collision& collision);

} // namespace thetalane

// The ball's way to the pins in closed form, by the same motion as the engine's, and the throw that arrives
// as asked.
#pragma once

#include "core/scene/bowling_scene.h"

#include <optional>

namespace thetalane {

// How a ball comes to the pins. offset [m]: where the straight line on which it comes passes the head pin,
// positive to the right; angle [rad]: of that line from straight down the lane, positive to the left, as a
// right-hander's hook comes in (a left-hander's has both signs turned); speed [m/s].
struct Entry {
    double offset = 0;
    double angle = 0;
    double speed = 0;

    friend bool operator==(const Entry&, const Entry&) = default;
};

// The throw's entry, taken where the ball's centre is as far before the head pin as the two touch head on.
// Nothing where it gets there too late (it stops on the lane) or not at all (it falls into a gutter first).
std::optional<Entry> entryOf(const Throw& ballThrow, const std::optional<Friction>& friction);

// `base` with that direction and axis of the spin that make it arrive so, from the same place with the same
// speed and spin: what bowlers do. Without friction a ball goes straight: then its position takes the place
// of the axis. Nothing where no such throw was found: too little spin for the angle, or the lane too narrow.
std::optional<Throw> throwArriving(Throw base, double offset, double angle,
                                   const std::optional<Friction>& friction);

} // namespace thetalane

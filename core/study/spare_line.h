// A line that makes the spare: of the same ball, from somewhere on the foul line in some direction.
#pragma once

#include "core/bowling/game.h"

#include <optional>
#include <stop_token>

namespace thetalane {

struct SpareLine {
    Throw ballThrow;
    double spread = 0; // rad: so far in all may the direction be off, from the same place, and still make it

    friend bool operator==(const SpareLine&, const SpareLine&) = default;
};

// Of those tried the one that forgives most, with base's weight, speed and spin. Nothing where none of them
// makes it: that may still be possible in another way.
std::optional<SpareLine> spareLine(const Throw& base, const PinSet& standing, const LaneConditions& lane,
                                   const std::stop_token& stop = {});

} // namespace thetalane

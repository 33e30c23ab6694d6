// How many digits chaos has left: how far one can trust each collision of a run.
#pragma once

#include "core/engine/engine.h"

#include <vector>

namespace thetalane {

// For each collision of the run, how many decimal digits of its contact triangle (a, b) and its velocities
// after are right: -log10 of the estimated error, relative to Z and to the speeds of the two before; 0 to
// what the precision has (float 7.2, double 15.9, quad 34). First-order growth of rounding errors: tangent
// vectors go through the stretches of motion (core/study/tangent_flight.h) and the collisions of the run,
// with the shift of each instant, and take up the rounding of every collision on their way. Contacts of one
// instant are taken one after the other, and bodies that friction presses together move as if by themselves.
// Nothing for engines that step, whose errors are not those of rounding.
std::vector<double> digitsLeft(const Run& run);

// The same measure, between two runs of one scene: how many digits of run's collision k agree with those of
// truth's when the same two meet as often; 0 where they do not. Of the collisions until truth ends.
std::vector<double> digitsInCommon(const Run& truth, const Run& run);

} // namespace thetalane

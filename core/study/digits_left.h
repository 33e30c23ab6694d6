// How many digits chaos has left: how far one can trust each collision of a run.
#pragma once

#include "core/engine/engine.h"

#include <vector>

namespace thetalane {

// For each collision of the run, how many decimal digits of its contact triangle (a, b) and its velocities
// after are right: -log10 of the estimated error, relative to Z and to the speeds of the two before; 0 to
// what the precision has (float 7.2, double 15.9, quad 34). First-order growth of rounding errors: tangent
// vectors go through the flights and the collisions of the run, with the shift of each instant, and take up
// the rounding of every step on their way. Two contacts at one instant are taken one after the other. Nothing
// where it is not known: on a floor with friction, and for engines that step, whose errors are not those of
// rounding.
std::vector<double> digitsLeft(const Run& run);

// The same measure, between two runs of one scene: how many digits of run's collision k agree with truth's;
// 0 where another pair meets. As many as the shorter list.
std::vector<double> digitsInCommon(const Run& truth, const Run& run);

} // namespace thetalane

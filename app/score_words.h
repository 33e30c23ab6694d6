// What is wrong with rolls, in words.
#pragma once

#include "core/bowling/score_notation.h"

#include <QString>

namespace thetalane {

// "frame 3: only 4 pins stand, not 5; …": where, what, and what would be right.
QString rollMessage(const RollError& error, ScoringRules rules);

} // namespace thetalane

// --engine auto --tolerance M: the engine chosen by measurement, and why.
#pragma once

#include "core/engine/engine.h"

namespace thetalane {

class Arguments;

void takeTolerance(Arguments& arguments);

// Faults are noted with the arguments; what was chosen and why is told on standard error. Without --tolerance
// the settings stay as they are.
void checkTolerance(Arguments& arguments);
EngineSettings chosenSettings(Arguments& arguments, const EngineSettings& settings, const Scene& scene);

} // namespace thetalane

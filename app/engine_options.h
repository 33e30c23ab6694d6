// The options that choose an engine, its step, precision and bounds: the same for every command that runs.
#pragma once

#include "core/engine/engine.h"

#include <QString>

#include <variant>

namespace thetalane {

class Arguments;

void takeEngineOptions(Arguments& arguments);

// Faults are noted with the arguments.
EngineSettings engineSettings(Arguments& arguments);

// The run, or the line to tell: "--step: takes …".
std::variant<Run, QString> simulateOrTell(Scene scene, const EngineSettings& settings);

} // namespace thetalane

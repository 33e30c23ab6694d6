// The engines behind simulate(), compiled for the real types and models that scenes ask for.
#pragma once

#include "core/engine/engine.h"

namespace thetalane {

Timeline runNextEvent(const Scene& scene, const EngineSettings& settings);
Timeline runNextEventQuad(const Scene& scene, const EngineSettings& settings); // apart: Quad compiles slowly
Timeline runStepped(const Scene& scene, const EngineSettings& settings);

} // namespace thetalane

// The engines behind simulate(), compiled for the real types and models that scenes ask for.
#pragma once

#include "core/engine/engine.h"

namespace thetalane {

// How the next-event engine finds who meets whom, and what happens first.
enum class SearchKind { ByCount, AllPairs, Cells };

Timeline runNextEvent(const Scene& scene, const EngineSettings& settings,
                      SearchKind search = SearchKind::ByCount);
// Apart, as Quad compiles slowly; always by all pairs.
Timeline runNextEventQuad(const Scene& scene, const EngineSettings& settings);
Timeline runStepped(const Scene& scene, const EngineSettings& settings);
Timeline runSwept(const Scene& scene, const EngineSettings& settings);
Timeline runSweptQuad(const Scene& scene, const EngineSettings& settings); // apart for the same reason

} // namespace thetalane

// The words of run files: English, never translated.
#pragma once

#include "core/engine/engine.h"

#include <string>

namespace thetalane {

const char* fileName(EngineKind kind);
const char* fileName(Precision precision);
const char* fileName(EndReason reason);
const char* fileName(Place place);
const char* fileName(FloorPhase phase);

// A body's id, or "wall:left".
std::string secondName(const Scene& scene, const Collision& collision);
std::string secondName(const Scene& scene, const LastingContact& contact);

} // namespace thetalane

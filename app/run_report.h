// A run as a person reads it in a terminal.
#pragma once

#include "core/engine/engine.h"
#include "ui/words/language.h"

#include <QString>

namespace thetalane {

// The scene's title and the engine, in one line.
void printHeading(const Run& run, Language::Code language);

// One row a collision: number, time, who with whom, Z, θ, impulse, energy loss.
void printCollisions(const Run& run);

// Momentum and energy at the start and the end, the count, and why it ended.
void printTotals(const Run& run);

// "A – B", "A – left wall"
QString pairText(const Scene& scene, const Collision& collision);

} // namespace thetalane

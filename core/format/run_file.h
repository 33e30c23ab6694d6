// What a run writes: JSON for programs (version 1), CSV for spreadsheets. Numbers read back to the same
// double.
#pragma once

#include "core/engine/engine.h"

#include <QIODevice>
#include <QJsonObject>

#include <span>
#include <vector>

namespace thetalane {

// Of the scene as it was given: a summary's timeline has forgotten how the bodies began.
std::vector<BodyState> startStates(const Run& run);

// ½ β m R² ω² of the balls, all three axes [J]: what Totals::energy, of translation, leaves out.
double rotationalEnergy(const Scene& scene, std::span<const BodyState> states);

// Streams, so that a million collisions need no more memory than one. `extra` is added at the top level
// ("throw", "pins_down"). False when the device cannot be written.
bool writeRunJson(const Run& run, QIODevice& out, const QJsonObject& extra = {});

// A header and one row a collision; names of JSON joined by ".": before.first.x. New columns come last.
bool writeRunCsv(const Run& run, QIODevice& out);

} // namespace thetalane

// The strike map in words: what is wrong with an order or with a part's file.
#pragma once

#include "core/format/map_csv.h"

#include <QString>

namespace thetalane {

QString mapRefusalMessage(const MapRefusal& refusal, const MapSettings& settings);

// "part-2.csv: line 7: pins_down: must be 9, is \"8\""
QString mapFileMessage(const MapFileError& error);

} // namespace thetalane

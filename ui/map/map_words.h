// The strike map in words: its quantities, a cell, how far it is.
#pragma once

#include "core/study/strike_map.h"
#include "ui/map/map_worker.h"

#include <QString>

namespace thetalane {

QString quantityName(MapQuantity quantity);                // "Offset", short enough for a list
const char* quantityTerm(MapQuantity quantity);            // of the glossary
QString quantityValue(MapQuantity quantity, double value); // "6.8 cm", SI in

// "6.8 cm, 5.6°": where on the map a cell is.
QString placeText(const MapSettings& settings, int column, int row);
// "10 pins down: a strike", "8 pins down; 7-10 stand"
QString cellText(const MapCell& cell);

// Of a map that is being made, and of one that ended.
QString mapState(const MapNews& news);
QString refusalText(const MapRefusal& refusal);

// What discs do not do that pins do.
QString carryNote();

} // namespace thetalane

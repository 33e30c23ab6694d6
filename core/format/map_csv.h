// The strike map as a table, a row of text for each cell, and parts of one made elsewhere put together again.
//
// offset_m,angle_deg,pins_down,strike come first and are enough for other programs; strike is 1 or 0. The
// rest says which part of which map the cell belongs to, so that a file is complete on its own: standing
// (pins left, 7-10), row (from 1) of rows, and what was thrown.
#pragma once

#include "core/study/strike_map.h"

#include <QByteArray>

#include <span>
#include <string>
#include <variant>

namespace thetalane {

// A map of offset over angle. Of a cell that nothing arrives in, pins_down, strike and standing are empty.
QByteArray mapCsv(const StrikeMap& map);

enum class MapFileFault {
    NotAMap,       // line 1 is not the names of the columns; expected, text
    FieldCount,    // line; expected, text: how many
    NotANumber,    // line, column, text
    WrongValue,    // line, column, text, expected
    OtherSettings, // line, column, text; expected: what `other` has
    RowTwice,      // row; other: the file that has it, too (or this one)
    RowUnfinished, // row: cells are missing in it; text: how many it has, expected
    RowsMissing,   // row to lastRow of no file
    Empty,         // no rows at all
};

struct MapFileError {
    MapFileFault fault{};
    std::string file{};
    int line = 0;
    std::string column{};
    std::string text{};
    std::string expected{};
    std::string other{};
    int row = 0;
    int lastRow = 0;
};

struct MapFile {
    std::string name;
    QByteArray text;
};

// The whole map of its parts, in any order, or the first thing that does not fit. Where it fits, mapCsv() of
// it is what the map made at once would have given. Friction of the whole lane is the house's:
// houseFriction().
std::variant<StrikeMap, MapFileError> mergeMaps(std::span<const MapFile> parts);

} // namespace thetalane

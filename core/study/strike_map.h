// Pins down over two attributes of a throw, each cell a throw of its own by the engine. Made on several
// threads, coarse to fine; the cells are the same however many there are.
#pragma once

#include "core/bowling/ball_path.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace thetalane {

// Rack: the ball close before ten pins, no friction, nothing around (rackScene). Bowling: the whole lane,
// from the foul line (bowlingScene); of each cell the throw that arrives as its offset and angle say, as of
// Entry, from the place and with the speed and spin of `base`: throwArriving().
enum class MapScene { Rack, Bowling };

// SI. Offset and angle: how the ball comes to the pins, as of Entry; speed: of the rack at the pins, of the
// whole lane at the foul line; spin: not of the rack, which has no friction that it could act by.
enum class MapQuantity { Offset, Angle, Speed, Spin, Mass };
inline constexpr std::size_t mapQuantities = 5;

struct MapAxis {
    MapQuantity quantity = MapQuantity::Offset;
    double from = 0;
    double to = 0;
    int count = 1; // of values, the first at `from`, the last at `to`

    // The ends are exact, so that an axis can be told from its values.
    double at(int k) const {
        return k == 0 ? from : k == count - 1 ? to : from + (to - from) * k / (count - 1);
    }
    friend bool operator==(const MapAxis&, const MapAxis&) = default;
};

// The attributes that the axes do not vary.
struct MapBase {
    double offset = 0.0676; // of the pocket [m]
    double angle = 0.1047;  // 6° [rad]
    double speed = 0;       // [m/s]
    double spin = 0;        // [rad/s]
    double mass = 6.8;      // [kg]
    double position = 0;    // of the whole lane, at the foul line [m]

    friend bool operator==(const MapBase&, const MapBase&) = default;
};

struct MapSettings {
    MapScene scene = MapScene::Rack;
    MapAxis across; // columns
    MapAxis up;     // rows
    MapBase base;
    double restitution = defaultPinRestitution;
    std::optional<Friction> friction; // of the whole lane
    int firstRow = 0;                 // a part of the map: from this row on
    int rowCount = 0;                 // so many rows

    friend bool operator==(const MapSettings&, const MapSettings&) = default;
};

// Offset -16 to 16 cm over 0 to 8°. The whole lane: from the middle of the foul line with 400 rpm, which can
// arrive at all of these from the right.
MapSettings defaultMap(MapScene scene, int columns = 256, int rows = 256);

enum class MapFault { Count, TooManyCells, SameQuantity, SpinWithoutFriction, OutOfRange, Rows };
struct MapRefusal {
    MapFault fault{};
    MapQuantity quantity{}; // OutOfRange
    double value = 0;
    double low = 0, high = 0; // from, to
};
inline constexpr int mostMapCells = 1 << 24;
std::optional<MapRefusal> refusalOf(const MapSettings& settings);

struct MapCell {
    enum class State : std::uint8_t { Pending, NoThrow, Known }; // NoThrow: nothing arrives so
    std::uint16_t standing = 0;                                  // bit k: pin k + 1
    State state = State::Pending;

    bool known() const { return state == State::Known; }
    PinSet left() const { return PinSet(standing); }
    int pinsDown() const { return 10 - int(left().count()); }
    bool strike() const { return known() && standing == 0; }
    friend bool operator==(const MapCell&, const MapCell&) = default;
};

struct StrikeMap {
    MapSettings settings;
    std::vector<MapCell> cells; // row by row, those of the part alone
    int stride = 0;             // only every so many columns and rows are there yet; 1: all; 0: none

    int columns() const { return settings.across.count; }
    int rows() const { return settings.rowCount; }
    bool whole() const { return stride == 1; }

    // row: from 0, of the part. What is not there yet shows the next cell before it that is.
    const MapCell& at(int column, int row) const {
        const int s = stride > 1 ? stride : 1;
        return cells[std::size_t(row - row % s) * std::size_t(columns()) + std::size_t(column - column % s)];
    }
};

// Both are called by the thread that computes. progressed: of all cells, `done`.
struct MapWatch {
    std::function<void(const StrikeMap&)> refined{};
    std::function<void(std::size_t done, std::size_t all)> progressed{};
};

// Settings that refusalOf() finds nothing wrong with. threads: 0, as many as the machine has. Stopped, it
// returns what is there, with the stride that is whole.
StrikeMap computeStrikeMap(const MapSettings& settings, int threads = 0, const MapWatch& watch = {},
                           const std::stop_token& stop = {});

// A cell's scene, to look at; nothing where no throw arrives so. row: of the whole map.
std::optional<Scene> mapScene(const MapSettings& settings, int column, int row);
std::optional<Throw> mapThrow(const MapSettings& settings, int column, int row); // of the whole lane alone

} // namespace thetalane

// What changes if? The same throw with one attribute varied, each value a run of its own: the question the
// paper closes with.
#pragma once

#include "core/bowling/ball_path.h"
#include "core/bowling/game.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace thetalane {

// Attributes of a Throw, in its units.
enum class ThrowQuantity { Mass, Speed, Direction, Position, Spin, Axis };
inline constexpr int throwQuantities = 6;

double quantityOf(const Throw& ballThrow, ThrowQuantity quantity);
Throw withQuantity(Throw ballThrow, ThrowQuantity quantity, double value);

// Evenly from `from` to `to`, and `present` among them: in the place of one that is as good as equal, else in
// its order. count >= 2, from < to.
std::vector<double> variedValues(double from, double to, int count, double present);

struct VarySettings {
    Throw base;
    PinSet standing = allPins;
    LaneConditions lane;
    ThrowQuantity quantity = ThrowQuantity::Speed;
    std::vector<double> values;

    friend bool operator==(const VarySettings&, const VarySettings&) = default;
};

struct VariedThrow {
    double value = 0;
    Throw ballThrow;
    bool possible = false;       // false: no such ball may be thrown, and nothing was run
    PinSet left;                 // standing at the end
    int pinsDown = 0;            // of those that stood
    std::optional<int> firstPin; // that the ball touched, 1 to 10; nothing: it touched none
    std::optional<Entry> entry;  // nothing: it does not get to the pins

    bool clears() const { return possible && left.none(); }
    friend bool operator==(const VariedThrow&, const VariedThrow&) = default;
};

// One throw, by the exact engine.
VariedThrow outcomeOf(const Throw& ballThrow, const PinSet& standing, const LaneConditions& lane);

// In the order of the values, each told as soon as it is there. Stopped, those that are there.
std::vector<VariedThrow> varyThrow(const VarySettings& settings,
                                   const std::function<void(const VariedThrow&)>& found = {},
                                   const std::stop_token& stop = {});

} // namespace thetalane

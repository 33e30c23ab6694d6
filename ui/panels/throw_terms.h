// The terms in which a throw is spoken of: how far its dials go, in which units, on which board.
#pragma once

#include "core/scene/bowling_scene.h"
#include "ui/panels/value_row.h"

#include <QString>

namespace thetalane {

enum class MassUnit { Kilogram, Pound };
enum class SpeedUnit { MetresPerSecond, KilometresPerHour, MilesPerHour };

struct ThrowUnits {
    MassUnit mass = MassUnit::Kilogram;
    SpeedUnit speed = SpeedUnit::MetresPerSecond;

    friend bool operator==(const ThrowUnits&, const ThrowUnits&) = default;
};

// In the user's settings.
ThrowUnits rememberedThrowUnits();
void rememberThrowUnits(const ThrowUnits& units);

double inKilograms(MassUnit unit);         // one of it
double inMetresPerSecond(SpeedUnit unit);  // one of it
QString unitSymbol(MassUnit unit);         // "lb"
QString unitSymbol(SpeedUnit unit);        // "km/h"
ValueRow::Span massSpan(MassUnit unit);    // in that unit
ValueRow::Span speedSpan(SpeedUnit unit);  // in that unit
QString speedText(double v, SpeedUnit in); // v [m/s]: "28.8 km/h"

// What a hand on a dial or on the lane reaches; numbers that are typed go further.
inline constexpr ValueRow::Span directionSpan{-6, 6, 0.1, 0};       // °
inline constexpr ValueRow::Span positionSpan{-0.52, 0.52, 0.01, 0}; // m
inline constexpr ValueRow::Span rotationSpan{0, 600, 10, 0};        // rpm
inline constexpr ValueRow::Span axisSpan{-90, 90, 1, 0};            // °

inline constexpr double perRpm = 2 * std::numbers::pi / 60; // rad/s
inline constexpr double perDegree = std::numbers::pi / 180; // rad

// In the order of the default throw's own arithmetic: 1.5 gives its very bits.
inline double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

// Of 39, counted from the right, as bowlers do; position [m] from the middle, positive to the right.
int boardAt(double position);

} // namespace thetalane

// What can be asked about a run, and what the run answers: the truth behind a question is computed, never
// written down.
#pragma once

#include "core/engine/engine.h"

#include <optional>

namespace thetalane {

enum class QuantityKind {
    Speed,         // of a body after a collision, or at the end [m/s]
    Direction,     // of its motion, from the x axis, counterclockwise, in (-180, 180] [°]
    AngleBetween,  // of the velocities of two bodies, 0 to 180 [°]
    Theta,         // of a collision: of the line of centres to the x axis, in (-180, 180] [°]
    EnergyLost,    // in a collision; without one, from the start to the end [J]
    MomentumSize,  // of all bodies together [kg·m/s]
    Collisions,    // how many there are
    PinsDown,      // how many pins went down
    Velocity,      // a vector: of a body [m/s]
    TotalMomentum, // a vector: of all bodies together [kg·m/s]
};
inline constexpr int quantityKinds = 10;

struct Quantity {
    QuantityKind kind = QuantityKind::Speed;
    int body = 0;
    int other = 1;              // of AngleBetween
    std::int64_t collision = 0; // after which, from 1; 0: at the end of the run

    friend bool operator==(const Quantity&, const Quantity&) = default;
};

bool isVector(QuantityKind kind);
bool isCount(QuantityKind kind); // a whole number, right or wrong

// What a quantity needs to be said about.
bool needsBody(QuantityKind kind);
bool needsOther(QuantityKind kind);

// x alone unless it is a vector. Nothing where the run has no answer: there is no such collision, or a body
// at rest has no direction.
std::optional<Vec2d> measure(const Run& run, const Quantity& quantity);

} // namespace thetalane

// What somebody expects of a collision, set against what happens: a score by a declared rule, and what the
// expectation breaks.
#pragma once

#include "core/collision/pair_collision.h"

#include <optional>
#include <vector>

namespace thetalane {

// Of a wall, after.second and the momentum say nothing. What is left out was not predicted.
struct Prediction {
    VelocityPair<double> after;         // x, y [m/s]
    std::optional<Vec2d> momentum{};    // of both together, after [kg·m/s]
    std::optional<double> energyLost{}; // [J]
};

// The declared rule. Everything predicted counts alike: a body's velocity, the momentum, the energy lost.
// Each has a scale: the fastest speed before or after, the sum of m·v before, the kinetic energy before. Off
// by at most `exact` of it, it has all its points, by `worthless` or more none, evenly in between. The score
// is the mean, 0 to 100.
inline constexpr double exactShare = 0.05;
inline constexpr double worthlessShare = 0.5;

enum class Misconception {
    NothingChanged,      // both go on as if they had not met
    OnlyOneChanged,      // one goes on as before; body: which
    WentThrough,         // along x′ they still approach
    BodiesSwapped,       // each has what the other one gets
    ExchangedWhole,      // whole velocities exchanged, not their x′ components alone
    MassesIgnored,       // right for equal masses
    MomentumNotKept,     // value: what the prediction's momentum is too much by, of its scale
    EnergyGained,        // value: e of the prediction, above 1; or y′ brought energy in
    RestitutionDiffers,  // value: e of the prediction; wanted: the scene's
    TangentialChanged,   // the y′ part; body: which, value: from, wanted: what it was [m/s]
    WrongWay,            // a body goes the opposite way; body: which
    MomentumNumberWrong, // the number typed
    EnergyNumberWrong,   // value: typed, wanted: true [J]
    EnergyNumberNegative,
};

struct Diagnosis {
    Misconception what{};
    int body = 0; // 0: the first, 1: the second
    double value = 0;
    double wanted = 0;
};

struct Verdict {
    int score = 0;                // 0 to 100
    bool right = false;           // everything within `exactShare`
    std::vector<Diagnosis> wrong; // what explains most first
};

Verdict judge(const PairCollision<double>& truth, const Prediction& prediction);

// What follows from the velocities of a prediction.
Vec2d momentumOf(const PairCollision<double>& truth, const VelocityPair<double>& velocities); // [kg·m/s]
double energyOf(const PairCollision<double>& truth, const VelocityPair<double>& velocities);  // [J]
// −(va′ − vb′) after / before; nothing where they did not approach.
std::optional<double> restitutionOf(const PairCollision<double>& truth, const VelocityPair<double>& after);
// The fastest speed before or after [m/s].
double speedScale(const PairCollision<double>& truth);

} // namespace thetalane

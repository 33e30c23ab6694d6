// How the event engine stands extremes: a table of what was asked, what is exact, what came out, and how far
// it may be off. Exact values come from closed forms with 113 bits or from what must stay the same; none from
// the engine's own double precision.
#pragma once

#include <functional>
#include <vector>

namespace thetalane {

enum class ExtremeRow {
    MassRatio,
    RadiusRatio,
    Speed,
    Coordinates,
    Restitution,
    Coincident,
    Grazing,
    LongRun,
    CountingPi,
    TimeReversal,
    InelasticCollapse,
    LastingContact,
    ContactTime,
    Mirror,
};

// One scene of a row; what its value is.
enum class ExtremeCase {
    HeadOn,       // m_A/m_B
    Glancing,     // m_A/m_B
    RadiusRatio,  // r_A/r_B
    Speed,        // m/s
    Offset,       // the scene moved so far [m]
    Scaled,       // the scene so many metres large
    Elasticity,   // e
    SamePlace,    // validate() of two bodies at one place
    Apart,        // distance of the centres [m], in collide() alone
    TinyRadii,    // m
    GrazesInside, // metres inside of where they would just miss
    GrazesInsideSlanted,
    GrazesOutside, // metres outside of it
    GrazesOutsideSlanted,
    Gas,             // collisions
    OpenCrowd,       // collisions
    PiDigits,        // m_B/m_A
    ThereAndBack,    // collisions before all velocities are reversed
    ThreeInALine,    // e
    ChainAtAWall,    // bodies
    BallPushesPin,   // contact time [s]
    PinBetweenTwo,   // contact time [s]
    BallSpunAtAWall, // contact time [s]
    RackHeadOn,      // e
    CueOnTwo,        // e
};

// What was asked; exact, got, error and bound are of this kind.
enum class ExtremeMeasure {
    Speed,             // m/s; error: of the velocity, relative, of the body that is worse off
    ContactTime,       // s; error: relative
    ContactTimeInPath, // s; error: the way gone in it [m]
    NormalAngle,       // of the line of centres [rad]
    EnergyAfter,       // J; error: relative
    EnergyLoss,        // J; error: relative
    Refused,           // 1: yes
    NormalCosine,
    Meets,            // 1: yes
    Collisions,       // a count; error: how many off
    CollisionsAtMost, // exact: the most there may be; error: how many more
    StretchesAtMost,  // the same, of all bodies' stretches of motion
    EnergyDrift,      // relative
    MomentumDrift,    // |ΔP|/Σ|p|
    WayFromStart,     // the largest of any body [m]
    CommonVelocity,   // m/s; error: the largest difference from it
    EnergyRise,       // the largest between two looks, relative to the energy at the start
    Overlap,          // the deepest [m]
    EndPosition,      // furthest from that with a tenth of the shortest contact time [m]
    Asymmetry,        // largest difference of a body and its mirror image's [m, m/s]
};

struct ExtremeResult {
    ExtremeRow row{};
    ExtremeCase kase{};
    double value = 0;
    ExtremeMeasure asked{};
    double exact = 0;
    double got = 0;
    double error = 0;
    double bound = 0;

    bool within() const { return error <= bound; } // an error that is no number is not
};

// Row by row; quick: long runs end at 10⁵ collisions instead of 10⁷. begins(): before each row.
std::vector<ExtremeResult> studyExtremes(bool quick, const std::function<void(ExtremeRow)>& begins = {});

} // namespace thetalane

// From a scene to its timeline. Engines differ in how they find contacts; all exchange with collide().
#pragma once

#include "core/timeline/timeline.h"

#include <cstdint>
#include <variant>

namespace thetalane {

enum class EngineKind {
    Event,   // from contact to contact, each at its own instant: exact between them
    Stepped, // the paper's loop: move all by v·h, then exchange whatever overlaps
    Swept, // fixed steps, within each the instant of impact: as often as `passes` says, then blind to its end
};

enum class Precision { Float, Double, Quad };

struct EngineSettings {
    EngineKind kind = EngineKind::Event;
    Precision precision = Precision::Double;
    double step = 1.0 / 60;       // h of the stepped and the swept engine [s]
    bool approachingOnly = false; // the stepped engine's variant: exchange only when approaching
    // How often within one step the swept engine looks where a body will be hit: at the step's start, and
    // after each of the next passes - 1 times it was. Then the body goes on unseen until the step ends.
    int passes = 1;
    double until = 10; // [s]
    std::int64_t maxCollisions = 1'000'000;
    // On a floor with friction, bodies pressed together that would meet again sooner than this stay together:
    // a contact that lasts [s].
    double contactTime = 1e-4;
    // Of the event engine: contacts of one instant are resolved together. False: one at a time, in the order
    // of the scene, as most programs do.
    bool ties = true;
    bool keepDetail = true; // false: the end and the counts only

    friend bool operator==(const EngineSettings&, const EngineSettings&) = default;
};

// A run of more steps than this is taken for a slip of the pen.
inline constexpr double maxSteps = 1e8;

enum class RefusalReason {
    UntilNotPositive,
    StepNotPositive,
    TooManySteps,
    MaxCollisionsNotPositive,
    PassesNotPositive,
    ContactTimeNotPositive,
};

struct Refusal {
    RefusalReason reason{};
    double value = 0;
    double limit = 0;
};

struct Run {
    Scene scene;
    EngineSettings settings;
    Timeline timeline;
};

// Runs a scene that validate() finds nothing wrong with. A setting that cannot be met is refused, not bent.
std::variant<Run, Refusal> simulate(Scene scene, const EngineSettings& settings);

} // namespace thetalane

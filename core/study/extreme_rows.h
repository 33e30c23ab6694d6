// The rows of the table, and what they share.
#pragma once

#include "core/engine/engine.h"
#include "core/math/quad.h"
#include "core/study/extremes.h"

#include <string>

namespace thetalane::extremes {

using Results = std::vector<ExtremeResult>;

// One row each, appended to `out`.
void massRatios(Results& out);
void radiusRatios(Results& out);
void speeds(Results& out);
void coordinates(Results& out);
void restitutions(Results& out);
void coincident(Results& out);
void grazing(Results& out);
void longRuns(Results& out, bool quick);
void countingPi(Results& out);
void timeReversal(Results& out);
void collapse(Results& out);
void lasting(Results& out);
void contactTimes(Results& out);
void mirror(Results& out);

inline constexpr double epsilon = 0x1p-52;

Body ball(int number, double mass, double radius, Vec2d position, Vec2d velocity);
Scene sceneOf(double restitution, std::vector<Body> bodies);
std::vector<BodyState> startOf(const Scene& scene);
Timeline runOf(const Scene& scene, const EngineSettings& settings);
Timeline runOf(const Scene& scene, double until);

// Kinetic energy, of translation and of balls on a floor with friction also of rotation [J].
double energyOf(const Scene& scene, std::span<const BodyState> states);

// How two bodies meet, worked out from the path of closest approach and the impulse along the line of
// centres, with 113 bits; no code of an engine or of the five steps.
struct Meeting {
    bool meets = false;
    Quad time;
    Vec2<Quad> normal; // from the second to the first
    Vec2<Quad> first, second;
    Quad energyBefore, energyAfter;
};
Meeting meetingOf(const Body& first, const Body& second, const Quad& restitution);

double relativeError(double got, const Quad& exact);

} // namespace thetalane::extremes

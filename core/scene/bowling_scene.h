// The regulation lane and rack, and a throw at it. The head pin stands at (0, 0), y points to the pit.
#pragma once

#include "core/scene/scene.h"

#include <array>
#include <bitset>
#include <numbers>
#include <optional>
#include <vector>

namespace thetalane {

// USBC / World Bowling equipment specifications. Metres, kilograms.
namespace regulation {
inline constexpr double laneWidth = 1.0541; // 39 boards
inline constexpr double foulLineToHeadPin = 18.288;
inline constexpr double headPinToEnd = 0.868;
inline constexpr double gutterWidth = 0.235;
inline constexpr double pitDepth = 0.762;
inline constexpr double pinSpacing = 0.3048;
inline constexpr double pinRowSpacing = 0.26396; // pinSpacing · √3/2
inline constexpr double pinRadius = 0.06053;     // widest, at 11.4 cm height
inline constexpr double pinMass = 1.59;          // 1.531 to 1.645
inline constexpr double pinCentreOfGravity = 0.147;
inline constexpr double pinBaseRadius = 0.026;
inline constexpr double ballRadius = 0.10845;    // 215.9 to 218.3 mm across
inline constexpr double maxBallMass = 7.26;      // 16 lb
inline constexpr double houseOilLength = 12.192; // from the foul line; 40 ft, where house oil commonly ends
} // namespace regulation

// Nobody could be found to have measured it; games use 0.08 to 0.85. A visible control.
inline constexpr double defaultPinRestitution = 0.75;

// The paper's attributes of the ball (fig. 12). Angles in radians.
struct Throw {
    double mass = 6.8;                               // kg
    double speed = 8.0;                              // m/s
    double direction = 1.5 * std::numbers::pi / 180; // from straight down the lane, positive to the right
    double position =
        -0.41;       // of the ball's centre at the foul line, from the middle, positive to the right [m]
    double spin = 0; // rad/s
    double axis = 0; // of the spin, from a forward roll, positive hooks to the left; the spin axis is level

    friend bool operator==(const Throw&, const Throw&) = default;
};

// Centres of pins 1 to 10 (index 0 to 9) [m].
std::array<Vec2d, 10> pinPositions();

// Some of the ten pins: bit k is pin k + 1.
using PinSet = std::bitset<10>;
inline const PinSet allPins = PinSet().set();

// The pins that stand, named "1" to "10".
std::vector<Body> rackOf(const PinSet& standing);
std::vector<Body> fullRack();

Lane regulationLane();

// A house lane: oil to 40 ft, dry behind it. How sure each figure is stands beside it in the .cpp.
Friction houseFriction();

// The spin of a ball thrown so, in the axes of the lane [rad/s].
Spin<double> throwSpin(const Throw& ballThrow);

// The balls of the two scenes below.
Body thrownBall(const Throw& ballThrow);
Body rackBall(double offset, double entryAngle, double speed, double mass = Throw{}.mass);

// One ball at the foul line, the whole lane, the pins that stand; no friction where none is given. The ball
// is the first body. Validity is validate()'s business.
Scene bowlingScene(const Throw& ballThrow, double restitution = defaultPinRestitution,
                   const std::optional<Friction>& friction = houseFriction(),
                   const PinSet& standing = allPins);

// The ball close before the rack, free of the lane: the scene of the frictionless studies.
// offset [m]: of the ball's path from the head pin; entryAngle [rad]: positive to the right.
Scene rackScene(double offset, double entryAngle, double speed, double restitution = defaultPinRestitution);

} // namespace thetalane

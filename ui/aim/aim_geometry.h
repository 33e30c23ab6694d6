// Where on the lane the parts of a throw stand, and what throw it is once a hand has moved one. Metres in the
// scene's axes, y towards the pins.
#pragma once

#include "core/scene/bowling_scene.h"

namespace thetalane {

enum class AimPart {
    Ball,      // along the foul line: position
    Direction, // the tip of the arrow, at the lane's own arrows: direction
    Speed,     // a bead on the arrow: speed
    Rotation,  // a bead round the ball: its bearing is the axis', its distance the rotation's
};
inline constexpr int aimPartCount = 4;

// Why a part went no further.
enum class AimLimit { None, EdgeOfLane, Steepest, Slowest, Fastest, MostRotation, SideSpin };

// How far beyond the foul line the direction is aimed, at the fourth of the lane's seven arrows [m].
inline constexpr double aimDistance = 4.83;
inline constexpr double metresPerAimedSpeed = 0.25;    // of the bead on the arrow [m/(m/s)]
inline constexpr double rotationRing = 0.17;           // the bead's distance at no rotation [m]
inline constexpr double metresPerRotation = 0.3 / 600; // and how much more for each rpm [m/rpm]

Vec2d placeOf(AimPart part, const Throw& ballThrow);
// Towards where the ball's turning pulls it: its direction, turned by the axis.
Vec2d pullOf(const Throw& ballThrow);

struct Aimed {
    Throw ballThrow;
    AimLimit limit = AimLimit::None;
};

// The part moved by so much from where it stands in `from`. What does not move it leaves its very bits.
Aimed movedBy(const Throw& from, AimPart part, const Vec2d& way);

// By the arrow keys: steps to the right and up; fine: tenths of them.
Aimed steppedBy(const Throw& from, AimPart part, int right, int up, bool fine);

} // namespace thetalane

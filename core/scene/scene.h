// A scene is a value: bodies, restitution, and only what it needs beside them.
#pragma once

#include "core/motion/floor_state.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace thetalane {

inline constexpr double standardGravity = 9.80665; // m/s²

enum class BodyKind { Ball, Pin };

// mass [kg] > 0, radius [m] > 0, position [m], velocity [m/s]; id is unique in the scene.
// Spin and inertia mean something on a floor with friction alone: a ball slides until it rolls, a pin slides.
struct Body {
    std::string id;
    BodyKind kind = BodyKind::Ball;
    double mass = 1;
    double radius = 0.1;
    Vec2d position;
    Vec2d velocity;
    Spin<double> spin{};  // of a ball [rad/s]
    double inertia = 0.4; // of a ball: β = I/(m R²), 0 < β <= 1; 2/5 for a uniform sphere

    friend bool operator==(const Body&, const Body&) = default;
};

enum class Side { Left, Right, Bottom, Top };
inline constexpr std::array sides{Side::Left, Side::Right, Side::Bottom, Side::Top};

// Straight walls; a side left out is open. Positions in metres.
struct Frame {
    std::optional<double> left;
    std::optional<double> right;
    std::optional<double> bottom;
    std::optional<double> top;
    double restitution = 1;

    const std::optional<double>& side(Side s) const {
        return s == Side::Left ? left : s == Side::Right ? right : s == Side::Bottom ? bottom : top;
    }
    friend bool operator==(const Frame&, const Frame&) = default;
};

// Where the lane is oiled: from y = from to y = to.
struct OilZone {
    double from = 0;     // y [m]
    double to = 0;       // y [m]
    double friction = 0; // μ between a sliding ball and the oil

    friend bool operator==(const OilZone&, const OilZone&) = default;
};

// Coulomb friction of the floor. A scene without it has none, and pays for none.
struct Friction {
    double ball = 0;                  // μ between a sliding ball and the floor, where there is no oil
    double rolling = 0;               // μr of a rolling ball
    double pin = 0;                   // μ between a pin and the floor
    double gravity = standardGravity; // [m/s²]
    std::vector<OilZone> oil;         // ascending in y, none over another

    friend bool operator==(const Friction&, const Friction&) = default;
};

// The plates on both sides of the pin deck, over the outer edges of the gutters. Where they stand, a pin
// flies over the gutter, is thrown back with their own e, and stays in play.
struct Kickbacks {
    double from = 0;        // y where they begin [m]; they end with the lane
    double restitution = 0; // 0 to 1

    friend bool operator==(const Kickbacks&, const Kickbacks&) = default;
};

// A bowling lane: between x = left and x = right, from the foul line at y = foulLine to the end of the deck
// at y = end; a gutter on each side and a pit behind. Metres. A body whose centre leaves the lane is lost to
// play.
struct Lane {
    double left = 0;
    double right = 0;
    double foulLine = 0;
    double end = 0;
    double gutterWidth = 0;
    double pitDepth = 0;
    std::optional<Kickbacks> kickbacks{};

    friend bool operator==(const Lane&, const Lane&) = default;
};

// A title in the languages it was written in; empty where it was not.
struct Title {
    std::string en;
    std::string ko;

    friend bool operator==(const Title&, const Title&) = default;
};

struct Scene {
    Title title;
    double restitution = 1; // between bodies, 0 to 1
    std::vector<Body> bodies;
    std::optional<Frame> frame;
    std::optional<Lane> lane;
    std::optional<Friction> friction;

    friend bool operator==(const Scene&, const Scene&) = default;
};

} // namespace thetalane

// A scene is a value: bodies, restitution, and only what it needs beside them.
#pragma once

#include "core/math/vec2.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace thetalane {

enum class BodyKind { Ball, Pin };

// mass [kg] > 0, radius [m] > 0, position [m], velocity [m/s]; id is unique in the scene.
struct Body {
    std::string id;
    BodyKind kind = BodyKind::Ball;
    double mass = 1;
    double radius = 0.1;
    Vec2d position;
    Vec2d velocity;

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

    friend bool operator==(const Scene&, const Scene&) = default;
};

} // namespace thetalane

// The rooms beside the lane: what a panel there is about, and how its entry looks.
#pragma once

#include <QPainterPath>

namespace thetalane {

// In the order in which they stand.
enum class Room {
    Lessons,
    Steps,
    Collisions,
    Attributes, // the bodies', or the throw's
    Predict,
    Tables,
    Game,
    Chain, // who hit whom
    Map,
    Practice,
    Statistics,
    Accuracy,
    Words, // what they mean, and the keys
};
inline constexpr int roomCount = 13;

// To be filled, on a grid of 24 by 24.
QPainterPath roomIcon(Room room);

} // namespace thetalane

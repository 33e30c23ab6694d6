// The rooms beside the lane: what a panel there is about, and how its entry looks.
#pragma once

#include <array>
#include <string_view>

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
    Glossary, // what the words mean, and the keys
};
inline constexpr int roomCount = 13;
// What they are called on the command line, and in lessons.
inline constexpr std::array<std::string_view, roomCount> roomIds{
    "lessons", "steps", "collisions", "attributes", "predict",  "tables", "game",
    "chain",   "map",   "practice",   "statistics", "accuracy", "words"};

} // namespace thetalane

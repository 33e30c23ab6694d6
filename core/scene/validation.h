// What is wrong with a scene, as values: where, what, and what would be right. The words are the ui's and the
// app's.
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace thetalane {

enum class SceneErrorCode {
    NotFinite,      // path
    NotPositive,    // path, value
    OutOfRange,     // path, value, low, high
    NoBodies,       // path
    TooManyBodies,  // path, value = how many, high = how many are allowed
    OutOfOpenRange, // path, value, low, high: greater than low, at most high
    EmptyId,        // path
    DuplicateId,    // path, other = the id
    ReservedId,     // path, other = the id: it begins as the names of walls do
    Overlap,        // path, first and other = the two ids, value = depth [m]
    OverlapsWall,   // path, first = the id, other = side, value = depth [m]; also a body outside its frame
    OffTheLane,     // path, first = the id
    WallsCrossed,   // path, value = this side, low = the side it must be beyond
    OilReversed,    // path, value = where the zone ends, low = where it begins
    OilOverlap,     // path, value = where the zone begins, low = where the earlier one ends, other = its path
    KickbacksOffTheLane, // path, value, low = the foul line, high = the end of the lane
    // found while reading a file
    Unreadable,   // other = the system's reason
    NotJson,      // path = "line L, column C", other = the reader's reason
    NotAnObject,  // path
    MissingKey,   // path
    UnknownKey,   // path, other = the nearest known key, if one is near
    WrongType,    // path, expected
    WrongFormat,  // path, other = what it says
    WrongVersion, // path, value
};

enum class ExpectedType { Number, String, Object, Array, Pair, Triple, BodyKind };

// path names the field as in the file: bodies[1].mass
struct SceneError {
    SceneErrorCode code{};
    std::string path;
    double value = 0;
    double low = 0;
    double high = 0;
    std::string first{};
    std::string other{};
    ExpectedType expected = ExpectedType::Number;
};

inline constexpr std::size_t maxBodies = 100'000;
inline constexpr double maxFriction = 10; // no floor is known to come near; rubber on rubber has 1 to 2

// Runs name a wall "wall:left" where a body's id stands otherwise.
inline constexpr std::string_view wallPrefix = "wall:";

// Every fault found, in the order of the file; empty when the scene can be run. At most one overlap a body.
std::vector<SceneError> validate(const Scene& scene);

} // namespace thetalane

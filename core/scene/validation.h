// What is wrong with a scene, as values: where, what, and what would be right. The words are the ui's and the
// app's.
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace thetalane {

enum class SceneErrorCode {
    NotFinite,     // path
    NotPositive,   // path, value
    OutOfRange,    // path, value, low, high
    NoBodies,      // path
    TooManyBodies, // path, value = how many, high = how many are allowed
    EmptyId,       // path
    DuplicateId,   // path, other = the id
    Overlap,       // path, first and other = the two ids, value = depth [m]
    OverlapsWall,  // path, first = the id, other = side, value = depth [m]; also a body outside its frame
    OffTheLane,    // path, first = the id
    WallsCrossed,  // path, value = this side, low = the side it must be beyond
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

enum class ExpectedType { Number, String, Object, Array, Pair, BodyKind };

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

// Every fault found, in the order of the file; empty when the scene can be run. At most one overlap a body.
std::vector<SceneError> validate(const Scene& scene);

} // namespace thetalane

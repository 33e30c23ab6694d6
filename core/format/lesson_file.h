// Lesson files, version 1: a scene, a few stops with a sentence each, and a question. See README, "Lesson
// files".
//
//   { "format": "thetalane-lesson", "version": 1,
//     "title": {"en": "…", "ko": "…"}, "summary": {…},    every text: one language at least
//     "scene":   "rack" | {"restitution": …, "bodies": […], …},   a built-in scene, or one as in a scene file
//     "restitution": e,                      instead of the scene's; optional, as is the engine:
//     "engine":  {"kind": "event" | "stepped" | "swept", "step": s, "approaching_only": false, "until": s},
//     "stops": [
//       {"at": "start" | 0.5, "text": {…}},           seconds
//       {"collision": 1, "stage": 3, "text": {…},     from 1; the stage from 0 (contact) to 5 (check)
//        "show": "steps",                             what else to bring to the front, see showNames
//        "scene": …, "restitution": …, "engine": {…}}],                              from here on
//     "question": {"before": 2,          the stop that gives the answer, from 1; else after the last one
//       "text": {…}, "answer": {…},      why it is so; optional, shown with the truth
//       "kind": "choice", "options": [{…}, {…}], "right": 1       from 1
//       "kind": "number" | "vector", "quantity": see quantityNames, "body": "A", "other": "B",
//                "after": 1,             the collision, from 1; left out: at the end of the run
//                "tolerance": 0.02 } }   of the truth; a count must be met
//
// The truth of a number or a vector is never written: the engine computes it.
#pragma once

#include "core/scene/validation.h"
#include "core/study/quantity.h"

#include <QByteArray>

#include <array>
#include <string_view>
#include <variant>

namespace thetalane {

enum class LessonShow { Nothing, Steps, Collisions, Bodies, Tables, Plots, Lab };
inline constexpr std::array<std::string_view, 7> showNames{"nothing", "steps", "collisions", "bodies",
                                                           "tables",  "plots", "lab"};
inline constexpr std::array<std::string_view, quantityKinds> quantityNames{
    "speed",         "direction",  "angle-between", "theta",    "energy-lost",
    "momentum-size", "collisions", "pins-down",     "velocity", "total-momentum"};

struct LessonSetting {
    Scene scene;
    std::string sceneId; // of a built-in scene as it is; else empty
    EngineSettings engine;
};

enum class StopAt { Start, Time, Collision };
struct LessonStop {
    StopAt at = StopAt::Start;
    double time = 0;            // [s]
    std::int64_t collision = 0; // from 1
    int stage = 0;              // 0 to 5
    LessonShow show = LessonShow::Nothing;
    Title text;
    std::size_t setting = 0; // index into Lesson::settings
};

enum class QuestionKind { Choice, Number, Vector };
struct LessonQuestion {
    QuestionKind kind = QuestionKind::Choice;
    Title text, answer;
    std::vector<Title> options;
    std::size_t right = 0; // index into options
    Quantity quantity;
    double tolerance = 0.02; // of the truth
    std::size_t before = 0;  // index of the stop it stands before; stops.size(): after the last one
    std::size_t setting = 0;
};

struct Lesson {
    Title title, summary;
    std::vector<LessonSetting> settings; // at least one
    std::vector<LessonStop> stops;       // at least one
    std::optional<LessonQuestion> question;
};

enum class LessonFault {
    Shape,       // scene: what the JSON or the scene in it has wrong, in the words of scene files
    WrongFormat, // text
    WrongVersion,
    UnknownWord, // text: what it says, allowed; other: the nearest one, if one is near
    UnknownBody, // text, allowed: the scene's ids
    NotWhole,    // value
    OutOfRange,  // value, low, high
    NoWords,     // neither language
    NoStops,
    NoPlace,         // a stop without "at" and "collision", or with both
    TooFewOptions,   // value
    NoSuchCollision, // value; high: how many there are
    BeyondTheEnd,    // value; high: the end of the run [s]
    Refused,         // refusal: the engine's
    NothingToMeasure // the run has no answer: no such collision, or a body at rest has no direction
};

struct LessonError {
    LessonFault fault{};
    std::string path; // as in the file: stops[2].collision; of a Shape that is no JSON, line and column
    double value = 0, low = 0, high = 0;
    std::string text{}, other{};
    std::vector<std::string> allowed{};
    SceneError scene{};
    Refusal refusal{};
};

// A lesson that can be given, or everything that is wrong with it, in the order of the file. What its stops
// and its question need of the runs is looked up in them.
std::variant<Lesson, std::vector<LessonError>> readLesson(const QByteArray& json);

// The part of that which needs the runs.
std::vector<LessonError> checkLesson(const Lesson& lesson);

// What the engine says of the question's quantity; nothing for a choice.
std::optional<Vec2d> truthOf(const Lesson& lesson);

// Within the tolerance of the truth (of a truth near 0, within 0.001 of it); a count must be met.
bool isRight(const LessonQuestion& question, const Vec2d& truth, const Vec2d& answer);

} // namespace thetalane

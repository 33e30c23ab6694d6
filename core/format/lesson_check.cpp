#include "core/format/lesson_file.h"

#include <algorithm>

namespace thetalane {
namespace {

constexpr std::int64_t mostCollisions = 100'000; // a lesson of more is none

std::variant<Run, Refusal> runOf(const LessonSetting& setting) {
    EngineSettings engine = setting.engine;
    engine.maxCollisions = mostCollisions;
    return simulate(setting.scene, engine);
}

void checkStop(const LessonStop& stop, const std::string& path, const Timeline& timeline,
               std::vector<LessonError>& errors) {
    const auto count = std::int64_t(timeline.collisions().size());
    if (stop.at == StopAt::Collision && stop.collision > count)
        errors.push_back({.fault = LessonFault::NoSuchCollision,
                          .path = path + ".collision",
                          .value = double(stop.collision),
                          .high = double(count)});
    if (stop.at == StopAt::Time && stop.time > timeline.endTime())
        errors.push_back({.fault = LessonFault::BeyondTheEnd,
                          .path = path + ".at",
                          .value = stop.time,
                          .high = timeline.endTime()});
}

void checkQuestion(const LessonQuestion& question, const Run& run, std::vector<LessonError>& errors) {
    if (question.kind == QuestionKind::Choice)
        return;
    const auto count = std::int64_t(run.timeline.collisions().size());
    if (question.quantity.collision > count)
        errors.push_back({.fault = LessonFault::NoSuchCollision,
                          .path = "question.after",
                          .value = double(question.quantity.collision),
                          .high = double(count)});
    else if (!measure(run, question.quantity))
        errors.push_back({.fault = LessonFault::NothingToMeasure, .path = "question.quantity"});
}

} // namespace

std::vector<LessonError> checkLesson(const Lesson& lesson) {
    std::vector<LessonError> errors;
    for (std::size_t s = 0; s < lesson.settings.size(); ++s) {
        const auto first = std::find_if(lesson.stops.begin(), lesson.stops.end(),
                                        [s](const LessonStop& stop) { return stop.setting == s; });
        const auto outcome = runOf(lesson.settings[s]);
        if (const auto* refusal = std::get_if<Refusal>(&outcome)) {
            const auto index = std::size_t(first - lesson.stops.begin());
            const std::string place = s == 0 ? "" : "stops[" + std::to_string(index) + "].";
            errors.push_back({.fault = LessonFault::Refused, .path = place + "engine", .refusal = *refusal});
            continue;
        }
        const Run& run = std::get<Run>(outcome);
        for (std::size_t k = 0; k < lesson.stops.size(); ++k)
            if (lesson.stops[k].setting == s)
                checkStop(lesson.stops[k], "stops[" + std::to_string(k) + ']', run.timeline, errors);
        if (lesson.question && lesson.question->setting == s)
            checkQuestion(*lesson.question, run, errors);
    }
    return errors;
}

std::optional<Vec2d> truthOf(const Lesson& lesson) {
    if (!lesson.question || lesson.question->kind == QuestionKind::Choice)
        return std::nullopt;
    const auto outcome = runOf(lesson.settings[lesson.question->setting]);
    const auto* run = std::get_if<Run>(&outcome);
    return run ? measure(*run, lesson.question->quantity) : std::nullopt;
}

bool isRight(const LessonQuestion& question, const Vec2d& truth, const Vec2d& answer) {
    constexpr double nearZero = 1e-3;
    if (isCount(question.quantity.kind))
        return answer.x == truth.x;
    const Vec2d off = answer - truth;
    return norm(isVector(question.quantity.kind) ? off : Vec2d{off.x, 0}) <=
           std::max(question.tolerance * norm(truth), nearZero) * (1 + 1e-12);
}

} // namespace thetalane

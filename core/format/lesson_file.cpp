#include "core/format/lesson_file.h"

#include "core/format/json_keys.h"
#include "core/format/lesson_reader.h"
#include "core/format/scene_file.h"

#include <QJsonDocument>

#include <algorithm>

namespace thetalane {
namespace {

using Errors = std::vector<LessonError>;

constexpr const char* formatName = "thetalane-lesson";

// What is no JSON, or not strictly, the reader of scenes knows how to tell.
std::optional<LessonError> notJson(const QByteArray& json) {
    const QJsonDocument document = QJsonDocument::fromJson(json);
    const auto asScene = readScene(json);
    const auto* errors = std::get_if<std::vector<SceneError>>(&asScene);
    if (!errors)
        return std::nullopt;
    const SceneError& first = errors->front();
    const bool placed = first.code == SceneErrorCode::NotJson && first.other != duplicateKeyReason;
    if (document.isObject() && !placed)
        return std::nullopt;
    return LessonError{.fault = LessonFault::Shape, .path = first.path, .scene = first};
}

// A file of another kind, or of a later version: whatever else it holds, these rules do not apply to it.
std::optional<LessonError> notForUs(const QJsonObject& file) {
    const QJsonValue format = file.value("format"), version = file.value("version");
    if (format.isString() && format.toString() != formatName)
        return LessonError{
            .fault = LessonFault::WrongFormat, .path = "format", .text = format.toString().toStdString()};
    if (version.isDouble() && version.toDouble() != 1)
        return LessonError{
            .fault = LessonFault::WrongVersion, .path = "version", .value = version.toDouble()};
    return std::nullopt;
}

} // namespace

std::variant<Lesson, Errors> readLesson(const QByteArray& json) {
    if (auto error = notJson(json))
        return Errors{std::move(*error)};
    const QJsonObject file = QJsonDocument::fromJson(json).object();
    if (auto error = notForUs(file))
        return Errors{std::move(*error)};
    Errors errors;
    for (std::string& path : duplicateKeys(json))
        errors.push_back(
            {.fault = LessonFault::Shape,
             .path = path,
             .scene = {.code = SceneErrorCode::NotJson, .path = path, .other = duplicateKeyReason}});
    Lesson lesson = readLessonMembers(file, errors);
    if (errors.empty())
        errors = checkLesson(lesson);
    if (errors.empty())
        return lesson;
    sortByPlace(errors, json);
    return errors;
}

} // namespace thetalane

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

std::string parentOf(const std::string& path) {
    const auto cut = path.find_last_of(".[");
    return cut == std::string::npos ? std::string() : path.substr(0, cut);
}

// A fault stands where its key stands; one of a key that is missing, where the object begins that lacks it.
void sortByPlace(Errors& errors, const QByteArray& json) {
    std::unordered_set<std::string> wanted;
    for (const LessonError& e : errors)
        for (std::string p = e.path; !p.empty() && wanted.insert(p).second;)
            p = parentOf(p);
    const auto offsets = keyOffsets(json, wanted);
    const auto offsetOf = [&](std::string path) {
        for (; !path.empty(); path = parentOf(path))
            if (const auto it = offsets.find(path); it != offsets.end())
                return it->second;
        return qsizetype(0);
    };
    std::stable_sort(errors.begin(), errors.end(), [&](const LessonError& a, const LessonError& b) {
        return offsetOf(a.path) < offsetOf(b.path);
    });
}

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

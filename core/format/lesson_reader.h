// The members of a lesson file, each taken out as what it must be.
#pragma once

#include "core/format/lesson_file.h"

#include <QJsonObject>

namespace thetalane {

// What is wrong is added to `errors`; then the lesson is not to be used.
Lesson readLessonMembers(const QJsonObject& file, std::vector<LessonError>& errors);

} // namespace thetalane

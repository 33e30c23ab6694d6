// The lessons that come with the program.
#pragma once

#include "core/format/lesson_file.h"

namespace thetalane {

// In the order in which a class meets them; read once, when first asked for.
const std::vector<Lesson>& builtInLessons();

} // namespace thetalane

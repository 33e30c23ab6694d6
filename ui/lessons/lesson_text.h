// What is said about lessons: their texts in the language of now, quantities and truths, and what is wrong
// with a file.
#pragma once

#include "core/format/lesson_file.h"

#include <QString>

namespace thetalane {

// In the language of now, or the other one where it has none.
QString inLanguageOfNow(const Title& text);

QString quantityUnit(QuantityKind kind);                            // "m/s"; empty for a count
QString quantityName(const Scene& scene, const Quantity& quantity); // "speed of B"
QString valueText(QuantityKind kind, const Vec2d& value);           // "0.5 m/s", "(0.5, −1) m/s", "314"

// With the place: "stops[2].collision: there are only 3 collisions, not 7".
QString lessonErrorText(const LessonError& error);

// Korean is read word by word: a line does not break inside one.
QString keptWords(QString text);

} // namespace thetalane

// A worksheet of one collision, to print: a page with what is given and blanks to fill in, and a page with
// the answers, worked through with the engine's own numbers. A4, upright; PDF with text that can be searched.
#pragma once

#include "core/timeline/timeline.h"
#include "ui/words/language.h"

#include <QByteArray>

#include <span>

namespace thetalane {

// What is asked about. The words are in the language that is installed; `language` chooses the scene's title.
struct WorksheetSubject {
    const Scene& scene;
    std::span<const Collision> collisions;
    std::size_t index = 0;   // of the collision among them
    std::int64_t number = 1; // of it in the whole run
    Language::Code language = Language::Code::English;
};

QByteArray worksheetPdf(const WorksheetSubject& subject);

// Whole or not at all. Empty, or why it could not be written.
QString writeWorksheet(const QString& path, const WorksheetSubject& subject);

} // namespace thetalane

// A worksheet written into a file. Like the window it needs an application of its own: no other application
// object exists when it is called.
#pragma once

#include "core/engine/engine.h"
#include "ui/words/language.h"

#include <QString>

#include <variant>

namespace thetalane {

struct Call;

struct WorksheetRequest {
    Run run;
    std::size_t collision = 0; // there are that many
    QString output;            // a .pdf
    Language::Code language = Language::Code::English;
};

// The status to leave with, or what to write.
std::variant<int, WorksheetRequest> readWorksheetCall(const Call& call);
int drawWorksheet(int& argc, char** argv, const WorksheetRequest& request);

} // namespace thetalane

// The commands of the program, one file each.
#pragma once

#include "app/studies.h"
#include "app/window.h"
#include "ui/words/language.h"

#include <QString>
#include <QStringList>

#include <span>
#include <variant>

namespace thetalane {

struct MapPictureRequest;

// What follows the command's name, and the language to answer in (its translators are installed).
struct Call {
    QStringList arguments;
    Language::Code language = Language::Code::English;
};

struct Command {
    const char* name;
    const char* summary; // in English; commandSummary() translates
    int (*run)(
        const Call&); // null: picture, map and study, which may be drawn by an application of their own
};

// In the order of --help.
std::span<const Command> commands();
QString commandSummary(const QString& name);

// Each returns the exit status, with its output written and its errors told.
int runCommand(const Call& call);
int explainCommand(const Call& call);
int throwCommand(const Call& call);
int scoreCommand(const Call& call);
int scenesCommand(const Call& call);
int sceneCommand(const Call& call);

// The status to leave with, or what to draw.
std::variant<int, PictureRequest> readPictureCall(const Call& call);
std::variant<int, MapPictureRequest> mapCommand(const Call& call);
std::variant<int, StudyPicture> readStudyCall(const Call& call);

} // namespace thetalane

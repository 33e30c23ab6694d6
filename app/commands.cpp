#include "app/commands.h"

#include <QCoreApplication>

namespace thetalane {
namespace {

constexpr Command all[] = {
    {"scenes", QT_TRANSLATE_NOOP("Commands", "lists the built-in scenes: name, title"), scenesCommand},
    {"scene", QT_TRANSLATE_NOOP("Commands", "prints a built-in scene as a scene file, to edit"),
     sceneCommand},
    {"run", QT_TRANSLATE_NOOP("Commands", "simulates a scene: a table of collisions and totals, JSON or CSV"),
     runCommand},
    {"explain",
     QT_TRANSLATE_NOOP("Commands", "works through one collision, step by step, with its numbers substituted"),
     explainCommand},
    {"throw", QT_TRANSLATE_NOOP("Commands", "throws one ball down the regulation lane at a full rack"),
     throwCommand},
    {"study",
     QT_TRANSLATE_NOOP("Commands",
                       "measures speed against accuracy, method by method, and what is made of extremes"),
     nullptr},
    {"map", QT_TRANSLATE_NOOP("Commands", "the strike map: pins down over offset and entry angle"), nullptr},
    {"score", QT_TRANSLATE_NOOP("Commands", "scores a game of ten-pin bowling: frames and totals"),
     scoreCommand},
    {"picture", QT_TRANSLATE_NOOP("Commands", "draws the window, as it would look, into a PNG file"),
     nullptr},
    {"worksheet",
     QT_TRANSLATE_NOOP("Commands",
                       "a collision to work through by hand, with an answer page, as a PDF file to print"),
     nullptr},
};

} // namespace

std::span<const Command> commands() {
    return all;
}

QString commandSummary(const QString& name) {
    for (const Command& command : all)
        if (name == command.name)
            return QCoreApplication::translate("Commands", command.summary);
    return {};
}

} // namespace thetalane

// thetalane run SCENE
#include "app/commands.h"
#include "app/console.h"
#include "app/engine_choice.h"
#include "app/engine_options.h"
#include "app/options.h"
#include "app/run_report.h"
#include "app/scene_source.h"
#include "core/format/run_file.h"

#include <QCoreApplication>

namespace thetalane {
namespace {

struct RunCommandText {
    Q_DECLARE_TR_FUNCTIONS(RunCommandText)
};

void declare(Arguments& a) {
    takeScene(a);
    takeEngineOptions(a);
    takeTolerance(a);
    a.takesFlag("json", RunCommandText::tr("prints JSON for programs"));
    a.takesFlag("csv", RunCommandText::tr("prints a row for each collision"));
    a.takesFlag("summary", RunCommandText::tr("leaves the list of collisions out, and out of memory"));
}

void checkOutput(Arguments& a) {
    if (a.has("json") && a.has("csv"))
        a.note(RunCommandText::tr("--csv: choose either --json or --csv"));
    if (a.has("summary") && a.has("csv"))
        a.note(RunCommandText::tr(
            "--summary: leaves out the collisions that --csv lists; choose one of the two"));
}

} // namespace

int runCommand(const Call& call) {
    Arguments a("run SCENE [--json|--csv] [--summary] …", commandSummary("run"));
    declare(a);
    if (const auto status = a.read(call.arguments))
        return *status;
    EngineSettings settings = engineSettings(a);
    settings.keepDetail = !a.has("summary");
    checkOutput(a);
    checkTolerance(a);
    if (const auto status = a.faults())
        return *status;

    auto scene = loadScene(a.positional());
    if (const auto* fault = std::get_if<QString>(&scene))
        return wrongCall(*fault);
    settings = chosenSettings(a, settings, std::get<Scene>(scene));
    const auto outcome = simulateOrTell(std::get<Scene>(std::move(scene)), settings);
    if (const auto* fault = std::get_if<QString>(&outcome))
        return wrongCall(*fault);

    const Run& run = std::get<Run>(outcome);
    if (a.has("json")) {
        writeRunJson(run, standardOutput());
    } else if (a.has("csv")) {
        writeRunCsv(run, standardOutput());
    } else {
        printHeading(run, call.language);
        printCollisions(run);
        printTotals(run);
    }
    return finishOutput();
}

} // namespace thetalane

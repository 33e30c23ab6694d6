// thetalane worksheet SCENE --output FILE.pdf: which collision, and where it goes; the drawing needs an
// application of its own.
#include "app/commands.h"
#include "app/console.h"
#include "app/engine_options.h"
#include "app/options.h"
#include "app/save_file.h"
#include "app/scene_source.h"
#include "app/worksheet_file.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

struct WorksheetText {
    Q_DECLARE_TR_FUNCTIONS(WorksheetCommand)
};

QString outputOption(Arguments& a) {
    const QString path = a.value("output");
    if (path.isEmpty())
        a.note("--output: " + WorksheetText::tr("is missing; say where the worksheet goes, FILE.pdf"));
    else if (!path.endsWith(".pdf", Qt::CaseInsensitive))
        a.note("--output: " + WorksheetText::tr("must end in .pdf, is \"%1\"").arg(path));
    return path;
}

} // namespace

std::variant<int, WorksheetRequest> readWorksheetCall(const Call& call) {
    Arguments a("worksheet SCENE --output FILE.pdf …", commandSummary("worksheet"));
    takeScene(a);
    a.takesValue("output", "FILE.pdf", WorksheetText::tr("where the worksheet goes"));
    a.takesValue("collision", "K", WorksheetText::tr("which collision, from 1; the first unless said"));
    takeEngineOptions(a);
    if (const auto status = a.read(call.arguments))
        return *status;
    WorksheetRequest request;
    request.language = call.language;
    request.output = outputOption(a);
    const qint64 number = a.count("collision", 1);
    EngineSettings settings = engineSettings(a);
    if (const auto status = a.faults())
        return *status;

    auto scene = loadScene(a.positional());
    if (const auto* fault = std::get_if<QString>(&scene))
        return wrongCall(*fault);
    // No more than it takes to see all that it was resolved together with.
    const std::int64_t enough = number + 5 * std::int64_t(std::get<Scene>(scene).bodies.size());
    settings.maxCollisions = std::min(settings.maxCollisions, enough);
    auto outcome = simulateOrTell(std::get<Scene>(std::move(scene)), settings);
    if (const auto* fault = std::get_if<QString>(&outcome))
        return wrongCall(*fault);
    request.run = std::get<Run>(std::move(outcome));
    const std::int64_t count = request.run.timeline.collisionCount();
    if (count == 0)
        return wrongCall(WorksheetText::tr("%1: nothing collides in this scene in the time asked for")
                             .arg(a.positional()));
    if (count < number)
        return wrongCall("--collision: " +
                         WorksheetText::tr("must be from 1 to %1, the number of collisions, is %2")
                             .arg(count)
                             .arg(number));
    if (const auto status = cannotSave(request.output))
        return *status;
    request.collision = std::size_t(number - 1);
    return request;
}

} // namespace thetalane

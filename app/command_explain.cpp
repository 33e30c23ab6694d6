// thetalane explain SCENE
#include "app/commands.h"
#include "app/console.h"
#include "app/engine_options.h"
#include "app/options.h"
#include "app/run_report.h"
#include "app/scene_source.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

struct ExplainCommandText {
    Q_DECLARE_TR_FUNCTIONS(ExplainCommandText)
};

void printStep(const WorkedStep& step) {
    printLine();
    printLine(QString("%1. %2").arg(int(step.stage)).arg(step.title));
    printLine(step.sentence);
    for (const WorkedLine& line : step.lines)
        printLine("    " + oneLine(plainText(line)));
}

void printExplanation(const Run& run, std::size_t index, Language::Code language) {
    const Collision& collision = run.timeline.collisions()[index];
    printHeading(run, language);
    printLine(
        ExplainCommandText::tr("Collision %1: %2, at %3 s")
            .arg(QString::number(index + 1), pairText(run.scene, collision), numberText(collision.time, 6)));
    const Instant instant = instantOf(run.timeline.collisions(), index);
    if (instant.size > 1) {
        printLine(instantText(instant, index) + QStringLiteral("."));
        printLine(instantRule(instant, run.settings));
    }
    for (const WorkedStep& step : workedSteps(run.scene, run.timeline.collisions(), index))
        printStep(step);
}

// As many collisions as it takes to see collision `number` and all that it was resolved together with: discs
// touch at no more than three points each, and two walls.
std::int64_t enoughToSee(qint64 number, const Scene& scene) {
    return number + 5 * std::int64_t(scene.bodies.size());
}

QString noSuchCollision(const QString& scene, qint64 asked, std::int64_t count) {
    if (count == 0)
        return ExplainCommandText::tr("%1: nothing collides in this scene in the time asked for").arg(scene);
    return "--collision: " + ExplainCommandText::tr("must be from 1 to %1, the number of collisions, is %2")
                                 .arg(count)
                                 .arg(asked);
}

} // namespace

int explainCommand(const Call& call) {
    Arguments a("explain SCENE [--collision K] …", commandSummary("explain"));
    takeScene(a);
    a.takesValue("collision", "K", ExplainCommandText::tr("which collision, from 1; the first unless said"));
    takeEngineOptions(a);
    if (const auto status = a.read(call.arguments))
        return *status;
    const qint64 number = a.count("collision", 1);
    EngineSettings settings = engineSettings(a);
    if (const auto status = a.faults())
        return *status;

    auto scene = loadScene(a.positional());
    if (const auto* fault = std::get_if<QString>(&scene))
        return wrongCall(*fault);
    settings.maxCollisions = // the rest is not asked
        std::min(settings.maxCollisions, enoughToSee(number, std::get<Scene>(scene)));
    const auto outcome = simulateOrTell(std::get<Scene>(std::move(scene)), settings);
    if (const auto* fault = std::get_if<QString>(&outcome))
        return wrongCall(*fault);

    const Run& run = std::get<Run>(outcome);
    const std::int64_t count = run.timeline.collisionCount();
    if (count < number)
        return wrongCall(noSuchCollision(a.positional(), number, count));
    printExplanation(run, std::size_t(number - 1), call.language);
    return finishOutput();
}

} // namespace thetalane

// thetalane study WHAT
#include "app/commands.h"
#include "app/console.h"
#include "app/options.h"
#include "app/scene_source.h"
#include "app/studies.h"
#include "ui/words/scene_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

struct StudyCommandText {
    Q_DECLARE_TR_FUNCTIONS(StudyCommandText)
};

using Outcome = std::variant<int, StudyPicture>;

constexpr std::string_view methodWords[] = {"quick", "standard", "all"};
constexpr std::string_view throwScenes[] = {"rack", "bowling"};
constexpr qint64 mostThrows = 1'000'000;
constexpr qint64 mostThreads = 1024;

void declare(Arguments& a) {
    a.takesOne("STUDY", StudyCommandText::tr(
                            "throws: thousands of throws at the rack, by every method; a SCENE: that one; "
                            "extremes: masses, radii, speeds, places and counts at the edge of what numbers "
                            "hold, each with its bound"));
    a.takesValue("throws", "N",
                 StudyCommandText::tr("how many throws; 4000 unless said, on the whole lane 1000"));
    a.takesValue(
        "scene", "rack|bowling",
        StudyCommandText::tr("of throws: the rack without friction, or the whole lane; rack unless said"));
    a.takesValue("seed", "S", StudyCommandText::tr("of the throws; 2026 unless said"));
    a.takesValue("restitution", "E", StudyCommandText::tr("of throws: between bodies; 0.75 unless said"));
    a.takesValue("until", "S", StudyCommandText::tr("of a SCENE: the time to run [s]; 10 unless said"));
    a.takesValue(
        "methods", "quick|standard|all",
        StudyCommandText::tr("a few, steps down to 1/1000 s, or down to 1/100000 s; standard unless said"));
    a.takesValue("threads", "N", StudyCommandText::tr("for the errors; all of the machine unless said"));
    a.takesValue("csv", "FILE", StudyCommandText::tr("writes the table to a file as well"));
    a.takesValue("picture", "FILE.png", StudyCommandText::tr("draws error against cost"));
    a.takesFlag("quick", StudyCommandText::tr("of extremes: ends the longest runs at 100000 collisions, not "
                                              "10000000"));
}

void takeTable(Arguments& a) {
    a.takesValue("table", "FILE.csv",
                 StudyCommandText::tr("prints the Markdown table of such a file, and studies nothing"));
}

// The one call without a study.
int tableOfAFile(const Call& call) {
    Arguments a("study --table FILE.csv", commandSummary("study"));
    takeTable(a);
    const auto status = a.read(call.arguments);
    return status ? *status : studyTable(a.value("table"));
}

// An option that this study would leave unread is a mistake worth telling.
void needs(Arguments& a, const QString& study, std::initializer_list<const char*> options) {
    for (const char* option : options)
        if (a.has(option))
            a.note(QString("--%1: ").arg(option) +
                   StudyCommandText::tr("%1 does not take this").arg("study " + oneLine(study)));
}

qint64 countUpTo(Arguments& a, const QString& option, qint64 unlessSaid, qint64 most) {
    const qint64 count = a.count(option, unlessSaid);
    if (count > most)
        a.note("--" + option + ": " + StudyCommandText::tr("must be at most %1, is %2").arg(most).arg(count));
    return count;
}

quint64 seedOption(Arguments& a) {
    if (!a.has("seed"))
        return standardSeed;
    bool whole = false;
    const quint64 seed = a.value("seed").toULongLong(&whole);
    if (!whole)
        a.note("--seed: " + StudyCommandText::tr("must be a whole number, is \"%1\"").arg(a.value("seed")));
    return seed;
}

void readFiles(Arguments& a, MethodsCall& call) {
    call.csv = a.value("csv");
    call.picture = a.value("picture");
    if (a.has("csv") && call.csv.isEmpty())
        a.note(StudyCommandText::tr("--csv: needs the name of a file"));
    if (a.has("picture") && !call.picture.endsWith(".png", Qt::CaseInsensitive))
        a.note("--picture: " + StudyCommandText::tr("must end in .png, is \"%1\"").arg(call.picture));
}

// Without the files: those do not change what is measured.
QString repeatable(const Arguments& a) {
    QString text = "thetalane study " + a.positional();
    for (const char* option : {"scene", "throws", "seed", "restitution", "until", "methods", "threads"})
        if (a.has(option))
            text += QString(" --%1 %2").arg(option, a.value(option));
    return text;
}

Outcome studyOfThrows(Arguments& a, MethodsCall call) {
    needs(a, "throws", {"until", "quick"});
    const bool lane = a.choice("scene", 0, throwScenes) == 1;
    const int count = int(countUpTo(a, "throws", lane ? 1000 : standardThrows, mostThrows));
    call.seed = seedOption(a);
    call.throws = true;
    const double e = a.number("restitution", defaultPinRestitution,
                              {.low = 0, .high = 1, .lowOpen = false, .highOpen = false});
    if (const auto status = a.faults())
        return *status;
    call.cases = lane ? laneThrows(count, call.seed, e) : rackThrows(count, call.seed, e);
    call.title = (lane ? StudyCommandText::tr("%1 throws on the whole lane, seed %2")
                       : StudyCommandText::tr("%1 throws at the rack, seed %2"))
                     .arg(count)
                     .arg(call.seed);
    return studyOfMethods(call);
}

Outcome studyOfScene(Arguments& a, MethodsCall call) {
    needs(a, a.positional(), {"throws", "seed", "scene", "restitution", "quick"});
    const double until = a.number("until", 10, positive);
    if (const auto status = a.faults())
        return *status;
    auto scene = loadScene(a.positional());
    if (const auto* fault = std::get_if<QString>(&scene))
        return wrongCall(*fault);
    call.cases = oneScene(std::get<Scene>(std::move(scene)), until);
    const QString title = sceneTitle(call.cases.scenes.front(), call.language);
    call.title = title.isEmpty() ? a.positional() : title;
    return studyOfMethods(call);
}

} // namespace

Outcome readStudyCall(const Call& call) {
    if (std::any_of(call.arguments.begin(), call.arguments.end(),
                    [](const QString& a) { return a.section('=', 0, 0) == "--table"; }))
        return tableOfAFile(call);
    Arguments a("study throws|SCENE|extremes …", commandSummary("study"));
    declare(a);
    takeTable(a);
    if (const auto status = a.read(call.arguments))
        return *status;
    MethodsCall methods;
    methods.call = repeatable(a);
    methods.language = call.language;
    methods.options.methods = studyMethods(MethodSet(a.choice("methods", 1, methodWords)));
    methods.options.threads = int(countUpTo(a, "threads", 0, mostThreads));
    readFiles(a, methods);
    if (a.positional() == "throws")
        return studyOfThrows(a, std::move(methods));
    if (a.positional() != "extremes")
        return studyOfScene(a, std::move(methods));
    needs(a, "extremes",
          {"throws", "seed", "scene", "restitution", "until", "methods", "threads", "picture"});
    if (const auto status = a.faults())
        return *status;
    return studyOfExtremes(a.has("quick"), methods.csv);
}

} // namespace thetalane

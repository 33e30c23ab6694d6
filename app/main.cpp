// Which command, in which language; each is a file of its own.
#include "app/commands.h"
#include "app/console.h"
#include "app/map_picture.h"
#include "app/options.h"
#include "app/scene_source.h"
#include "app/text_table.h"
#include "app/worksheet_file.h"

#include <QCoreApplication>

#include <exception>
#include <vector>

using namespace thetalane;

namespace {

struct MainText {
    Q_DECLARE_TR_FUNCTIONS(MainText)
};

// A locale that is not UTF-8 makes Qt speak up on standard error, where one line is promised.
void silent(QtMsgType, const QMessageLogContext&, const QString&) {}

// The value of --language, wherever it stands; nothing where it is not asked for.
std::optional<QString> languageAsked(const QStringList& arguments) {
    std::optional<QString> asked;
    for (qsizetype i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
        if (arguments[i] == "--language" && i + 1 < arguments.size())
            asked = arguments[++i];
        else if (arguments[i].startsWith("--language="))
            asked = arguments[i].section('=', 1);
    }
    return asked;
}

int unknownCommand(const QString& name) {
    std::vector<std::string_view> known;
    for (const Command& command : commands())
        known.push_back(command.name);
    const QString near = didYouMean(name, known);
    return wrongCall(MainText::tr("%1: there is no such command;").arg(name) + ' ' +
                     (near.isEmpty() ? QString() : near + ' ') + MainText::tr("thetalane --help lists them"));
}

QString globalHelp(const Arguments& window) {
    QList<QStringList> rows;
    for (const Command& command : commands())
        rows << QStringList{QString("  thetalane ") + command.name, commandSummary(command.name)};
    return window.help() + '\n' + MainText::tr("Commands, each with a --help of its own:") + '\n' +
           tableText(rows);
}

// The call without a command: --help, --version, or the window. Status to leave with, or what to open.
std::variant<int, WindowRequest> readWindowCall(const Call& call) {
    Arguments a("[COMMAND] [--scene SCENE] [--projector] [--dark]",
                MainText::tr("Opens the window, or does what the command says without one."));
    a.takesValue("scene", "SCENE", MainText::tr("what to open: a built-in name or a scene file"));
    a.takesFlag("projector", MainText::tr("larger, for the back row of a class"));
    a.takesFlag("dark", MainText::tr("light on dark"));
    a.takesFlag("version", MainText::tr("prints the version"));
    if (call.arguments.contains("--help") || call.arguments.contains("-h")) {
        print(globalHelp(a));
        return finishOutput();
    }
    if (const auto status = a.read(call.arguments))
        return *status;
    if (a.has("version")) {
        printLine(QString("ThetaLane ") + THETALANE_VERSION);
        return finishOutput();
    }
    WindowRequest request;
    request.projector = a.has("projector");
    request.dark = a.has("dark");
    if (a.has("language"))
        request.language = call.language;
    if (a.has("scene")) {
        auto scene = loadScene(a.value("scene"));
        if (const auto* fault = std::get_if<QString>(&scene))
            return wrongCall("--scene: " + *fault);
        request.scene = std::get<Scene>(std::move(scene));
        request.sceneId = isBuiltin(a.value("scene")) ? a.value("scene") : QString();
    }
    return request;
}

// The status to leave with, or what a window is to open or to be drawn with.
using Outcome =
    std::variant<int, WindowRequest, PictureRequest, MapPictureRequest, StudyPicture, WorksheetRequest>;

Outcome toOutcome(auto&& read) {
    return std::visit([](auto&& value) -> Outcome { return std::forward<decltype(value)>(value); },
                      std::forward<decltype(read)>(read));
}

// Runs what needs no application but this one.
Outcome dispatch(int& argc, char** argv) {
    const auto spoken = qInstallMessageHandler(silent);
    const QCoreApplication app(argc, argv);
    qInstallMessageHandler(spoken);
    QCoreApplication::setApplicationName("thetalane");
    QCoreApplication::setApplicationVersion(THETALANE_VERSION);

    Call call{QCoreApplication::arguments().mid(1), Language::ofSystem()};
    const auto asked = languageAsked(call.arguments);
    Language language;
    const bool known = !asked || Language::parse(*asked, call.language);
    language.use(call.language);
    if (!known)
        return wrongCall("--language: " + MainText::tr("must be ko or en, is \"%1\"").arg(*asked));
    if (call.arguments.isEmpty() || call.arguments.first().startsWith('-'))
        return toOutcome(readWindowCall(call));

    const QString name = call.arguments.takeFirst();
    if (name == "picture")
        return toOutcome(readPictureCall(call));
    if (name == "map")
        return toOutcome(mapCommand(call));
    if (name == "study")
        return toOutcome(readStudyCall(call));
    if (name == "worksheet")
        return toOutcome(readWorksheetCall(call));
    for (const Command& command : commands())
        if (name == command.name)
            return command.run(call);
    return unknownCommand(name);
}

int start(int argc, char** argv) {
    const Outcome outcome = dispatch(argc, argv);
    if (const auto* window = std::get_if<WindowRequest>(&outcome))
        return runWindow(argc, argv, *window);
    if (const auto* picture = std::get_if<PictureRequest>(&outcome))
        return drawPicture(argc, argv, *picture);
    if (const auto* map = std::get_if<MapPictureRequest>(&outcome))
        return drawMapPicture(argc, argv, *map);
    if (const auto* study = std::get_if<StudyPicture>(&outcome))
        return drawStudyPicture(argc, argv, *study);
    if (const auto* worksheet = std::get_if<WorksheetRequest>(&outcome))
        return drawWorksheet(argc, argv, *worksheet);
    return std::get<int>(outcome);
}

} // namespace

int main(int argc, char** argv) {
    try {
        return start(argc, argv);
    } catch (const std::bad_alloc&) {
        return failure("out of memory"); // no memory for a translation either
    } catch (const std::exception& error) {
        return failure(QString::fromUtf8(error.what()));
    }
}

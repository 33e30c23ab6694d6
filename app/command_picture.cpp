// thetalane picture SCENE --output FILE.png: what to draw; the drawing needs an application of its own.
#include "app/commands.h"
#include "app/console.h"
#include "app/engine_options.h"
#include "app/options.h"
#include "app/scene_source.h"
#include "ui/lab/lab_plan.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace thetalane {
namespace {

struct PictureText {
    Q_DECLARE_TR_FUNCTIONS(PictureCommand)
};

constexpr int smallest = 320;
constexpr int largest = 8192;

QSize sizeOption(Arguments& a, QSize unlessSaid) {
    if (!a.has("size"))
        return unlessSaid;
    static const QRegularExpression form("^([0-9]{1,5})x([0-9]{1,5})$");
    const auto match = form.match(a.value("size"));
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    if (!match.hasMatch() || qMin(size.width(), size.height()) < smallest ||
        qMax(size.width(), size.height()) > largest)
        a.note("--size: " + PictureText::tr("must be WIDTHxHEIGHT, each from %1 to %2, is \"%3\"")
                                .arg(smallest)
                                .arg(largest)
                                .arg(a.value("size")));
    return size;
}

Stage stageOption(Arguments& a) {
    if (!a.has("stage"))
        return Stage::Contact;
    if (!a.has("collision"))
        a.note("--stage: " + PictureText::tr("is the stage of a collision; say which with --collision"));
    const double stage =
        a.number("stage", 0, {.low = 0, .high = stageCount - 1, .lowOpen = false, .highOpen = false});
    if (stage != int(stage))
        a.note("--stage: " + PictureText::tr("must be a whole number from 0 to %1, is %2")
                                 .arg(stageCount - 1)
                                 .arg(a.value("stage")));
    return Stage(int(stage));
}

int labOption(Arguments& a) {
    const qint64 question = a.count("lab", 1);
    if (question > presetCount)
        a.note("--lab: " + PictureText::tr("must be from 1 to %1, is %2").arg(presetCount).arg(question));
    return int(question - 1);
}

QString outputOption(Arguments& a) {
    const QString path = a.value("output");
    if (path.isEmpty())
        a.note("--output: " + PictureText::tr("is missing; say where the picture goes, FILE.png"));
    else if (!path.endsWith(".png", Qt::CaseInsensitive))
        a.note("--output: " + PictureText::tr("must end in .png, is \"%1\"").arg(path));
    return path;
}

QString roomList() {
    QStringList names;
    for (const std::string_view id : roomIds)
        names << QString::fromUtf8(id.data(), qsizetype(id.size()));
    return names.join(QStringLiteral(", "));
}

// As the window will run it, as far as is asked.
std::optional<QString> collisionFault(const Scene& scene, std::size_t asked) {
    EngineSettings settings;
    settings.maxCollisions = std::int64_t(asked) + 1;
    settings.keepDetail = false;
    const auto outcome = simulateOrTell(scene, settings);
    if (const auto* fault = std::get_if<QString>(&outcome))
        return *fault;
    const auto count = std::size_t(std::get<Run>(outcome).timeline.collisionCount());
    if (asked < count)
        return std::nullopt;
    return "--collision: " + (count == 0
                                  ? PictureText::tr("nothing collides in this scene")
                                  : PictureText::tr("must be from 1 to %1, the number of collisions, is %2")
                                        .arg(count)
                                        .arg(asked + 1));
}

} // namespace

std::variant<int, PictureRequest> readPictureCall(const Call& call) {
    Arguments a("picture SCENE --output FILE.png …", commandSummary("picture"));
    takeScene(a);
    a.takesValue("output", "FILE.png", PictureText::tr("where the picture goes"));
    a.takesValue("at", "S", PictureText::tr("the moment to show, in seconds; 0 unless said"));
    a.takesValue("collision", "K", PictureText::tr("the collision to open, from 1"));
    a.takesValue("stage", "0-5",
                 PictureText::tr("its stage: 0 contact, 1 split, 2 rotation, 3 exchange, 4 back, 5 check"));
    a.takesValue("lab", "1-6",
                 PictureText::tr("opens the accuracy lab on its question 1 to 6, measured here and now"));
    a.takesValue("size", "WxH", PictureText::tr("of the picture, in pixels; 1280x800 unless said"));
    a.takesValue("panel", "NAME", PictureText::tr("the panel to open: %1").arg(roomList()));
    a.takesValue("game", "FILE", PictureText::tr("a saved game to go on with"));
    a.takesFlag("projector", PictureText::tr("larger, for the back row of a class"));
    a.takesFlag("dark", PictureText::tr("light on dark"));
    if (const auto status = a.read(call.arguments))
        return *status;

    PictureRequest request;
    request.window.language = call.language;
    request.window.projector = a.has("projector");
    request.window.dark = a.has("dark");
    request.game = a.value("game");
    if (a.has("panel"))
        request.room = Room{a.choice("panel", 0, roomIds)};
    request.output = outputOption(a);
    request.at = a.number("at", 0, {.low = 0, .lowOpen = false});
    if (a.has("at") && a.has("collision"))
        a.note("--at: " +
               PictureText::tr("a collision has its own moment; say --at or --collision, not both"));
    if (a.has("collision"))
        request.collision = std::size_t(a.count("collision", 1) - 1);
    request.stage = stageOption(a);
    if (a.has("lab"))
        request.lab = labOption(a);
    request.size = sizeOption(a, request.size);
    if (const auto status = a.faults())
        return *status;

    auto scene = loadScene(a.positional());
    if (const auto* fault = std::get_if<QString>(&scene))
        return wrongCall(*fault);
    request.window.scene = std::get<Scene>(std::move(scene));
    request.window.sceneId = isBuiltin(a.positional()) ? a.positional() : QString();
    if (request.collision)
        if (const auto fault = collisionFault(*request.window.scene, *request.collision))
            return wrongCall(*fault);
    return request;
}

} // namespace thetalane

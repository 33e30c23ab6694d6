#include "app/window.h"

#include "app/console.h"
#include "app/off_screen.h"
#include "ui/application_icon.h"
#include "ui/game/alley.h"
#include "ui/lab/lab_plan.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QImage>
#include <QSettings>
#include <QStyleFactory>

#include <algorithm>

namespace thetalane {
namespace {

struct WindowText {
    Q_DECLARE_TR_FUNCTIONS(Window)
};

// Everything behind the window, in the order in which one needs the other.
struct Application {
    QApplication qt;
    Language language;
    Session session;
    Appearance appearance;
    Playhead playhead{session};

    Application(int& argc, char** argv)
        : qt(argc, argv) {
        QCoreApplication::setOrganizationName("ThetaLane");
        QCoreApplication::setApplicationName("ThetaLane");
        QApplication::setStyle(QStyleFactory::create("Fusion"));
        QApplication::setWindowIcon(applicationIcon());
    }

    Context context() { return {session, playhead, appearance}; }

    void open(const WindowRequest& request) {
        if (!request.sceneId.isEmpty())
            session.openBuiltin(request.sceneId);
        else if (request.scene)
            session.open(*request.scene);
    }
};

Language::Code rememberedLanguage() {
    Language::Code code = Language::ofSystem();
    Language::parse(QSettings().value("language").toString(), code);
    return code;
}

constexpr const char* noDisplay = "offscreen";

// Where no display answers Qt would abort; with a platform to fall back on we can say so instead.
QByteArray platformsToTry(const QByteArray& asked) {
    if (!asked.isEmpty())
        return asked.contains(noDisplay) ? asked : asked + ';' + noDisplay;
    return QByteArray(qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ? "wayland;xcb;" : "xcb;") + noDisplay;
}

// Qt may have something to say about the session or the display; standard error is for one line of ours.
void silent(QtMsgType, const QMessageLogContext&, const QString&) {}

// The window's size for a picture of `asked` pixels: the window has a least size, and a smaller picture shows
// it whole, reduced.
QSize windowSize(QSize asked, QSize least) {
    const double reduction =
        std::max({1.0, double(least.width()) / asked.width(), double(least.height()) / asked.height()});
    return (QSizeF(asked) * reduction).toSize().expandedTo(least);
}

QImage pictureOf(QWidget& window, QSize size) {
    const QImage image = window.grab().toImage();
    return image.size() == size ? image : image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace

int runWindow(int& argc, char** argv, const WindowRequest& request) {
    const QByteArray asked = qgetenv("QT_QPA_PLATFORM");
    qputenv("QT_QPA_PLATFORM", platformsToTry(asked));
    const auto spoken = qInstallMessageHandler(silent);
    Application app(argc, argv);
    qInstallMessageHandler(spoken);
    app.language.use(request.language.value_or(rememberedLanguage()));
    if (!asked.contains(noDisplay) && QGuiApplication::platformName() == noDisplay)
        return failure(
            WindowText::tr("no display answers; thetalane --help lists the commands that need none"));
    app.open(request);
    // Before the window has a palette of its own: the system's, at first.
    app.appearance.setDark(QGuiApplication::palette().color(QPalette::Window).lightness() < 128);
    MainWindow window(app.context(), app.language);
    window.restoreState();
    window.keepRecoveries();
    if (request.projector)
        app.appearance.setProjector(true);
    if (request.dark)
        app.appearance.setDark(true);
    window.show();
    return QApplication::exec();
}

int drawPicture(int& argc, char** argv, const PictureRequest& request) {
    drawOffScreen();
    Application app(argc, argv);
    app.language.use(request.window.language.value_or(Language::ofSystem()));
    app.open(request.window);
    MainWindow window(app.context(), app.language);
    app.appearance.setReducedMotion(true);
    app.appearance.setProjector(request.window.projector);
    app.appearance.setDark(request.window.dark);
    window.resize(windowSize(request.size, window.minimumSize()));
    window.show();
    QCoreApplication::processEvents();
    if (request.collision) {
        const auto number = std::int64_t(*request.collision) + 1;
        app.session.waitFor(number);
        app.playhead.selectNumber(number);
        app.playhead.setStage(request.stage);
    } else {
        app.session.waitFor(request.at);
        app.playhead.setTime(request.at);
    }
    if (!request.game.isEmpty() && window.alley().openSaved(request.game))
        return failure(WindowText::tr("%1: this game cannot be read").arg(oneLine(request.game)));
    QCoreApplication::processEvents();
    if (request.room)
        window.enter(*request.room);
    if (request.lab)
        window.openLab(Preset(*request.lab));
    while (window.isMeasuring())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    QCoreApplication::processEvents();
    return savePicture(request.output, pictureOf(window, request.size));
}

} // namespace thetalane

#include "app/window.h"

#include "app/console.h"
#include "ui/application_icon.h"
#include "ui/main_window.h"

#include <QApplication>
#include <QImage>
#include <QSaveFile>
#include <QSettings>
#include <QStyleFactory>

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

// Off screen Qt may have something to say about the session; standard error is for one line of ours.
void silent(QtMsgType, const QMessageLogContext&, const QString&) {}

int savePng(const QImage& image, const QString& path) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !image.save(&file, "PNG") || !file.commit())
        return failure("--output: " + oneLine(path) + ": " + oneLine(file.errorString()));
    return Done;
}

} // namespace

int runWindow(int& argc, char** argv, const WindowRequest& request) {
    // Where no display answers Qt would abort; with a platform to fall back on we can say so instead.
    const bool chosen = qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
    if (!chosen)
        qputenv("QT_QPA_PLATFORM",
                qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ? "wayland;xcb;offscreen" : "xcb;offscreen");
    Application app(argc, argv);
    app.language.use(request.language.value_or(rememberedLanguage()));
    if (!chosen && QGuiApplication::platformName() == "offscreen")
        return failure(
            WindowText::tr("no display answers; thetalane --help lists the commands that need none"));
    app.open(request);
    MainWindow window(app.context(), app.language);
    window.restoreState();
    if (request.projector)
        window.setProjector(true);
    window.show();
    return QApplication::exec();
}

int drawPicture(int& argc, char** argv, const PictureRequest& request) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(silent);
    Application app(argc, argv);
    app.language.use(request.window.language.value_or(Language::ofSystem()));
    app.open(request.window);
    MainWindow window(app.context(), app.language);
    window.setReducedMotion(true);
    window.setProjector(request.window.projector);
    window.resize(request.size);
    window.show();
    QCoreApplication::processEvents();
    if (request.collision) {
        app.playhead.select(*request.collision);
        app.playhead.setStage(request.stage);
    } else {
        app.playhead.setTime(request.at);
    }
    QCoreApplication::processEvents();
    return savePng(window.grab().toImage(), request.output);
}

} // namespace thetalane

#include "app/window.h"

#include "app/console.h"
#include "ui/application_icon.h"
#include "ui/lab/lab_plan.h"
#include "ui/main_window.h"

#include <QApplication>
#include <QBuffer>
#include <QImage>
#include <QSaveFile>
#include <QSettings>
#include <QStyleFactory>

#include <algorithm>
#include <new>

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

// A disk that fills up takes a part first, and tells why with the next piece.
bool writeAll(QIODevice& device, const QByteArray& bytes) {
    qint64 written = 0;
    while (written < bytes.size()) {
        const qint64 n = device.write(bytes.constData() + written, bytes.size() - written);
        if (n <= 0)
            return false;
        written += n;
    }
    return true;
}

int savePng(const QImage& image, const QString& path) {
    // In memory first: where the disk is full, libpng would have a line of its own to say.
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw std::bad_alloc();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !writeAll(file, png) || !file.commit())
        return failure("--output: " + oneLine(path) + ": " + oneLine(file.errorString()));
    return Done;
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
    MainWindow window(app.context(), app.language);
    window.restoreState();
    if (request.projector)
        window.setProjector(true);
    window.show();
    return QApplication::exec();
}

int drawPicture(int& argc, char** argv, const PictureRequest& request) {
    qputenv("QT_QPA_PLATFORM", noDisplay);
    for (const char* ofTheScreen : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"})
        qunsetenv(ofTheScreen); // the size is asked for in pixels
    qInstallMessageHandler(silent);
    Application app(argc, argv);
    app.language.use(request.window.language.value_or(Language::ofSystem()));
    app.open(request.window);
    MainWindow window(app.context(), app.language);
    window.setReducedMotion(true);
    window.setProjector(request.window.projector);
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
    if (request.lab) {
        window.openLab(Preset(*request.lab));
        while (window.isMeasuring())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QCoreApplication::processEvents();
    return savePng(pictureOf(window, request.size), request.output);
}

} // namespace thetalane

// The picture of a study, drawn off screen.
#include "app/console.h"
#include "app/studies.h"
#include "ui/plot/paint_plot.h"
#include "ui/plot/study_plot.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <new>

namespace thetalane {
namespace {

// Qt may have something to say about the session; standard error is for lines of ours.
void silent(QtMsgType, const QMessageLogContext&, const QString&) {}

QImage pictureOf(const StudyPicture& picture) {
    constexpr int width = 1200, height = 800, type = 18;
    QImage image(width, height, QImage::Format_RGB32);
    QPainter painter(&image);
    PlotStyle style;
    style.font = QGuiApplication::font();
    style.font.setPixelSize(type);
    style.lineWidth = 2.5;
    paintPlot(painter, image.rect(), workPrecisionPlot(picture.result, picture.title, picture.throws), style);
    return image;
}

} // namespace

int drawStudyPicture(int& argc, char** argv, const StudyPicture& picture) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    for (const char* ofTheScreen : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"})
        qunsetenv(ofTheScreen); // the size is in pixels
    qInstallMessageHandler(silent);
    const QGuiApplication app(argc, argv);
    Language language;
    language.use(picture.language);
    // In memory first: where the disk is full, libpng would have a line of its own to say.
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!pictureOf(picture).save(&buffer, "PNG"))
        throw std::bad_alloc();
    QSaveFile file;
    if (!openFile(file, picture.output) || file.write(png) != png.size() || !file.commit())
        return unwritten(file);
    return Done;
}

} // namespace thetalane

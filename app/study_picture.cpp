// The picture of a study, drawn off screen.
#include "app/off_screen.h"
#include "app/studies.h"
#include "ui/plot/paint_plot.h"
#include "ui/plot/study_plot.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>

namespace thetalane {
namespace {

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
    drawOffScreen();
    const QGuiApplication app(argc, argv);
    Language language;
    language.use(picture.language);
    return savePicture(picture.output, pictureOf(picture));
}

} // namespace thetalane

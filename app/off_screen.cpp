#include "app/off_screen.h"

#include "app/save_file.h"

#include <QBuffer>
#include <QImage>

#include <new>

namespace thetalane {
namespace {

void silent(QtMsgType, const QMessageLogContext&, const QString&) {}

} // namespace

void drawOffScreen() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    for (const char* ofTheScreen : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"})
        qunsetenv(ofTheScreen);
    qInstallMessageHandler(silent);
}

int savePicture(const QString& path, const QImage& image) {
    // In memory first: where the disk is full, libpng would have a line of its own to say.
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw std::bad_alloc();
    return saveFile(path, png);
}

} // namespace thetalane

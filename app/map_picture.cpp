#include "app/map_picture.h"

#include "app/console.h"
#include "app/save_file.h"
#include "ui/plot/strike_map_figure.h"

#include <QBuffer>
#include <QFont>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <new>

namespace thetalane {
namespace {

constexpr QSize pictureSize(1380, 1020);

// Qt may have something to say about the session or fonts; standard error is for one line of ours.
void silent(QtMsgType, const QMessageLogContext&, const QString&) {}

} // namespace

int drawMapPicture(int& argc, char** argv, const MapPictureRequest& request) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    for (const char* ofTheScreen : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"})
        qunsetenv(ofTheScreen); // the size is one in pixels
    qInstallMessageHandler(silent);
    const QGuiApplication app(argc, argv);
    Language language;
    language.use(request.language);
    QImage image(pictureSize, QImage::Format_RGB32);
    QPainter painter(&image);
    QFont font; // as of the window: one in which Korean and Latin fit together
    font.setFamilies(
        {"Pretendard", "Noto Sans CJK KR", "Noto Sans KR", "NanumGothic", "Malgun Gothic", font.family()});
    painter.setFont(font);
    paintStrikeMap(painter, QRectF(image.rect()), request.map);
    painter.end();
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw std::bad_alloc();
    return saveFile(request.output, png);
}

} // namespace thetalane

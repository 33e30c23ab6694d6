#include "app/map_picture.h"

#include "app/off_screen.h"
#include "ui/plot/strike_map_figure.h"

#include <QFont>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

namespace thetalane {
namespace {

constexpr QSize pictureSize(1380, 1020);

} // namespace

int drawMapPicture(int& argc, char** argv, const MapPictureRequest& request) {
    drawOffScreen();
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
    return savePicture(request.output, image);
}

} // namespace thetalane

#include "ui/application_icon.h"

#include <QPainter>
#include <QPixmap>

namespace thetalane {
namespace {

void paintMark(QPainter& p) {
    const QColor white(Qt::white);
    p.setPen(Qt::NoPen);
    p.setBrush(QColor(0xF3, 0xE8, 0xD6));
    p.drawRoundedRect(QRectF(0, 0, 128, 128), 28, 28);
    p.setPen(QPen(QColor(0x00, 0x9E, 0x73), 4, Qt::DashLine));
    p.drawLine(QPointF(8, 107), QPointF(120, 32));
    p.setPen(Qt::NoPen);
    p.setBrush(QColor(0x00, 0x72, 0xB2));
    p.drawEllipse(QPointF(45, 82), 30, 30);
    p.setBrush(QColor(0xD5, 0x5E, 0x00));
    p.drawEllipse(QPointF(90, 52), 24, 24);
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(QColor(0xE6, 0x9F, 0x00), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.drawPolyline(QPolygonF({{45, 82}, {90, 82}, {90, 52}}));
    p.setPen(QPen(white, 5, Qt::SolidLine, Qt::RoundCap));
    p.drawLine(QPointF(45, 82), QPointF(90, 52));
    p.setPen(QPen(white, 4, Qt::SolidLine, Qt::RoundCap));
    p.drawArc(QRectF(23, 60, 44, 44), 0, 16 * 34);
}

} // namespace

QIcon applicationIcon() {
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(size / 128.0, size / 128.0);
        paintMark(painter);
        painter.end();
        icon.addPixmap(pixmap);
    }
    return icon;
}

} // namespace thetalane

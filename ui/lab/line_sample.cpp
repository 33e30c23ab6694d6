#include "ui/lab/line_sample.h"

#include <QGuiApplication>
#include <QPainter>

namespace thetalane {

QColor seenColour(const QColor& colour, const Appearance& appearance) {
    if (!appearance.dark())
        return colour;
    const auto lighter = [](int part) { return part + (255 - part) * 2 / 5; };
    return QColor(lighter(colour.red()), lighter(colour.green()), lighter(colour.blue()));
}

QSize lineSampleSize(const Appearance& appearance) {
    return appearance.projector() ? QSize(40, 16) : QSize(28, 12);
}

QIcon lineSample(const MethodStyle& style, const Appearance& appearance) {
    const QSize size = lineSampleSize(appearance);
    const qreal ratio = qGuiApp->devicePixelRatio();
    QPixmap pixmap(size * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setPen(
        QPen(seenColour(style.colour, appearance), appearance.lineWidth() * 1.25, style.line, Qt::FlatCap));
    const double middle = size.height() / 2.0;
    painter.drawLine(QPointF(0, middle), QPointF(size.width(), middle));
    QIcon icon;
    icon.addPixmap(pixmap, QIcon::Normal);
    icon.addPixmap(pixmap, QIcon::Selected); // as it is, not tinted
    return icon;
}

} // namespace thetalane

#include "ui/lane/floor_picture.h"

#include "ui/lane/floor.h"

#include <utility>

namespace thetalane {

void FloorPicture::paint(QPainter& painter, const QWidget& viewport, const QRegion& exposed,
                         const Scene& scene, const Appearance& appearance) {
    const QTransform transform = painter.worldTransform();
    const double ratio = painter.device()->devicePixelRatioF();
    const auto units = [&](const QRect& pixels) { return transform.inverted().mapRect(QRectF(pixels)); };
    const bool still = m_stands && transform == m_transform && viewport.size() == m_size && ratio == m_ratio;
    if (!still) {
        m_stands = true;
        m_transform = transform;
        m_size = viewport.size();
        m_ratio = ratio;
        m_picture = {};
        return paintFloor(painter, scene, appearance, units(exposed.boundingRect()));
    }
    if (m_picture.isNull()) {
        m_picture = QPixmap((QSizeF(m_size) * ratio).toSize());
        m_picture.setDevicePixelRatio(ratio);
        QPainter once(&m_picture);
        once.setWorldTransform(transform);
        paintFloor(once, scene, appearance, units(viewport.rect()));
    }
    painter.save();
    painter.resetTransform();
    for (const QRect& rect : exposed)
        painter.drawPixmap(rect.topLeft(), m_picture,
                           QRectF(QPointF(rect.topLeft()) * ratio, QSizeF(rect.size()) * ratio).toRect());
    painter.restore();
}

} // namespace thetalane

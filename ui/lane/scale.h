// Metres to the units of the graphics scene, and to the pixels of whoever paints: here and nowhere else.
#pragma once

#include "core/math/vec2.h"

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QTransform>

namespace thetalane {

// A unit is a millimetre; y points up in metres and down in units.
inline constexpr double unitsPerMetre = 1000;

inline QPointF toUnits(const Vec2d& metres) {
    return {metres.x * unitsPerMetre, -metres.y * unitsPerMetre};
}
inline Vec2d toMetres(const QPointF& units) {
    return {units.x() / unitsPerMetre, -units.y() / unitsPerMetre};
}
inline QRectF toUnits(const Vec2d& lowerLeft, const Vec2d& upperRight) {
    return QRectF(toUnits({lowerLeft.x, upperRight.y}), toUnits({upperRight.x, lowerLeft.y}));
}

// For as long as it lives the painter works in pixels, and lines and letters keep their size at any zoom.
class Pixels {
public:
    explicit Pixels(QPainter& painter)
        : m_painter(painter)
        , m_transform(painter.worldTransform()) {
        painter.save();
        painter.resetTransform();
    }
    ~Pixels() { m_painter.restore(); }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;

    QPointF at(const Vec2d& metres) const { return m_transform.map(toUnits(metres)); }
    QRectF rect(const Vec2d& lowerLeft, const Vec2d& upperRight) const {
        return m_transform.mapRect(toUnits(lowerLeft, upperRight));
    }
    double length(double metres) const { return metres * unitsPerMetre * m_transform.m11(); }
    Vec2d metres(const QPointF& pixel) const { return toMetres(m_transform.inverted().map(pixel)); }

private:
    QPainter& m_painter;
    QTransform m_transform;
};

} // namespace thetalane

// Where a view looks: the point in its middle and its scale.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace thetalane {

struct Camera {
    QPointF centre;   // [units]
    double scale = 1; // [px/unit]
};

// Shows all of `rect` [units] in a viewport of `size`, `margin` free on each side [px].
Camera cameraFor(const QRectF& rect, const QSizeF& size, double margin);

// t from 0 to 1; the scale changes by equal factors in equal times, as a zoom should look.
Camera between(const Camera& from, const Camera& to, double t);

} // namespace thetalane

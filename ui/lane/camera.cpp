#include "ui/lane/camera.h"

#include <algorithm>
#include <cmath>

namespace thetalane {

Camera cameraFor(const QRectF& rect, const QSizeF& size, double margin) {
    const double width = std::max(size.width() - 2 * margin, 40.0);
    const double height = std::max(size.height() - 2 * margin, 40.0);
    const double scale =
        std::min(width / std::max(rect.width(), 1e-9), height / std::max(rect.height(), 1e-9));
    return {rect.center(), scale};
}

Camera between(const Camera& from, const Camera& to, double t) {
    const double scale = from.scale * std::pow(to.scale / from.scale, t);
    // The centre moves with the width of what is seen, so that the target does not leave the view on the way.
    const double span = 1 / to.scale - 1 / from.scale;
    const double s = std::abs(span) * from.scale > 1e-3 ? (1 / scale - 1 / from.scale) / span : t;
    return {from.centre + (to.centre - from.centre) * s, scale};
}

} // namespace thetalane

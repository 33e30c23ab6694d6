// What lies under the bodies: a plain floor with a grid and walls, or the lane.
#pragma once

#include "core/scene/scene.h"
#include "ui/appearance.h"

#include <QPainter>
#include <QRectF>

namespace thetalane {

// 1, 2 or 5 times a power of ten: the largest that is not above `most`.
double roundLength(double most);

// What of a scene paintFloor() paints: alike for two scenes, and so is their floor.
Scene floorOf(const Scene& scene);

// Paints everything inside `exposed` [units]; the painter has the view's transform.
void paintFloor(QPainter& painter, const Scene& scene, const Appearance& appearance, const QRectF& exposed);

// A bar with its length in metres, its lower left corner at `corner` [px].
void paintScaleBar(QPainter& painter, double pixelsPerMetre, const QPointF& corner,
                   const Appearance& appearance);

// The arrow of a round speed [m/s] beside it, in the scale of the arrows on the lane [px/(m/s)].
void paintSpeedScale(QPainter& painter, double pixelsPerSpeed, const QPointF& corner,
                     const Appearance& appearance);

} // namespace thetalane

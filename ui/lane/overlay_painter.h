// Paints a StepOverlay over the lane.
#pragma once

#include "ui/appearance.h"
#include "ui/lane/step_overlay.h"

#include <QPainter>

#include <vector>

namespace thetalane {

// The painter has the view's transform; `area` is the viewport [px]; `keepOut` are places of other widgets.
// Returns where the labels are, and the arrows, for whoever wants to know what covers what.
struct OverlayPlaces {
    std::vector<QRectF> labels;
    std::vector<QLineF> arrows;
};
OverlayPlaces paintOverlay(QPainter& painter, const StepOverlay& overlay, const Scene& scene,
                           const Appearance& appearance, const QRectF& area,
                           const std::vector<QRectF>& keepOut);

} // namespace thetalane

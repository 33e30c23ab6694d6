// The floor under a view: a picture of it while the view stands still, painted straight while it moves.
#pragma once

#include "core/scene/scene.h"
#include "ui/appearance.h"

#include <QPainter>
#include <QPixmap>
#include <QTransform>
#include <QWidget>

namespace thetalane {

class FloorPicture {
public:
    void forget() { m_stands = false; } // another floor, or another look

    // The painter has the view's transform; `exposed`: of the viewport [px].
    void paint(QPainter& painter, const QWidget& viewport, const QRegion& exposed, const Scene& scene,
               const Appearance& appearance);

private:
    bool m_stands = false; // painted once already
    QTransform m_transform;
    QSize m_size; // [px]
    double m_ratio = 0;
    QPixmap m_picture; // null: not yet worth it
};

} // namespace thetalane

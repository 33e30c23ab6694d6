// An arrow in pixels, and what a mixed colour is.
#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>

namespace thetalane {

struct ArrowStyle {
    QColor colour;
    double width = 2;    // [px]
    bool dashed = false; // and then the head is open
};

// The head keeps its shape, and shrinks where the arrow is shorter than the head would be.
void paintArrow(QPainter& painter, const QPointF& from, const QPointF& to, const ArrowStyle& style);

// `share` of `over` on top of `under`; opaque.
QColor mixed(const QColor& over, const QColor& under, double share);
QColor faded(QColor colour, double opacity);

} // namespace thetalane

// Labels of a constant size in pixels, put where they cover neither an arrow nor each other.
#pragma once

#include "ui/appearance.h"
#include "ui/lane/step_overlay.h"

#include <QLineF>
#include <QPainter>
#include <QRectF>

#include <vector>

namespace thetalane {

QSizeF labelSize(const OverlayLabel& label, const Appearance& appearance, Appearance::Size textSize);
void paintLabel(QPainter& painter, const QRectF& rect, const OverlayLabel& label, const QColor& colour,
                const Appearance& appearance, Appearance::Size textSize);

// Keeps what is taken, in pixels.
class LabelLayout {
public:
    explicit LabelLayout(const QRectF& area)
        : m_area(area) {}

    void avoid(const QLineF& line) { m_lines.push_back(line); }
    void avoid(const QRectF& rect) { m_taken.push_back(rect); }
    void avoidSoftly(const QPointF& centre, double radius) { m_discs.push_back({centre, radius}); }

    // The best free place for a label about `anchor`, rather in the direction `away` from it.
    QRectF place(const QSizeF& size, const QPointF& anchor, const QPointF& away);

    // For a name that stays in its disc.
    QRectF placeInside(const QSizeF& size, const QPointF& centre, double radius, const QPointF& away);

    const std::vector<QRectF>& taken() const { return m_taken; }

private:
    struct Circle {
        QPointF centre;
        double radius;
    };
    double cost(const QRectF& rect) const;

    QRectF m_area;
    std::vector<QLineF> m_lines;
    std::vector<QRectF> m_taken;
    std::vector<Circle> m_discs;
};

} // namespace thetalane

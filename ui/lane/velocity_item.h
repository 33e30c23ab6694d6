// The velocities as arrows from the bodies' centres, all to one scale.
#pragma once

#include "core/timeline/timeline.h"
#include "ui/appearance.h"

#include <QGraphicsItem>

#include <vector>

namespace thetalane {

class VelocityItem : public QGraphicsItem {
public:
    VelocityItem(const Appearance& appearance, const std::vector<BodyState>& states);

    // metresPerSpeed: length of 1 m/s [m/(m/s)]; slowest: below it there is no arrow [m/s].
    void setUp(const std::vector<Body>& bodies, std::vector<Ink> inks, double metresPerSpeed, double slowest,
               const QRectF& bounds);

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    const Appearance& m_appearance;
    const std::vector<BodyState>& m_states; // the scene's, at the present time
    std::vector<double> m_radii;            // [m]
    std::vector<Ink> m_inks;
    double m_metresPerSpeed = 0;
    double m_slowest = 0;
    QRectF m_bounds;
};

} // namespace thetalane

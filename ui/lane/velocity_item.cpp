#include "ui/lane/velocity_item.h"

#include "ui/lane/arrow.h"
#include "ui/lane/scale.h"

namespace thetalane {
namespace {

constexpr double shortest = 7; // [px] a shorter arrow is a smudge

} // namespace

VelocityItem::VelocityItem(const Appearance& appearance, const std::vector<BodyState>& states)
    : m_appearance(appearance)
    , m_states(states) {
    setZValue(3);
}

void VelocityItem::setUp(const std::vector<Body>& bodies, std::vector<Ink> inks, double metresPerSpeed,
                         double slowest, const QRectF& bounds) {
    prepareGeometryChange();
    m_radii.clear();
    for (const Body& body : bodies)
        m_radii.push_back(body.radius);
    m_inks = std::move(inks);
    m_metresPerSpeed = metresPerSpeed;
    m_slowest = slowest;
    m_bounds = bounds;
}

void VelocityItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const Pixels pixels(*painter);
    for (std::size_t i = 0; i < m_states.size() && i < m_inks.size(); ++i) {
        const BodyState& state = m_states[i];
        const double speed = norm(state.velocity);
        if (speed < m_slowest || pixels.length(speed * m_metresPerSpeed) < shortest)
            continue;
        const bool plain = m_inks[i] == Ink::Plain;
        QColor colour = plain ? m_appearance.text() : m_appearance.textInk(m_inks[i]);
        if (state.place != Place::Play)
            colour = faded(colour, 0.42);
        // From the rim on: its length is the speed's, and the body's name stays free.
        const Vec2d rim = state.position + state.velocity * (m_radii[i] / speed);
        paintArrow(*painter, pixels.at(rim), pixels.at(rim + state.velocity * m_metresPerSpeed),
                   {colour, m_appearance.lineWidth(), false});
    }
}

} // namespace thetalane

#include "ui/lane/lasting_item.h"

#include "ui/lane/scale.h"

#include <algorithm>

namespace thetalane {
namespace {

Vec2d intoWall(Side side) {
    switch (side) {
    case Side::Left:
        return {-1, 0};
    case Side::Right:
        return {1, 0};
    case Side::Bottom:
        return {0, -1};
    case Side::Top:
        break;
    }
    return {0, 1};
}

} // namespace

std::vector<LastingContact> lastingAt(std::span<const LastingContact> contacts, double time) {
    std::vector<LastingContact> now;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(now),
                 [time](const LastingContact& c) { return c.from <= time && time < c.to; });
    return now;
}

LastingItem::LastingItem(const Appearance& appearance)
    : m_appearance(appearance) {
    setZValue(4); // over the bodies
}

void LastingItem::setUp(const Run& run, const QRectF& bounds) {
    prepareGeometryChange();
    m_contacts = run.timeline.lastingContacts();
    m_scene = &run.scene;
    m_bounds = bounds;
    m_marks.clear();
}

void LastingItem::setTime(double time, std::span<const BodyState> states) {
    if (m_contacts.empty() && m_marks.empty())
        return;
    m_marks.clear();
    for (const LastingContact& c : lastingAt(m_contacts, time)) {
        const Vec2d from = states[std::size_t(c.first)].position;
        const double radius = m_scene->bodies[std::size_t(c.first)].radius;
        if (c.second < 0) {
            const Vec2d along = intoWall(c.side);
            m_marks.push_back({from + along * radius, along, radius});
            continue;
        }
        const Vec2d way = states[std::size_t(c.second)].position - from;
        const double length = norm(way);
        if (length == 0)
            continue;
        const double other = m_scene->bodies[std::size_t(c.second)].radius;
        const Vec2d along = way * (1 / length);
        m_marks.push_back({from + along * radius, along, std::min(radius, other)});
    }
    update();
}

void LastingItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const Pixels pixels(*painter);
    const double wide = m_appearance.lineWidth();
    for (const Mark& mark : m_marks) {
        const QPointF at = pixels.at(mark.contact);
        const QPointF along(mark.along.x, -mark.along.y);
        const QPointF across(-along.y(), along.x());
        const double radius = pixels.length(mark.reach);
        if (radius < 2.5 * wide)
            continue; // on the strip it would cover both
        const double half = std::clamp(radius * 0.7, 3.0 * wide, 12.0 * wide);
        // Light beneath, so that it is seen on any colour.
        for (const auto& [colour, width] :
             {std::pair{m_appearance.card(), 2.5 * wide}, {m_appearance.textInk(Ink::Triangle), wide}}) {
            painter->setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            for (const double side : {-1.1 * wide, 1.1 * wide})
                painter->drawLine(at + along * side - across * half, at + along * side + across * half);
        }
    }
}

} // namespace thetalane

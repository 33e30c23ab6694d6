// Where two bodies, or a body and a wall, stay pressed together: a pair of short lines across the contact.
#pragma once

#include "core/engine/engine.h"
#include "ui/appearance.h"

#include <QGraphicsItem>

#include <span>
#include <vector>

namespace thetalane {

class LastingItem : public QGraphicsItem {
public:
    explicit LastingItem(const Appearance& appearance);

    void setUp(const Run& run, const QRectF& bounds); // the run outlives the item's use of it
    void setTime(double time, std::span<const BodyState> states);

    struct Mark {
        Vec2d contact; // [m]
        Vec2d along;   // unit, from one centre to the other
        double reach;  // of the smaller body [m]
    };
    const std::vector<Mark>& marks() const { return m_marks; }

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    const Appearance& m_appearance;
    std::span<const LastingContact> m_contacts;
    const Scene* m_scene = nullptr;
    std::vector<Mark> m_marks;
    QRectF m_bounds;
};

// The contacts that last at a time.
std::vector<LastingContact> lastingAt(std::span<const LastingContact> contacts, double time);

} // namespace thetalane

// Where the bodies have been, and where they will go.
#pragma once

#include "core/engine/engine.h"
#include "ui/appearance.h"

#include <QGraphicsItem>
#include <QLineF>
#include <QRect>

#include <span>
#include <vector>

namespace thetalane {

class PathsItem : public QGraphicsItem {
public:
    explicit PathsItem(const Appearance& appearance);

    // Turns every body's path into points, once a run. `inks`: a colour for each body.
    void build(const Run& run, double until, std::vector<Ink> inks);
    void setTime(double time, std::span<const BodyState> states);
    void setReceding(bool receding);

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    struct Path {
        std::vector<QPointF> points; // [units]
        std::vector<double> times;   // [s]
        Ink ink = Ink::Plain;
        bool pin = false;
        bool moving = false;
        std::size_t next = 0; // the first point that is still to come
        QPointF now;
    };
    void collectWalked(const Path& path, const QTransform& toPixels);
    void collectToCome(const Path& path, const QTransform& toPixels, const QRectF& area);
    void addDots(const QLineF& line, const QRectF& area);

    const Appearance& m_appearance;
    std::vector<Path> m_paths;
    std::vector<QLineF> m_lines; // kept from frame to frame [px]
    std::vector<QRect> m_dots;
    QRectF m_bounds;
    bool m_receding = false;
};

} // namespace thetalane

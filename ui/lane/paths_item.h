// Where the bodies have been, and where they will go.
#pragma once

#include "core/engine/engine.h"
#include "ui/appearance.h"

#include <QGraphicsItem>
#include <QLineF>
#include <QRect>
#include <QTransform>

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
    void setFutureHidden(bool hidden);

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

    // What is drawn of a body's way so far, in pixels: for tests.
    std::vector<QLineF> walkedLines(std::size_t body, const QTransform& toPixels);

private:
    // p(t) is at most quadratic, so a stretch is a Bézier curve of three points, and no chord.
    struct Stretch {
        double start = 0; // [s]
        double end = 0;
        QPointF from, control, to; // [units]

        Stretch part(double a, double b) const; // of the time between, 0 to 1
    };
    struct Path {
        std::vector<Stretch> stretches;
        Ink ink = Ink::Plain;
        bool pin = false;
        bool moving = false;
        std::size_t next = 0; // the first stretch that is yet to come
        double share = 0;     // how much of the one before it has passed, 0 to 1
    };
    void collectWalked(const Path& path, const QTransform& toPixels);
    void collectToCome(const Path& path, const QTransform& toPixels, const QRectF& area);
    void flatten(const Stretch& stretch, const QTransform& toPixels); // onto m_lines
    void addDots(const QRectF& area);                                 // along m_lines

    const Appearance& m_appearance;
    std::vector<Path> m_paths;
    std::vector<QLineF> m_lines; // kept from frame to frame [px]
    std::vector<QRect> m_dots;
    QRectF m_bounds;
    bool m_receding = false;
    bool m_futureHidden = false;
    bool m_lane = false;
};

} // namespace thetalane

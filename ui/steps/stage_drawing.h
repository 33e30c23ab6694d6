// How the figure of a stage is put together: where the discs lie, how long the arrows are, what is drawn.
#pragma once

#include "ui/steps/step_figure.h"

namespace thetalane {

// The scene's y is up, the screen's down.
inline QPointF flipped(const Vec2d& v) {
    return {v.x, -v.y};
}

inline QColor faint(QColor color, float alpha = 0.35f) {
    color.setAlphaF(alpha);
    return color;
}

QRectF boundsOf(const std::vector<QPointF>& points);

// Draws one stage. Discs and vectors have scales of their own; the vectors' is the same for all stages.
class StageDrawing {
public:
    // `pass`: the collision itself, and those resolved together with it.
    StageDrawing(const Scene& scene, const Collision& collision, std::span<const Collision> pass,
                 const Appearance& appearance, QSizeF size);

    FigureCanvas draw(Stage stage);

private:
    struct Party {
        int body;
        Ink ink;
        Vec2d before, rotated, exchanged, after;
        double mass;
        double radius;
        QPointF centre; // pixels, the contact at (0, 0)
    };

    void contact();
    void split();
    void rotation();
    void exchange();
    void rotationBack();
    void momentum();

    void place(double discPixels);
    void fitVectors();
    void centreOn(const std::vector<QPointF>& points);
    std::vector<QPointF> discPoints() const;
    std::vector<Vec2d> vectorsOf(Stage stage, const Party& p) const;
    std::vector<QPointF> extent(Stage stage, double scale) const;
    void bodies();
    void others();
    void wall();
    void axes(bool faintly);
    void scaleArrow(double pixelsPerUnit, const char* unitText);
    void velocity(const Party& p, const Vec2d& v, When when, bool faintly = false);
    void components(const Party& p, const Vec2d& v, When when);
    void symbolAt(const Party& p, const QString& axis, When when, QPointF from, QPointF to,
                  QPointF side = {});
    void resting(const Party& p, When when);
    QPointF at(const Party& p) const { return m_origin + p.centre; }
    QPointF turned(const Vec2d& v) const { return m_along * v.x + m_across * v.y; }

    const Scene& m_scene;
    const Collision& m_collision;
    std::span<const Collision> m_pass;
    const PairCollision<double>& m_s;
    const Appearance& m_appearance;
    FigureCanvas m_canvas;
    QPointF m_along;  // x′ on the screen
    QPointF m_across; // y′ on the screen
    double m_wide;
    QRectF m_room;
    QPointF m_origin;   // where the contact is
    double m_metre = 1; // pixels
    double m_speed = 1; // pixels a m/s
    std::vector<Party> m_parties;
};

} // namespace thetalane

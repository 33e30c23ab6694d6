// The momenta of a collision tip to tail, before and after, each with the total, all to one scale. The first
// body's arrows are solid, the second's dashed with an open head, others dotted; the total is broad.
#pragma once

#include "core/engine/engine.h"
#include "ui/steps/figure_canvas.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace thetalane {

struct MomentumDrawing {
    FigureCanvas canvas;
    QPointF before, after; // where the two chains begin
    QRectF beforeArea, afterArea;
    double scale = 0; // pixels a kg·m/s
};
MomentumDrawing momentumDrawing(const Scene& scene, std::span<const Collision> collisions, std::size_t index,
                                const Appearance& appearance, QSizeF size);

class MomentumFigure : public QWidget {
    Q_OBJECT
public:
    explicit MomentumFigure(const Appearance& appearance, QWidget* parent = nullptr);

    // The run is kept, so that the collision in it stays valid; null: nothing to draw.
    void setCollision(std::shared_ptr<const Run> run, std::size_t collision);
    const std::optional<MomentumDrawing>& drawing() const { return m_drawing; }

    void retranslate();
    QSize sizeHint() const override { return {320, 320}; }
    QSize minimumSizeHint() const override { return {240, 220}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    const Appearance& m_appearance;
    std::shared_ptr<const Run> m_run;
    std::size_t m_collision = 0;
    std::optional<MomentumDrawing> m_drawing;
};

} // namespace thetalane

// The picture of one step, drawn from the real vectors, all steps of a collision to one scale.
#pragma once

#include "core/engine/engine.h"
#include "ui/steps/figure_canvas.h"
#include "ui/words/instant.h"
#include "ui/words/worked_steps.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace thetalane {

// The figure of a stage on a canvas of that size. The scene gives the letters, the collision the vectors; the
// others of its pass are there too, quietly.
FigureCanvas stageFigure(const Scene& scene, std::span<const Collision> collisions, std::size_t index,
                         Stage stage, const Appearance& appearance, QSizeF size);

class StepFigure : public QWidget {
    Q_OBJECT
public:
    StepFigure(const Appearance& appearance, Stage stage, QWidget* parent = nullptr);

    // The run is kept, so that the collision in it stays valid.
    void setCollision(std::shared_ptr<const Run> run, std::size_t collision);

    // At most so high [px], so that the formulas below it are seen without scrolling.
    void setMostHeight(int most) { m_mostHeight = most; }

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    void retranslate();

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent* event) override;

private:
    const Appearance& m_appearance;
    Stage m_stage;
    std::shared_ptr<const Run> m_run;
    std::size_t m_collision = 0;
    int m_mostHeight = QWIDGETSIZE_MAX;
    std::optional<FigureCanvas> m_canvas; // as last drawn; placing the labels takes its time
};

} // namespace thetalane

// The way of the centre of mass among the bodies, seen from above: solid as far as it has come, dotted where
// it goes.
#pragma once

#include "core/timeline/history.h"
#include "ui/appearance.h"

#include <QWidget>

#include <memory>

namespace thetalane {

struct Run;

class CentreFigure : public QWidget {
    Q_OBJECT
public:
    explicit CentreFigure(const Appearance& appearance, QWidget* parent = nullptr);

    void setRun(std::shared_ptr<const Run> run, History history); // of the part shown
    void setTime(double time);                                    // [s]

    QPointF at(const Vec2d& metres) const; // pixels
    void retranslate();
    QSize sizeHint() const override { return {320, 260}; }
    QSize minimumSizeHint() const override { return {240, 160}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void findExtent();
    QRectF room() const;
    double scale() const; // pixels a metre
    void paintBodies(QPainter& painter) const;
    void paintPath(QPainter& painter, const Vec2d& now) const;
    void paintScale(QPainter& painter) const;

    const Appearance& m_appearance;
    std::shared_ptr<const Run> m_run;
    History m_history;
    double m_time = 0;
    std::vector<BodyState> m_states; // now
    Vec2d m_low, m_high;             // of everything that is seen [m]
};

} // namespace thetalane

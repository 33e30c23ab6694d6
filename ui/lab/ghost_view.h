// One throw as every method computed it, over the lane: the truth as quiet discs, each ghost in its own
// colour and line, and a mark where it leaves the truth.
#pragma once

#include "ui/appearance.h"
#include "ui/lab/run_lab.h"
#include "ui/plot/study_plot.h"

#include <QTransform>
#include <QWidget>

namespace thetalane {

class GhostView : public QWidget {
    Q_OBJECT
public:
    explicit GhostView(const Appearance& appearance, QWidget* parent = nullptr);

    // Null: nothing yet.
    void show(std::shared_ptr<const LabResult> result);
    using QWidget::show;
    void setTime(double time); // [s]
    double time() const { return m_time; }
    void setLit(std::optional<std::size_t> ghost); // an index into Ghosts::all
    void setWords(const QString& name, const QString& empty);

    // Where the mark of a ghost is [px]; nothing if it never leaves the truth.
    std::optional<QPointF> markAt(std::size_t ghost) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, 160}; }

signals:
    void picked(std::size_t ghost); // its mark was clicked

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    const Ghosts* ghosts() const { return m_result ? m_result->ghosts.get() : nullptr; }
    MethodStyle styleOf(std::size_t ghost) const;
    QTransform transform() const; // from units to pixels
    std::optional<std::size_t> markUnder(const QPointF& where) const;
    void paintTruth(QPainter& painter) const;
    void paintGhost(QPainter& painter, std::size_t ghost) const;
    void paintMark(QPainter& painter, std::size_t ghost) const;

    const Appearance& m_appearance;
    std::shared_ptr<const LabResult> m_result;
    std::vector<int> m_bodies; // that are drawn; of a crowd not all
    std::optional<std::size_t> m_lit;
    double m_time = 0;
    QString m_empty;
};

} // namespace thetalane

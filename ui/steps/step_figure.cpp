#include "ui/steps/step_figure.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace thetalane {

StepFigure::StepFigure(const Appearance& appearance, Stage stage, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_stage(stage) {
    setObjectName(QStringLiteral("stepFigure%1").arg(int(stage)));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] {
        m_canvas.reset();
        updateGeometry();
        update();
    });
    retranslate();
}

void StepFigure::setCollision(std::shared_ptr<const Run> run, std::size_t collision) {
    m_run = std::move(run);
    m_collision = collision;
    m_canvas.reset();
    update();
}

int StepFigure::heightForWidth(int width) const {
    const int em = m_appearance.pixels(Appearance::Size::Normal);
    const int wanted = std::clamp(width * 55 / 100, 16 * em, 21 * em);
    return std::min(wanted, std::max(m_mostHeight, 9 * em)); // lower, its labels would not find room
}

QSize StepFigure::sizeHint() const {
    return {320, heightForWidth(320)};
}

QSize StepFigure::minimumSizeHint() const {
    return {200, sizeHint().height()};
}

void StepFigure::retranslate() {
    setAccessibleName(tr("Figure: %1").arg(stageTitle(m_stage)));
}

void StepFigure::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void StepFigure::paintEvent(QPaintEvent*) {
    if (!m_run || m_collision >= m_run->timeline.collisions().size())
        return;
    if (!m_canvas || m_canvas->size() != QSizeF(size()))
        m_canvas.emplace(stageFigure(m_run->scene, m_run->timeline.collisions(), m_collision, m_stage,
                                     m_appearance, size()));
    QPainter painter(this);
    m_canvas->paint(painter);
}

} // namespace thetalane

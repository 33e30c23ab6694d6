#include "ui/lane/lane_panel.h"

#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_strip.h"
#include "ui/lane/lane_view.h"
#include "ui/lane/pin_badge.h"
#include "ui/lane/zoom_buttons.h"

#include <QHBoxLayout>

namespace thetalane {

LanePanel::LanePanel(const Context& context, QWidget* parent)
    : QWidget(parent)
    , m_scene(new LaneScene(context, this))
    , m_view(new LaneView(context, *m_scene, this))
    , m_strip(new LaneStrip(context, *m_scene, *m_view, this))
    , m_badge(new PinBadge(context, m_view)) {
    setObjectName("lanePanel");
    m_view->setObjectName("laneView");
    setFocusProxy(m_view);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    m_strip->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    layout->addWidget(m_strip);
    layout->addWidget(m_view, 1);

    auto* buttons = new ZoomButtons(*m_view, context.appearance);
    m_view->addToCorner(buttons, Qt::BottomRightCorner);
    m_view->addToCorner(m_badge, Qt::TopLeftCorner);
    connect(buttons, &ZoomButtons::resized, m_view, &LaneView::placeCorners);
    connect(m_badge, &PinBadge::resized, m_view, &LaneView::placeCorners);
    connect(m_scene, &LaneScene::rebuilt, this, &LanePanel::adoptRun);
    adoptRun();
}

void LanePanel::adoptRun() {
    m_strip->setVisible(m_scene->run().scene.lane.has_value());
}

void LanePanel::setReducedMotion(bool reduced) {
    m_view->setReducedMotion(reduced);
}
void LanePanel::fit() {
    m_view->fit();
}
void LanePanel::zoomIn() {
    m_view->zoomIn();
}
void LanePanel::zoomOut() {
    m_view->zoomOut();
}

} // namespace thetalane

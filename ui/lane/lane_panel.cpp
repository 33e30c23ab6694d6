#include "ui/lane/lane_panel.h"

#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_strip.h"
#include "ui/lane/lane_view.h"
#include "ui/lane/pin_badge.h"
#include "ui/lane/zoom_buttons.h"

#include <QHBoxLayout>
#include <QSettings>

#include <algorithm>

namespace thetalane {
namespace {

const char* const followKey = "lane/follow";

} // namespace

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

    m_buttons = new ZoomButtons(*m_view, context.appearance);
    // What was chosen; a hand on the camera is of the moment.
    connect(m_buttons, &ZoomButtons::followChosen, this,
            [](bool on) { QSettings().setValue(followKey, on); });
    m_view->addToCorner(m_buttons, Qt::BottomRightCorner);
    m_view->addToCorner(m_badge, Qt::TopLeftCorner);
    connect(m_buttons, &ZoomButtons::resized, m_view, &LaneView::placeCorners);
    connect(m_badge, &PinBadge::resized, m_view, &LaneView::placeCorners);
    connect(m_scene, &LaneScene::rebuilt, this, &LanePanel::adoptRun);
    adoptRun();
}

void LanePanel::adoptRun() {
    const bool lane = m_scene->run().scene.lane.has_value();
    m_strip->setVisible(lane);
    m_buttons->setLane(lane);
}

void LanePanel::addTool(LaneTool& tool) {
    m_tools.push_back(&tool);
    m_view->addTool(tool);
    m_strip->addTool(tool);
    connect(&tool, &LaneTool::changed, this, &LanePanel::showArrows);
    showArrows();
}

void LanePanel::showArrows() {
    m_scene->setArrows(
        std::none_of(m_tools.begin(), m_tools.end(), [](const LaneTool* t) { return t->drawsVelocities(); }));
}

void LanePanel::restoreChoices() {
    m_view->setFollowing(QSettings().value(followKey, false).toBool());
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

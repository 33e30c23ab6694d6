// The cameras of a lane: with the ball down to the rack, the pins alone, and where one aims.
#include "ui/lane/extent.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"

#include <algorithm>
#include <cmath>

namespace thetalane {

bool LaneView::hasLane() const {
    return m_scene.run().scene.lane.has_value();
}

// A picture of where the ball is and of nothing else: the same at each time, forward and back, at any rate.
// At first the view is the foul line's and goes along; on the last half of the way it closes in on the rack,
// and the ball moves from below into the middle.
Camera LaneView::followCamera() const {
    constexpr double closesIn = 0.5;
    const Run& run = m_scene.run();
    const Camera rack = fitCamera();
    if (m_scene.states().empty() || !run.scene.lane)
        return rack;
    const double start = toUnits({0, run.scene.lane->foulLine}).y();
    const double ball = toUnits(m_scene.states().front().position).y(); // the first body is what was thrown
    const double left = std::clamp((ball - rack.centre.y()) / (start - rack.centre.y()), 0.0, 1.0);
    if (left == 0)
        return rack; // once at the pins it stays with them
    const Camera home = cameraFor(foulLineRect(run), viewport()->size(), 0);
    const double share = std::min(left / closesIn, 1.0);
    const double scale = rack.scale * std::pow(home.scale / rack.scale, share);
    const double below = (home.centre.y() - start) * home.scale * share; // [px]
    return {{rack.centre.x(), ball + below / scale}, scale};
}

Camera LaneView::cameraOf(Aim aim) const {
    switch (aim) {
    case Aim::Fit:
        return fitCamera();
    case Aim::Pair:
        if (const Collision* collision = m_scene.selected())
            return cameraFor(pairRect(*collision), viewport()->size(), 0);
        return fitCamera();
    case Aim::Follow:
        return followCamera();
    case Aim::Free:
        break;
    }
    return m_camera;
}

void LaneView::follow() {
    if (m_aim == Aim::Follow && hasLane() && m_flight.state() != QVariantAnimation::Running)
        setCamera(followCamera());
    else if (m_aim == Aim::Follow && hasLane())
        m_to = followCamera(); // it flies to where the ball will be
}

void LaneView::setFollowing(bool on) {
    if (on == m_follow)
        return;
    m_follow = on;
    if (on && hasLane() && !m_scene.selected())
        flyTo(followCamera(), Aim::Follow);
    else if (on && m_beforeSelection)
        m_beforeSelection->first = Aim::Follow;
    else if (!on && m_aim == Aim::Follow)
        m_aim = Aim::Free;
    emit followingChanged(on);
}

void LaneView::showRack() {
    if (hasLane())
        flyToRect(thetalane::rackRect(m_scene.run()));
}

void LaneView::showFoulLine() {
    if (hasLane())
        flyToRect(foulLineRect(m_scene.run()));
}

} // namespace thetalane

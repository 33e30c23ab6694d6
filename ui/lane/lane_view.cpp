#include "ui/lane/lane_view.h"

#include "ui/lane/extent.h"
#include "ui/lane/floor.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/scale.h"

#include <QResizeEvent>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr int flightTime = 300; // [ms]
constexpr double buttonZoom = 1.4;
constexpr int cornerGap = 12;

} // namespace

LaneView::LaneView(const Context& context, LaneScene& scene, QWidget* parent)
    : FloorView(context, scene, parent) {
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setCursor(Qt::OpenHandCursor);

    for (QVariantAnimation* animation : {&m_flight, &m_turning}) {
        animation->setStartValue(0.0);
        animation->setEndValue(1.0);
        animation->setDuration(flightTime);
        animation->setEasingCurve(QEasingCurve::InOutCubic);
    }
    connect(&m_flight, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& t) { setCamera(between(m_from, m_to, t.toDouble())); });
    connect(&m_turning, &QVariantAnimation::valueChanged, this, &LaneView::touch);
    connect(&scene, &LaneScene::rebuilt, this, &LaneView::adoptRun);
    connect(&context.playhead, &Playhead::selectionChanged, this, &LaneView::showSelection);
    connect(&context.playhead, &Playhead::stageChanged, this, &LaneView::showStage);
    connect(&context.playhead, &Playhead::timeChanged, this, &LaneView::follow);
    connect(&context.appearance, &Appearance::changed, this, &LaneView::placeCorners);
    connect(this, &LaneView::gripped, this, [this](bool on) {
        if (!on && m_aim == Aim::Fit)
            flyTo(fitCamera(), Aim::Fit);
    });
    adoptRun();
    retranslate();
}

// Another run of the same scene (a dial was turned) keeps a view that was chosen by hand.
void LaneView::adoptRun() {
    if (m_flight.state() == QVariantAnimation::Running) {
        m_flight.stop();
        setCamera(m_to);
    }
    m_turning.stop();
    takeFloor();
    if (m_beforeSelection) {
        m_aim = m_beforeSelection->first;
        setCamera(m_beforeSelection->second);
        m_beforeSelection.reset();
    }
    const QRectF whole = m_scene.wholeRect();
    const auto alike = [](double now, double before) { return now > 0.5 * before && now < 2 * before; };
    const bool other = !alike(whole.width(), m_whole.width()) || !alike(whole.height(), m_whole.height()) ||
                       !whole.contains(m_camera.centre);
    const bool held = m_hand.holds(); // nothing moves under the hand
    if (other && !held)
        m_aim = Aim::Fit;
    m_whole = whole;
    if (m_aim == Aim::Follow && !hasLane())
        m_aim = Aim::Fit;
    if (m_aim == Aim::Fit && m_follow && hasLane())
        m_aim = Aim::Follow;
    if (!held && (m_aim == Aim::Fit || m_aim == Aim::Follow))
        setCamera(cameraOf(m_aim));
    m_overlay.reset();
    showSelection();
}

void LaneView::showSelection() {
    if (m_scene.selected()) {
        if (!m_beforeSelection)
            m_beforeSelection = {m_aim, target()};
        flyTo(cameraOf(Aim::Pair), Aim::Pair);
    } else if (m_beforeSelection) {
        const auto [aim, before] = *m_beforeSelection;
        m_beforeSelection.reset();
        flyTo(aim == Aim::Free ? before : cameraOf(aim), aim);
    }
    m_overlay.reset();
    showStage();
}

void LaneView::showStage() {
    const Collision* collision = m_scene.selected();
    m_turning.stop();
    if (!collision) {
        m_overlay.reset();
        touch();
        return;
    }
    const bool turn = m_overlay && !m_context.appearance.reducedMotion();
    if (turn)
        m_previous = *m_overlay;
    m_overlay = stepOverlay(m_scene.run().scene, *collision, m_context.playhead.stage());
    if (turn)
        m_turning.start();
    touch();
}

QRectF LaneView::visibleRect() const {
    return viewportTransform().inverted().mapRect(QRectF(viewport()->rect()));
}

// Kept exactly, so that rounding does not add up.
void LaneView::setCamera(const Camera& camera) {
    m_camera = camera;
    look(camera);
    emit cameraChanged();
}

void LaneView::flyTo(const Camera& target, Aim aim) {
    m_flight.stop();
    m_aim = aim;
    m_to = target;
    if (m_context.appearance.reducedMotion() || !isVisible()) {
        setCamera(m_to);
        return;
    }
    m_from = m_camera;
    m_flight.start();
}

void LaneView::lookAt(const QPointF& centre) {
    m_flight.stop();
    setFollowing(false);
    m_aim = Aim::Free;
    setCamera({clampCentre(centre), m_camera.scale});
}

Camera LaneView::fitCamera() const {
    return cameraFor(m_scene.fitRect(), viewport()->size(), 4 * m_context.appearance.unit());
}

// From the whole scene to one body as large as the view.
double LaneView::clampScale(double scale) const {
    double smallest = 1e300;
    for (const Body& body : m_scene.run().scene.bodies)
        smallest = std::min(smallest, body.radius * unitsPerMetre);
    const double most = std::min(viewport()->width(), viewport()->height()) / (2 * smallest);
    const double least = 0.7 * cameraFor(m_scene.wholeRect(), viewport()->size(), 0).scale;
    return std::clamp(scale, least, std::max(most, 2 * least));
}

// Something is always in the middle.
QPointF LaneView::clampCentre(const QPointF& centre) const {
    const QRectF whole = m_scene.wholeRect();
    return {std::clamp(centre.x(), whole.left(), whole.right()),
            std::clamp(centre.y(), whole.top(), whole.bottom())};
}

void LaneView::zoomAbout(const QPointF& pixel, double factor) {
    m_flight.stop();
    setFollowing(false);
    const double scale = clampScale(m_camera.scale * factor);
    const QPointF middle = QRectF(viewport()->rect()).center();
    const QPointF held = m_camera.centre + (pixel - middle) / m_camera.scale;
    m_aim = Aim::Free;
    setCamera({clampCentre(held + (middle - pixel) / scale), scale});
}

void LaneView::flyToRect(const QRectF& units) {
    setFollowing(false);
    flyTo(cameraFor(units, viewport()->size(), 4 * m_context.appearance.unit()), Aim::Free);
}

void LaneView::addTool(LaneTool& tool) {
    m_hand.add(tool);
    connect(&tool, &LaneTool::changed, this, &LaneView::touch);
}

void LaneView::fit() {
    setFollowing(false);
    flyTo(fitCamera(), Aim::Fit);
}
void LaneView::zoomIn() {
    zoomAbout(QRectF(viewport()->rect()).center(), buttonZoom);
}
void LaneView::zoomOut() {
    zoomAbout(QRectF(viewport()->rect()).center(), 1 / buttonZoom);
}

void LaneView::resizeEvent(QResizeEvent* event) {
    FloorView::resizeEvent(event);
    placeCorners();
    m_flight.stop();
    setCamera(cameraOf(m_aim));
}

void LaneView::drawForeground(QPainter* painter, const QRectF&) {
    const QRectF area(viewport()->rect());
    std::vector<QRectF> keepOut = cornerRects();
    const double perMetre = painter->worldTransform().m11() * unitsPerMetre;
    const QPointF corner = area.bottomLeft() + QPointF(cornerGap, -cornerGap);
    keepOut.push_back({corner - QPointF(0, 40), QSizeF(240, 40)});
    if (m_overlay) {
        const bool turning = m_turning.state() == QVariantAnimation::Running;
        const StepOverlay turned =
            turning ? between(m_previous, *m_overlay, m_turning.currentValue().toDouble()) : StepOverlay{};
        m_places = paintOverlay(*painter, turning ? turned : *m_overlay, m_scene.run().scene,
                                m_context.appearance, area, keepOut);
    } else {
        m_places = {};
    }
    const Pixels pixels(*painter);
    m_hand.paint(*painter, pixels, area);
    paintScaleBar(*painter, perMetre, corner, m_context.appearance);
    const double metresPerSpeed = m_overlay ? m_overlay->metresPerSpeed : m_scene.metresPerSpeed();
    paintSpeedScale(*painter, perMetre * metresPerSpeed, corner + QPointF(130, 0), m_context.appearance);
}

void LaneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    FloorView::changeEvent(event);
}

void LaneView::retranslate() {
    setAccessibleName(tr("Lane"));
    setAccessibleDescription(
        tr("Drag to move, turn the wheel to zoom, click a body to open its next collision"));
    touchFloor(); // its words, and the overlay's, are of the other language
    m_overlay.reset();
    showStage();
}

void LaneView::addToCorner(QWidget* widget, Qt::Corner corner) {
    widget->setParent(this);
    m_corners.push_back({widget, corner});
    widget->raise();
    placeCorners();
}

void LaneView::placeCorners() {
    for (const auto& [widget, corner] : m_corners) {
        const QSize size = widget->sizeHint();
        const bool right = corner == Qt::TopRightCorner || corner == Qt::BottomRightCorner;
        const bool bottom = corner == Qt::BottomLeftCorner || corner == Qt::BottomRightCorner;
        widget->setGeometry(QRect(QPoint(right ? width() - size.width() - cornerGap : cornerGap,
                                         bottom ? height() - size.height() - cornerGap : cornerGap),
                                  size));
    }
}

std::vector<QRectF> LaneView::cornerRects() const {
    std::vector<QRectF> rects;
    for (const auto& corner : m_corners)
        if (!corner.widget->isHidden())
            rects.push_back(QRectF(corner.widget->geometry()).adjusted(-4, -4, 4, 4));
    return rects;
}

} // namespace thetalane

#include "ui/lane/lane_strip.h"

#include "ui/lane/arrow.h"
#include "ui/lane/camera.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QWheelEvent>

#include <cmath>

namespace thetalane {

LaneStrip::LaneStrip(const Context& context, LaneScene& scene, LaneView& closeUp, QWidget* parent)
    : QGraphicsView(&scene, parent)
    , m_context(context)
    , m_scene(scene)
    , m_closeUp(closeUp) {
    setObjectName("laneStrip");
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setRenderHint(QPainter::Antialiasing);
    setCacheMode(CacheBackground);
    setViewportUpdateMode(FullViewportUpdate);
    setTransformationAnchor(NoAnchor);
    setResizeAnchor(NoAnchor);
    setFocusPolicy(Qt::NoFocus); // it has nothing that the close-up's keys do not do
    viewport()->setCursor(Qt::PointingHandCursor);
    connect(&closeUp, &LaneView::cameraChanged, viewport(), qOverload<>(&QWidget::update));
    connect(&scene, &LaneScene::rebuilt, this, &LaneStrip::showAll);
    connect(&context.appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        showAll();
    });
    retranslate();
}

QSize LaneStrip::sizeHint() const {
    return {11 * m_context.appearance.unit(), 400};
}

void LaneStrip::showAll() {
    resetCachedContent();
    const Camera camera =
        cameraFor(m_scene.wholeRect(), viewport()->size(), 0.75 * m_context.appearance.unit());
    setTransform(QTransform::fromScale(camera.scale, camera.scale));
    const QPointF corner = camera.centre * camera.scale - QRectF(viewport()->rect()).center();
    horizontalScrollBar()->setValue(int(std::lround(corner.x())));
    verticalScrollBar()->setValue(int(std::lround(corner.y())));
}

QRectF LaneStrip::frameOfCloseUp() const {
    const QRectF seen = viewportTransform().mapRect(m_closeUp.visibleRect());
    return seen & QRectF(viewport()->rect()).adjusted(2, 2, -2, -2);
}

void LaneStrip::drawForeground(QPainter* painter, const QRectF&) {
    const QRectF frame = frameOfCloseUp();
    if (frame.isEmpty())
        return;
    painter->save();
    painter->resetTransform();
    painter->setPen(QPen(m_context.appearance.accent(), m_context.appearance.lineWidth()));
    painter->setBrush(faded(m_context.appearance.accent(), 0.08));
    painter->drawRoundedRect(frame, 3, 3);
    painter->restore();
}

void LaneStrip::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    showAll();
}

void LaneStrip::mousePressEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        m_closeUp.lookAt(viewportTransform().inverted().map(event->position()));
}

void LaneStrip::mouseMoveEvent(QMouseEvent* event) {
    mousePressEvent(event);
}

void LaneStrip::wheelEvent(QWheelEvent* event) {
    if (event->angleDelta().y() > 0)
        m_closeUp.zoomIn();
    else if (event->angleDelta().y() < 0)
        m_closeUp.zoomOut();
    event->accept();
}

void LaneStrip::keyPressEvent(QKeyEvent* event) {
    event->ignore();
}

void LaneStrip::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QGraphicsView::changeEvent(event);
}

void LaneStrip::retranslate() {
    setAccessibleName(tr("The whole lane"));
    setToolTip(tr("The whole lane; click where the close-up is to look"));
}

} // namespace thetalane

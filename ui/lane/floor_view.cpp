#include "ui/lane/floor_view.h"

#include "ui/lane/floor.h"
#include "ui/lane/lane_scene.h"

#include <QGraphicsItem>
#include <QPaintEvent>
#include <QScrollBar>
#include <QStyleOptionGraphicsItem>

#include <cmath>
#include <utility>

namespace thetalane {

FloorView::FloorView(const Context& context, LaneScene& scene, QWidget* parent)
    : QGraphicsView(&scene, parent)
    , m_context(context)
    , m_scene(scene) {
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(NoViewportUpdate); // no item knows its rectangle: see Changes
    setTransformationAnchor(NoAnchor);
    setResizeAnchor(NoAnchor);
    setMouseTracking(true);
    viewport()->setAutoFillBackground(false); // the floor covers it
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&scene, &LaneScene::touched, this, &FloorView::touch);
    connect(&context.appearance, &Appearance::changed, this, &FloorView::touchFloor);
}

void FloorView::touch() {
    if (std::exchange(m_touched, true))
        return;
    QMetaObject::invokeMethod(this, &FloorView::showChanges, Qt::QueuedConnection);
}

void FloorView::touchFloor() {
    m_picture.forget();
    moved();
}

void FloorView::moved() {
    m_moved = true;
    viewport()->update();
}

// While a ball is aimed, run after run has the same floor, and painting it anew would be most of a frame.
bool FloorView::takeFloor() {
    Scene floor = floorOf(m_scene.run().scene);
    if (floor == m_floor)
        return false;
    m_floor = std::move(floor);
    touchFloor();
    return true;
}

void FloorView::look(const Camera& camera) {
    const QTransform scale = QTransform::fromScale(camera.scale, camera.scale);
    if (scale != transform())
        moved();
    setTransform(scale);
    const QPointF corner = camera.centre * camera.scale - QRectF(viewport()->rect()).center();
    horizontalScrollBar()->setValue(int(std::lround(corner.x())));
    verticalScrollBar()->setValue(int(std::lround(corner.y())));
}

void FloorView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    moved();
}

void FloorView::scrollContentsBy(int dx, int dy) {
    QGraphicsView::scrollContentsBy(dx, dy);
    moved();
}

void FloorView::showChanges() {
    constexpr int mostItems = 100; // of a thousand discs all move, and looking for what changed is a waste
    m_touched = false;
    if (std::exchange(m_moved, false) || !isVisible() || scene()->items().size() > mostItems) {
        m_changes.forget();
        viewport()->update();
        return;
    }
    viewport()->update(m_changes.found(*viewport(), [this](QPainter& painter) { paintOver(painter); }));
}

// As QGraphicsView does it, of a scene whose items have no children.
void FloorView::paintOver(QPainter& painter) {
    painter.setRenderHints(renderHints());
    const QTransform view = viewportTransform();
    const QStyleOptionGraphicsItem option;
    for (QGraphicsItem* item : scene()->items(Qt::AscendingOrder)) {
        if (!item->isVisible())
            continue;
        painter.save();
        painter.setWorldTransform(item->sceneTransform() * view);
        item->paint(&painter, &option, nullptr);
        painter.restore();
    }
    painter.setWorldTransform(view);
    drawForeground(&painter, {});
}

void FloorView::paintEvent(QPaintEvent* event) {
    if (m_touched)
        m_changes.forget(event->region()); // it shows what is not noted yet
    m_exposed = event->region();
    QGraphicsView::paintEvent(event);
}

void FloorView::drawBackground(QPainter* painter, const QRectF&) {
    m_picture.paint(*painter, *viewport(), m_exposed, m_scene.run().scene, m_context.appearance);
}

} // namespace thetalane

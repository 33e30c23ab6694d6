#include "ui/lane/lane_strip.h"

#include "ui/lane/arrow.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace thetalane {

LaneStrip::LaneStrip(const Context& context, LaneScene& scene, LaneView& closeUp, QWidget* parent)
    : FloorView(context, scene, parent)
    , m_closeUp(closeUp) {
    setObjectName("laneStrip");
    setFocusPolicy(Qt::NoFocus); // it has nothing that the close-up's keys do not do
    viewport()->setCursor(Qt::PointingHandCursor);
    connect(&closeUp, &LaneView::cameraChanged, this, &LaneStrip::touch);
    connect(&scene, &LaneScene::rebuilt, this, &LaneStrip::adoptRun);
    connect(&context.appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        showAll();
    });
    retranslate();
}

QSize LaneStrip::sizeHint() const {
    return {11 * m_context.appearance.unit(), 400};
}

void LaneStrip::adoptRun() {
    if (takeFloor())
        showAll();
}

void LaneStrip::showAll() {
    look(cameraFor(m_scene.wholeRect(), viewport()->size(), 0.75 * m_context.appearance.unit()));
}

QRectF LaneStrip::frameOfCloseUp() const {
    const QRectF seen = viewportTransform().mapRect(m_closeUp.visibleRect());
    return seen & QRectF(viewport()->rect()).adjusted(2, 2, -2, -2);
}

void LaneStrip::drawForeground(QPainter* painter, const QRectF&) {
    const QRectF frame = frameOfCloseUp();
    const Pixels pixels(*painter);
    m_hand.paint(*painter, pixels, QRectF(viewport()->rect()));
    if (frame.isEmpty())
        return;
    painter->setPen(QPen(m_context.appearance.accent(), m_context.appearance.lineWidth()));
    painter->setBrush(faded(m_context.appearance.accent(), 0.08));
    painter->drawRoundedRect(frame, 3, 3);
}

void LaneStrip::resizeEvent(QResizeEvent* event) {
    FloorView::resizeEvent(event);
    showAll();
}

void LaneStrip::addTool(LaneTool& tool) {
    m_hand.add(tool);
    connect(&tool, &LaneTool::changed, this, &LaneStrip::touch);
}

Pointer LaneStrip::pointerAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const {
    constexpr double slack = 6; // [px]
    return {toMetres(viewportTransform().inverted().map(pixel)), slack / (transform().m11() * unitsPerMetre),
            modifiers};
}

void LaneStrip::lookThere(const QPointF& pixel) {
    m_closeUp.lookAt(viewportTransform().inverted().map(pixel));
}

void LaneStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_pressed = event->position();
    m_moved = false;
    if (m_hand.press(pointerAt(event->position(), event->modifiers())))
        emit m_closeUp.gripped(true);
    else
        lookThere(event->position());
}

void LaneStrip::mouseMoveEvent(QMouseEvent* event) {
    const Pointer pointer = pointerAt(event->position(), event->modifiers());
    if (m_hand.holds()) {
        m_moved = m_moved || event->position() != m_pressed;
        return m_hand.drag(pointer);
    }
    if (event->buttons() & Qt::LeftButton)
        return lookThere(event->position());
    const auto handle = m_hand.hover(pointer);
    viewport()->setCursor(handle ? handle->cursor : Qt::PointingHandCursor);
}

// A click on what could be dragged looks there, as a click anywhere on the strip.
void LaneStrip::mouseReleaseEvent(QMouseEvent*) {
    if (!m_hand.holds())
        return;
    m_hand.release();
    emit m_closeUp.gripped(false);
    if (!m_moved)
        lookThere(m_pressed);
}

bool LaneStrip::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto handle = m_hand.handleAt(pointerAt(help->pos(), {}));
        QToolTip::showText(help->globalPos(), handle ? handle->tip : toolTip(), viewport());
        return true;
    }
    if (event->type() == QEvent::Leave)
        m_hand.hover(std::nullopt);
    return FloorView::viewportEvent(event);
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
    FloorView::changeEvent(event);
}

void LaneStrip::retranslate() {
    setAccessibleName(tr("The whole lane"));
    setToolTip(tr("The whole lane; click where the close-up is to look"));
}

} // namespace thetalane

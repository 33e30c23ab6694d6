// What the mouse and the keys do on the lane.
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"

#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace thetalane {
namespace {

constexpr double perNotch = 1.2; // of a mouse wheel
constexpr double grabSlack = 6;  // [px] around a body that still counts as it

} // namespace

std::optional<int> LaneView::bodyAt(const QPoint& pixel) const {
    return m_scene.bodyNear(viewportTransform().inverted().map(QPointF(pixel)),
                            grabSlack / transform().m11());
}

Pointer LaneView::pointerAt(const QPoint& pixel) const {
    return {toMetres(viewportTransform().inverted().map(QPointF(pixel))),
            grabSlack / (transform().m11() * unitsPerMetre), QGuiApplication::keyboardModifiers()};
}

std::optional<LaneView::Grip> LaneView::gripAt(const QPoint& pixel) const {
    const Pointer pointer = pointerAt(pixel);
    for (LaneTool* tool : m_tools)
        if (const auto handle = tool->handleAt(pointer))
            return Grip{tool, *handle};
    return std::nullopt;
}

void LaneView::grab(const QPoint& pixel) {
    m_grip = gripAt(pixel);
    if (m_grip)
        m_grip->tool->press(m_grip->handle, pointerAt(pixel));
}

void LaneView::letGo(bool abandon) {
    const Grip grip = *m_grip;
    m_grip.reset(); // first: what the tool does may ask the view
    if (abandon)
        grip.tool->abandon();
    else
        grip.tool->release();
}

void LaneView::hover(const QPoint& pixel) {
    const auto grip = gripAt(pixel);
    for (LaneTool* tool : m_tools)
        tool->hover(grip && grip->tool == tool ? std::optional(grip->handle) : std::nullopt);
    if (grip) {
        m_scene.setHovered(std::nullopt);
        viewport()->setCursor(grip->handle.cursor);
        return;
    }
    const auto body = bodyAt(pixel);
    m_scene.setHovered(body);
    viewport()->setCursor(body && m_scene.nextCollisionOf(*body) ? Qt::PointingHandCursor
                                                                 : Qt::OpenHandCursor);
}

bool LaneView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto grip = gripAt(help->pos()); grip && !grip->handle.tip.isEmpty())
            QToolTip::showText(help->globalPos(), grip->handle.tip, viewport());
        else if (const auto body = bodyAt(help->pos()))
            QToolTip::showText(help->globalPos(), m_scene.bodyTip(*body), viewport());
        else
            QToolTip::hideText();
        return true;
    }
    if (event->type() == QEvent::Leave) {
        m_scene.setHovered(std::nullopt);
        for (LaneTool* tool : m_tools)
            tool->hover(std::nullopt);
    }
    return QGraphicsView::viewportEvent(event);
}

void LaneView::wheelEvent(QWheelEvent* event) {
    zoomAbout(event->position(), std::pow(perNotch, event->angleDelta().y() / 120.0));
    event->accept();
}

void LaneView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    grab(event->position().toPoint());
    if (m_grip)
        return;
    m_pressed = event->position().toPoint();
    m_dragged = *m_pressed;
    m_dragging = false;
}

void LaneView::mouseMoveEvent(QMouseEvent* event) {
    const QPoint at = event->position().toPoint();
    if (m_grip)
        return m_grip->tool->drag(pointerAt(at));
    if (!m_pressed) {
        hover(at);
        return;
    }
    const int start = QGuiApplication::styleHints()->startDragDistance();
    if (!m_dragging && (at - *m_pressed).manhattanLength() < start)
        return;
    m_dragging = true;
    m_scene.setHovered(std::nullopt);
    viewport()->setCursor(Qt::ClosedHandCursor);
    lookAt(camera().centre - QPointF(at - m_dragged) / camera().scale);
    m_dragged = at;
}

void LaneView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (m_grip) {
        letGo(false);
        return hover(event->position().toPoint());
    }
    if (!m_pressed)
        return;
    const bool click = !m_dragging;
    const QPoint at = event->position().toPoint();
    m_pressed.reset();
    m_dragging = false;
    hover(at);
    if (!click)
        return;
    const auto body = bodyAt(at);
    const auto collision = body ? m_scene.nextCollisionOf(*body) : std::nullopt;
    const auto before = m_context.playhead.selectedNumber();
    if (collision)
        m_context.playhead.select(*collision);
    else if (body)
        m_context.playhead.selectBeyond(*body);
    m_clickOpened = collision || m_context.playhead.selectedNumber() != before;
}

// The first click of a double-click on a body has opened its collision, and the view has flown there.
void LaneView::mouseDoubleClickEvent(QMouseEvent* event) {
    const QPoint at = event->position().toPoint();
    if (event->button() == Qt::LeftButton && gripAt(at))
        grab(at); // the second press of two is one, too
    else if (event->button() == Qt::LeftButton && !m_clickOpened)
        fit();
}

// The arrow keys belong to the playhead: what is not ours goes on to the window.
void LaneView::keyPressEvent(QKeyEvent* event) {
    if (m_grip && event->key() == Qt::Key_Escape)
        return letGo(true);
    for (LaneTool* tool : m_tools)
        if (tool->key(*event))
            return;
    switch (event->key()) {
    case Qt::Key_F:
        fit();
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomIn();
        break;
    case Qt::Key_Minus:
        zoomOut();
        break;
    case Qt::Key_Escape:
        if (m_scene.selected()) {
            m_context.playhead.clearSelection();
            break;
        }
        [[fallthrough]];
    default:
        event->ignore();
    }
}

} // namespace thetalane

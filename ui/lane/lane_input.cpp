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

Pointer LaneView::pointerAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const {
    return {toMetres(viewportTransform().inverted().map(pixel)),
            grabSlack / (transform().m11() * unitsPerMetre), modifiers};
}

bool LaneView::grab(const QMouseEvent& event) {
    if (!m_hand.press(pointerAt(event.position(), event.modifiers())))
        return false;
    emit gripped(true);
    return true;
}

void LaneView::hover(const QPoint& pixel, Qt::KeyboardModifiers modifiers) {
    const auto handle = m_hand.hover(pointerAt(pixel, modifiers));
    if (handle) {
        m_scene.setHovered(std::nullopt);
        viewport()->setCursor(handle->cursor);
        return;
    }
    const auto body = bodyAt(pixel);
    m_scene.setHovered(body);
    viewport()->setCursor(body && m_scene.nextCollisionOf(*body) ? Qt::PointingHandCursor
                                                                 : Qt::OpenHandCursor);
}

// The arrow keys and Escape are the window's, except while a tool has a use for them.
bool LaneView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_hand.wantsKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return FloorView::event(event);
}

bool LaneView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto handle = m_hand.handleAt(pointerAt(help->pos(), {})); handle && !handle->tip.isEmpty())
            QToolTip::showText(help->globalPos(), handle->tip, viewport());
        else if (const auto body = bodyAt(help->pos()))
            QToolTip::showText(help->globalPos(), m_scene.bodyTip(*body), viewport());
        else
            QToolTip::hideText();
        return true;
    }
    if (event->type() == QEvent::Leave) {
        m_scene.setHovered(std::nullopt);
        m_hand.hover(std::nullopt);
    }
    return FloorView::viewportEvent(event);
}

void LaneView::wheelEvent(QWheelEvent* event) {
    zoomAbout(event->position(), std::pow(perNotch, event->angleDelta().y() / 120.0));
    event->accept();
}

void LaneView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || grab(*event))
        return;
    m_pressed = event->position().toPoint();
    m_dragged = *m_pressed;
    m_dragging = false;
}

void LaneView::mouseMoveEvent(QMouseEvent* event) {
    const QPoint at = event->position().toPoint();
    if (m_hand.holds())
        return m_hand.drag(pointerAt(event->position(), event->modifiers()));
    if (!m_pressed) {
        hover(at, event->modifiers());
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
    if (m_hand.holds()) {
        m_hand.release();
        emit gripped(false);
        return hover(event->position().toPoint(), event->modifiers());
    }
    if (!m_pressed)
        return;
    const bool click = !m_dragging;
    const QPoint at = event->position().toPoint();
    m_pressed.reset();
    m_dragging = false;
    hover(at, event->modifiers());
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
    if (event->button() != Qt::LeftButton || grab(*event)) // the second press of two is one, too
        return;
    if (!m_clickOpened)
        fit();
}

// The arrow keys belong to the playhead: what is not ours goes on to the window.
void LaneView::keyPressEvent(QKeyEvent* event) {
    const bool held = m_hand.holds();
    if (m_hand.key(*event)) {
        if (held && !m_hand.holds())
            emit gripped(false);
        return;
    }
    switch (event->key()) {
    case Qt::Key_C:
        setFollowing(!following());
        break;
    case Qt::Key_P:
        showRack();
        break;
    case Qt::Key_B:
        showFoulLine();
        break;
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

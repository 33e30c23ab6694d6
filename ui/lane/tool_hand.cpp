#include "ui/lane/tool_hand.h"

#include <QKeyEvent>

#include <algorithm>

namespace thetalane {

std::optional<ToolHand::Grip> ToolHand::gripAt(const Pointer& pointer) const {
    for (LaneTool* tool : m_tools)
        if (const auto handle = tool->handleAt(pointer))
            return Grip{tool, *handle};
    return std::nullopt;
}

std::optional<Handle> ToolHand::handleAt(const Pointer& pointer) const {
    const auto grip = gripAt(pointer);
    return grip ? std::optional(grip->handle) : std::nullopt;
}

std::optional<Handle> ToolHand::hover(const std::optional<Pointer>& pointer) {
    const auto grip = pointer ? gripAt(*pointer) : std::nullopt;
    for (LaneTool* tool : m_tools)
        tool->hover(grip && grip->tool == tool ? std::optional(grip->handle) : std::nullopt);
    return grip ? std::optional(grip->handle) : std::nullopt;
}

bool ToolHand::press(const Pointer& pointer) {
    m_grip = gripAt(pointer);
    if (m_grip)
        m_grip->tool->press(m_grip->handle, pointer);
    return holds();
}

// First: what the tool then does may ask the view.
LaneTool& ToolHand::letGo() {
    LaneTool& tool = *m_grip->tool;
    m_grip.reset();
    return tool;
}

bool ToolHand::wantsKey(const QKeyEvent& event) const {
    if (holds() && event.key() == Qt::Key_Escape)
        return true;
    return std::any_of(m_tools.begin(), m_tools.end(),
                       [&](const LaneTool* tool) { return tool->wantsKey(event); });
}

bool ToolHand::key(const QKeyEvent& event) {
    if (holds() && event.key() == Qt::Key_Escape) {
        abandon();
        return true;
    }
    return std::any_of(m_tools.begin(), m_tools.end(), [&](LaneTool* tool) { return tool->key(event); });
}

void ToolHand::paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const {
    for (const LaneTool* tool : m_tools)
        tool->paint(painter, pixels, area);
}

} // namespace thetalane

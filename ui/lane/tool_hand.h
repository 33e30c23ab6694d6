// The tools of a view, and what the pointer does with them: a halo, then a gesture.
#pragma once

#include "ui/lane/lane_tool.h"

#include <vector>

namespace thetalane {

class ToolHand {
public:
    // Not owned; it must live as long. The first one added is asked first.
    void add(LaneTool& tool) { m_tools.push_back(&tool); }

    std::optional<Handle> handleAt(const Pointer& pointer) const;
    // The handle under the pointer gets its halo; none: the pointer is elsewhere.
    std::optional<Handle> hover(const std::optional<Pointer>& pointer);

    bool press(const Pointer& pointer); // false: nothing there to be grabbed
    void drag(const Pointer& pointer) { m_grip->tool->drag(pointer); }
    void release() { letGo().release(); }
    void abandon() { letGo().abandon(); }
    bool holds() const { return m_grip.has_value(); }

    bool wantsKey(const QKeyEvent& event) const;
    bool key(const QKeyEvent& event);
    void paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const;

private:
    struct Grip {
        LaneTool* tool;
        Handle handle;
    };
    std::optional<Grip> gripAt(const Pointer& pointer) const;
    LaneTool& letGo();

    std::vector<LaneTool*> m_tools;
    std::optional<Grip> m_grip; // of a gesture under way
};

} // namespace thetalane

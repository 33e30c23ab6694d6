// Aiming by hand: the ball along the foul line, the arrow's tip, the bead of its speed, the bead of its
// rotation. Every move is a throw of the session's, so the path shown is the run itself.
#pragma once

#include "ui/aim/aim_geometry.h"
#include "ui/context.h"
#include "ui/lane/lane_tool.h"
#include "ui/panels/throw_terms.h"

namespace thetalane {

class AimTool : public LaneTool {
    Q_OBJECT
public:
    explicit AimTool(const Context& context, QObject* parent = nullptr);

    // While a throw stands before it is thrown, and no collision is open.
    bool isActive() const;
    // Which part the arrow keys move; the key A goes from one to the next.
    std::optional<AimPart> focused() const { return m_focused; }
    bool dragging() const { return m_gesture.has_value(); }

    // What stands beside a part, and why it goes no further; in the language and the units of now.
    QString valueText(AimPart part) const;
    QString limitText() const;
    AimLimit limit() const { return m_limit; }
    void setUnits(const ThrowUnits& units);

    std::optional<Handle> handleAt(const Pointer& pointer) const override;
    void hover(const std::optional<Handle>& handle) override;
    void press(const Handle& handle, const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release() override;
    void abandon() override;
    bool key(const QKeyEvent& event) override;
    bool wantsKey(const QKeyEvent& event) const override;
    bool drawsVelocities() const override { return isActive(); }
    void paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const override;

private:
    // From where the drag is counted; a change between coarse and fine begins anew.
    struct Gesture {
        AimPart part;
        Subject before;
        Throw from;
        Vec2d anchor;
        bool fine = false;
        bool moved = false;
    };

    const Throw& ballThrow() const { return *m_context.session.currentThrow(); }
    void take(const Aimed& aimed);
    void focus(std::optional<AimPart> part);
    void cycle(int forward);
    void followState();
    void forget();
    std::optional<AimPart> shownPart() const; // whose value stands beside it

    QString tipOf(AimPart part) const;
    void paintWay(QPainter& painter, const Pixels& pixels, const QRectF& area) const;
    void paintArrow(QPainter& painter, const Pixels& pixels) const;
    void paintRotation(QPainter& painter, const Pixels& pixels) const;
    void paintHandle(QPainter& painter, const Pixels& pixels, AimPart part) const;
    void paintValue(QPainter& painter, const Pixels& pixels, const QRectF& area) const;

    Context m_context;
    ThrowUnits m_units;
    std::optional<AimPart> m_hovered, m_focused;
    std::optional<Gesture> m_gesture;
    AimLimit m_limit = AimLimit::None; // of the last move
    bool m_active = false;
};

} // namespace thetalane

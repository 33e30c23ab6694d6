// A scene edited on the lane itself, while the playhead stands at its start: bodies are dragged, and the tips
// of their arrows; a body at rest is given a velocity by the small handle at its edge. Every change is the
// session's at once. What is dragged gives way to what is there (see rules/placing.h).
#pragma once

#include "ui/bench/rules/edit_options.h"
#include "ui/context.h"
#include "ui/lane/lane_tool.h"

#include <optional>

namespace thetalane {

class LanePanel;

class EditTool : public LaneTool {
    Q_OBJECT
public:
    // Add it to the lane's view. It must not outlive the lane.
    EditTool(const Context& context, LanePanel& lane, EditOptions& options, QObject* parent = nullptr);

    void setEnabled(bool on);
    // Of scenes that are no throws, of at most 12 bodies, at the start, with no collision open.
    bool isActive() const;
    std::optional<std::size_t> selected() const; // the body that the keys move

    std::optional<Handle> handleAt(const Pointer& pointer) const override;
    void hover(const std::optional<Handle>& handle) override;
    void press(const Handle& handle, const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release() override;
    void abandon() override;
    bool key(const QKeyEvent& event) override;
    void paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const override;

signals:
    // While it is, neither the view nor the scale of the arrows should change under the hand.
    void held(bool isHeld);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Part { Body, Tip };
    struct Grip {
        std::size_t body = 0;
        Part part = Part::Body;
        Vec2d from;            // where the pointer was pressed
        Vec2d offset;          // from the handle's place to the pointer
        double scale = 0;      // of the arrows then [m/(m/s)]
        double resolution = 0; // of the hand: about one pixel [m]
        bool moved = false;
        Subject before;
    };

    const std::vector<Body>& bodies() const { return m_context.session.scene().bodies; }
    double arrowScale() const;
    double spacing(double resolution) const; // of the grid [m]
    Vec2d tipOf(const Body& body, double scale, double atLeast) const;
    bool wants(const QKeyEvent& event) const;
    void moveBody(std::size_t body, Vec2d wanted);
    void setVelocity(std::size_t body, Vec2d velocity);
    void dragTip(const Pointer& pointer, bool snap);
    void change(std::size_t index, const Body& body);
    void step(Vec2d direction, bool far, bool velocity);
    void choose(int forward);
    void remove();
    void letGo();

    QString valuesOf(const Body& body, bool velocity) const;
    void paintGrid(QPainter& painter, const Pixels& pixels, const QRectF& area) const;
    void paintHalo(QPainter& painter, const Pixels& pixels, std::size_t body, bool strong) const;
    void paintHandle(QPainter& painter, const Pixels& pixels, std::size_t body) const;
    void paintValues(QPainter& painter, const Pixels& pixels, const QRectF& area, std::size_t body,
                     bool velocity) const;

    Context m_context;
    LanePanel& m_lane;
    EditOptions& m_options;
    bool m_enabled = true;
    std::optional<Handle> m_hovered;
    std::optional<std::size_t> m_selected;
    bool m_lastWasVelocity = false; // what the keys changed last
    std::optional<Grip> m_grip;
    mutable double m_resolution = 0.001; // one pixel, as last painted [m]
};

} // namespace thetalane

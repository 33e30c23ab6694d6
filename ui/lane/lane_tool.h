// What can be grabbed on the lane: a ball to aim, a body to move, the tip of an arrow. A view asks its tools
// in order; what none of them wants pans the view and opens collisions, as ever. Places in metres, y up.
#pragma once

#include "ui/lane/scale.h"

#include <QObject>
#include <QString>

#include <optional>

class QKeyEvent;

namespace thetalane {

// Where the pointer is; reach: how far from a handle still counts as on it [m].
struct Pointer {
    Vec2d at;
    double reach = 0;
    Qt::KeyboardModifiers modifiers{};
};

struct Handle {
    int id = 0; // the tool's own
    Qt::CursorShape cursor = Qt::SizeAllCursor;
    QString tip{}; // what grabbing it does, and by which keys

    friend bool operator==(const Handle&, const Handle&) = default;
};

class LaneTool : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    // What could be grabbed here now; nothing while the tool rests.
    virtual std::optional<Handle> handleAt(const Pointer& pointer) const = 0;
    virtual void hover(const std::optional<Handle>& handle) = 0; // for a halo

    // A gesture: press, any number of drags, release. Abandoned by Escape, it leaves everything as it was.
    virtual void press(const Handle& handle, const Pointer& pointer) = 0;
    virtual void drag(const Pointer& pointer) = 0;
    virtual void release() = 0;
    virtual void abandon() = 0;

    // A key while the lane has the focus; true: taken. One that it wants comes to it before the window's
    // shortcuts do.
    virtual bool key(const QKeyEvent& event) = 0;
    virtual bool wantsKey(const QKeyEvent&) const { return false; }

    // It draws what the arrows of the velocities would say, now.
    virtual bool drawsVelocities() const { return false; }

    // Over the bodies. Pixels of the viewport by `pixels`; `area`: the viewport [px].
    virtual void paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const = 0;

signals:
    void changed(); // paint again
};

} // namespace thetalane

#include "ui/bench/edit_tool.h"

#include "ui/bench/rules/placing.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"
#include "ui/words/worked_steps.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double speedStep = 0.1; // of the tips on the grid, and of the keys [m/s]
constexpr double keyStep = 0.01;  // [m]

// 1, 2 or 5 times a power of ten.
double roundStep(double atLeast) {
    const double power = std::pow(10, std::floor(std::log10(atLeast)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= atLeast * (1 - 1e-9))
            return tidy(factor * power);
    return tidy(10 * power);
}

Vec2d rounded(Vec2d v, double step) {
    return {tidy(std::round(v.x / step) * step), tidy(std::round(v.y / step) * step)};
}

// No finer than the hand: short numbers are easier to read, and to type after.
double digitOf(double resolution) {
    return std::pow(10, std::floor(std::log10(resolution)));
}

Vec2d directionOf(int key) {
    return key == Qt::Key_Left    ? Vec2d{-1, 0}
           : key == Qt::Key_Right ? Vec2d{1, 0}
           : key == Qt::Key_Up    ? Vec2d{0, 1}
           : key == Qt::Key_Down  ? Vec2d{0, -1}
                                  : Vec2d{};
}

} // namespace

EditTool::EditTool(const Context& context, LanePanel& lane, EditOptions& options, QObject* parent)
    : LaneTool(parent)
    , m_context(context)
    , m_lane(lane)
    , m_options(options) {
    lane.view().installEventFilter(this);
    connect(&options, &EditOptions::changed, this, &LaneTool::changed);
    connect(&context.session, &Session::opened, this, [this] { m_selected.reset(); });
    connect(&context.session, &Session::runChanged, this, [this] {
        if (m_selected && *m_selected >= bodies().size())
            m_selected.reset();
        m_hovered.reset();
    });
}

void EditTool::setEnabled(bool on) {
    m_enabled = on;
    m_selected.reset();
    emit changed();
}

bool EditTool::isActive() const {
    const Playhead& playhead = m_context.playhead;
    return m_enabled && !m_context.session.currentThrow() && bodies().size() <= mostOnTheBench &&
           playhead.time() == 0 && !playhead.playing() && !playhead.selectedNumber();
}

std::optional<std::size_t> EditTool::selected() const {
    return isActive() ? m_selected : std::nullopt;
}

// Of a scene where everything rests, what a body at 1 m/s would have.
double EditTool::arrowScale() const {
    if (m_grip && m_grip->part == Part::Tip)
        return m_grip->scale;
    if (const double scale = m_lane.scene().metresPerSpeed(); scale > 0)
        return scale;
    double radius = 0;
    for (const Body& body : bodies())
        radius = std::max(radius, body.radius);
    return 3 * radius;
}

double EditTool::spacing(double resolution) const {
    constexpr double fewestPixels = 24;
    return m_options.grid() > 0 ? m_options.grid() : roundStep(fewestPixels * resolution);
}

// A body that rests shows where its arrow would begin.
Vec2d EditTool::tipOf(const Body& body, double scale, double atLeast) const {
    const double speed = norm(body.velocity);
    const Vec2d direction = speed > 0 ? body.velocity * (1 / speed) : Vec2d{1, 0};
    return body.position + direction * (body.radius + std::max(speed * scale, atLeast));
}

std::optional<Handle> EditTool::handleAt(const Pointer& pointer) const {
    if (!isActive())
        return std::nullopt;
    const auto handle = [&](std::size_t i, Part part) {
        const QString tip = part == Part::Tip
                                ? tr("Drag: set the velocity of %1").arg(bodyName(bodies()[i])) + u'\n' +
                                      tr("Keys: N selects a body, Alt and the arrow keys change its velocity")
                                : m_lane.scene().bodyTip(int(i)) + u'\n' + tr("Drag: move it") + u'\n' +
                                      tr("Keys: N selects a body, the arrow keys move it, Delete removes it");
        return Handle{int(2 * i) + int(part), part == Part::Tip ? Qt::CrossCursor : Qt::SizeAllCursor, tip};
    };
    std::optional<std::size_t> nearest;
    double distance = 1.2 * pointer.reach;
    for (std::size_t i = 0; i < bodies().size(); ++i) {
        const double d = norm(pointer.at - tipOf(bodies()[i], arrowScale(), 1.5 * pointer.reach));
        if (d < distance) {
            nearest = i;
            distance = d;
        }
    }
    if (nearest)
        return handle(*nearest, Part::Tip);
    distance = pointer.reach;
    for (std::size_t i = 0; i < bodies().size(); ++i) {
        const double d = norm(pointer.at - bodies()[i].position) - bodies()[i].radius;
        if (d < distance) {
            nearest = i;
            distance = d;
        }
    }
    return nearest ? std::optional(handle(*nearest, Part::Body)) : std::nullopt;
}

void EditTool::hover(const std::optional<Handle>& handle) {
    if (handle == m_hovered)
        return;
    m_hovered = handle;
    emit changed();
}

void EditTool::press(const Handle& handle, const Pointer& pointer) {
    Grip grip;
    grip.body = std::size_t(handle.id / 2);
    grip.part = Part(handle.id % 2);
    grip.from = pointer.at;
    grip.scale = arrowScale();
    grip.resolution = m_resolution;
    grip.before = m_context.session.subject();
    const Body& body = bodies()[grip.body];
    grip.offset = pointer.at - (grip.part == Part::Body ? body.position : tipOf(body, grip.scale, 0));
    m_selected = grip.body;
    m_lastWasVelocity = grip.part == Part::Tip;
    m_grip = std::move(grip);
    emit held(true);
    emit changed();
}

void EditTool::drag(const Pointer& pointer) {
    if (!m_grip || m_grip->body >= bodies().size())
        return;
    // A hand that clicks trembles.
    if (!m_grip->moved && norm(pointer.at - m_grip->from) < 0.6 * pointer.reach)
        return;
    m_grip->moved = true;
    const bool snap = m_options.snap() != bool(pointer.modifiers & Qt::ControlModifier);
    if (m_grip->part == Part::Tip)
        return dragTip(pointer, snap);
    moveBody(m_grip->body, rounded(pointer.at - m_grip->offset,
                                   snap ? spacing(m_grip->resolution) : digitOf(m_grip->resolution)));
}

void EditTool::dragTip(const Pointer& pointer, bool snap) {
    const Body& body = bodies()[m_grip->body];
    const Vec2d reach = pointer.at - m_grip->offset - body.position;
    const double distance = norm(reach);
    const double speed = std::max(0.0, distance - body.radius) / m_grip->scale;
    const Vec2d velocity = distance > 0 ? reach * (speed / distance) : Vec2d{};
    setVelocity(m_grip->body,
                rounded(velocity, snap ? speedStep : digitOf(m_grip->resolution / m_grip->scale)));
}

void EditTool::moveBody(std::size_t index, Vec2d wanted) {
    Body body = bodies()[index];
    Mover mover{.radius = body.radius, .index = int(index), .line = {}};
    if (m_options.oneLine())
        mover.line = body.position.y;
    if (const auto place = freePlaceNear(m_context.session.scene(), mover, wanted)) {
        body.position = *place;
        change(index, body);
    }
}

void EditTool::setVelocity(std::size_t index, Vec2d velocity) {
    Body body = bodies()[index];
    body.velocity = m_options.oneLine() ? Vec2d{velocity.x, 0} : velocity;
    change(index, body);
}

void EditTool::change(std::size_t index, const Body& body) {
    if (bodies()[index] == body)
        return emit changed();
    Scene scene = m_context.session.scene();
    scene.bodies[index] = body;
    m_context.session.setScene(scene);
    emit changed();
}

// A click is what it ever was: it opens the body's next collision.
void EditTool::release() {
    const auto grip = std::exchange(m_grip, std::nullopt);
    emit held(false);
    if (grip && !grip->moved && grip->part == Part::Body) {
        if (const auto next = m_lane.scene().nextCollisionOf(int(grip->body)))
            m_context.playhead.select(*next);
        else
            m_context.playhead.selectBeyond(int(grip->body));
    }
    emit changed();
}

void EditTool::abandon() {
    const auto grip = std::exchange(m_grip, std::nullopt);
    emit held(false);
    if (grip && !(m_context.session.subject() == grip->before))
        m_context.session.restore(grip->before);
    emit changed();
}

// The window's own shortcuts would come first.
bool EditTool::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && wants(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return LaneTool::eventFilter(watched, event);
}

bool EditTool::wants(const QKeyEvent& event) const {
    if (m_grip)
        return event.key() == Qt::Key_Escape;
    if (!isActive() || (event.modifiers() & Qt::ControlModifier))
        return false;
    if (event.key() == Qt::Key_N)
        return true;
    const bool others =
        event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Escape;
    return m_selected && (others || norm(directionOf(event.key())) > 0);
}

bool EditTool::key(const QKeyEvent& event) {
    if (m_grip || !wants(event))
        return false;
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    if (event.key() == Qt::Key_N)
        choose(shift ? -1 : +1);
    else if (event.key() == Qt::Key_Escape)
        m_selected.reset();
    else if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace)
        remove();
    else
        step(directionOf(event.key()), shift, event.modifiers() & Qt::AltModifier);
    emit changed();
    return true;
}

void EditTool::choose(int forward) {
    const int count = int(bodies().size());
    const int from = m_selected ? int(*m_selected) : forward > 0 ? -1 : count;
    m_selected = std::size_t((from + forward + count) % count);
}

void EditTool::step(Vec2d direction, bool far, bool velocity) {
    const Body& body = bodies()[*m_selected];
    m_lastWasVelocity = velocity;
    const double times = far ? 10 : 1;
    if (velocity) {
        const Vec2d v = body.velocity + direction * (speedStep * times);
        return setVelocity(*m_selected, {tidy(v.x), tidy(v.y)});
    }
    if (!m_options.snap()) {
        const Vec2d to = body.position + direction * (keyStep * times);
        return moveBody(*m_selected, {tidy(to.x), tidy(to.y)});
    }
    // To the next line of the grid; along the other axis it stays where it is.
    const double grid = spacing(m_resolution);
    const Vec2d on = rounded(body.position + direction * (grid * times), grid);
    moveBody(*m_selected,
             {direction.x != 0 ? on.x : body.position.x, direction.y != 0 ? on.y : body.position.y});
}

void EditTool::remove() {
    if (bodies().size() < 2)
        return;
    const std::size_t index = *m_selected;
    m_selected.reset();
    m_context.session.setScene(without(m_context.session.scene(), index));
}

} // namespace thetalane

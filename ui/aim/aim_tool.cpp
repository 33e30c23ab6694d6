#include "ui/aim/aim_tool.h"

#include <QKeyEvent>

#include <algorithm>

namespace thetalane {
namespace {

constexpr double fineShare = 0.1; // of the hand's way
// From here on the bead of the rotation can be told from the ball: the reach of a pointer is so small only
// where the lane is drawn large [m].
constexpr double reachAtRotation = 0.08;

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

} // namespace

AimTool::AimTool(const Context& context, QObject* parent)
    : LaneTool(parent)
    , m_context(context)
    , m_active(isActive()) {
    connect(&context.session, &Session::runChanged, this, [this] {
        followState();
        emit changed();
    });
    connect(&context.session, &Session::opened, this, &AimTool::forget);
    connect(&context.playhead, &Playhead::timeChanged, this, &AimTool::followState);
    connect(&context.playhead, &Playhead::playingChanged, this, &AimTool::followState);
    connect(&context.playhead, &Playhead::selectionChanged, this, &AimTool::followState);
}

bool AimTool::isActive() const {
    const Playhead& playhead = m_context.playhead;
    return m_context.session.currentThrow() && playhead.time() == 0 && !playhead.playing() &&
           !playhead.selectedNumber();
}

void AimTool::setUnits(const ThrowUnits& units) {
    m_units = units;
    emit changed();
}

void AimTool::followState() {
    if (isActive() == m_active)
        return;
    m_active = !m_active;
    if (!m_active)
        forget();
    emit changed();
}

void AimTool::forget() {
    m_gesture.reset();
    m_focused.reset();
    m_hovered.reset();
    m_limit = AimLimit::None;
}

std::optional<Handle> AimTool::handleAt(const Pointer& pointer) const {
    if (!isActive())
        return std::nullopt;
    static constexpr Qt::CursorShape cursors[] = {Qt::SizeHorCursor, Qt::SizeHorCursor, Qt::SizeVerCursor,
                                                  Qt::SizeAllCursor};
    std::optional<Handle> nearest;
    double least = 1;
    for (int k = 0; k < aimPartCount; ++k) {
        const auto part = AimPart(k);
        if (part == AimPart::Rotation && pointer.reach > reachAtRotation)
            continue;
        const double size =
            part == AimPart::Ball ? std::max(regulation::ballRadius, pointer.reach) : 1.7 * pointer.reach;
        const double distance = norm(pointer.at - placeOf(part, ballThrow())) / size;
        if (distance <= least) {
            least = distance;
            nearest = Handle{k, cursors[k], tipOf(part)};
        }
    }
    return nearest;
}

void AimTool::hover(const std::optional<Handle>& handle) {
    const auto part = handle ? std::optional(AimPart(handle->id)) : std::nullopt;
    if (part == m_hovered)
        return;
    m_hovered = part;
    emit changed();
}

void AimTool::press(const Handle& handle, const Pointer& pointer) {
    m_limit = AimLimit::None;
    m_gesture = Gesture{AimPart(handle.id), m_context.session.subject(), ballThrow(), pointer.at,
                        bool(pointer.modifiers & Qt::ShiftModifier)};
    emit changed();
}

void AimTool::drag(const Pointer& pointer) {
    if (!m_gesture || !isActive())
        return;
    const bool fine = pointer.modifiers & Qt::ShiftModifier;
    if (fine != m_gesture->fine) {
        m_gesture->fine = fine;
        m_gesture->from = ballThrow();
        m_gesture->anchor = pointer.at;
    }
    const Vec2d way = (pointer.at - m_gesture->anchor) * (fine ? fineShare : 1);
    m_gesture->moved = m_gesture->moved || !(way == Vec2d{});
    take(movedBy(m_gesture->from, m_gesture->part, way));
}

void AimTool::take(const Aimed& aimed) {
    m_limit = aimed.limit;
    if (aimed.ballThrow == ballThrow())
        emit changed();
    else
        m_context.session.setDelivery(aimed.ballThrow, m_context.session.standing(),
                                      m_context.session.laneConditions());
}

// A click that moved nothing gives the part to the keys.
void AimTool::release() {
    if (!m_gesture)
        return;
    const Gesture done = *m_gesture;
    m_gesture.reset();
    m_limit = AimLimit::None;
    focus(done.moved ? m_focused : done.part);
}

void AimTool::abandon() {
    if (!m_gesture)
        return;
    const Subject before = m_gesture->before;
    m_gesture.reset();
    m_limit = AimLimit::None;
    if (m_context.session.subject() == before)
        emit changed();
    else
        m_context.session.restore(before);
}

void AimTool::focus(std::optional<AimPart> part) {
    m_focused = part;
    m_limit = AimLimit::None;
    emit changed();
}

// One place of the round is no part: there the arrow keys are the playhead's again.
void AimTool::cycle(int forward) {
    constexpr int places = aimPartCount + 1;
    const int now = m_focused ? int(*m_focused) : aimPartCount;
    const int next = (now + forward + places) % places;
    focus(next == aimPartCount ? std::nullopt : std::optional(AimPart(next)));
}

bool AimTool::wantsKey(const QKeyEvent& event) const {
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (!isActive() || !plain)
        return false;
    if (event.key() == Qt::Key_Escape)
        return m_gesture || m_focused;
    return m_focused && isArrow(event.key());
}

bool AimTool::key(const QKeyEvent& event) {
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    if (isActive() && plain && event.key() == Qt::Key_A && !m_gesture) {
        cycle(shift ? -1 : +1);
        return true;
    }
    if (!wantsKey(event))
        return false;
    if (event.key() == Qt::Key_Escape) {
        m_gesture ? abandon() : focus(std::nullopt);
        return true;
    }
    if (m_gesture)
        return true; // the hand has it
    const int right = (event.key() == Qt::Key_Right) - (event.key() == Qt::Key_Left);
    const int up = (event.key() == Qt::Key_Up) - (event.key() == Qt::Key_Down);
    take(steppedBy(ballThrow(), *m_focused, right, up, shift));
    return true;
}

std::optional<AimPart> AimTool::shownPart() const {
    return m_gesture ? std::optional(m_gesture->part) : m_focused ? m_focused : m_hovered;
}

} // namespace thetalane

// What a scene asks an engine to model, and the models in an engine's own real type.
#pragma once

#include "core/scene/scene.h"
#include "core/timeline/timeline.h"

#include <limits>

namespace thetalane {

// Model only what a scene requires: the engines are compiled for each combination.
struct Requirements {
    bool frame = false;
    bool lane = false;
    bool friction = false;
};

inline Requirements requirementsOf(const Scene& scene) {
    return {scene.frame.has_value(), scene.lane.has_value(), scene.friction.has_value()};
}

// The four walls; a side that is open lies at infinity.
template <class Real> struct Walls {
    Real at[4] = {-std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity(),
                  -std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
    Real restitution{1};

    Walls() = default;
    explicit Walls(const std::optional<Frame>& frame) {
        if (!frame)
            return;
        restitution = Real(frame->restitution);
        for (const Side s : sides)
            if (const auto& position = frame->side(s))
                at[int(s)] = Real(*position);
    }
};

// How far the disc's edge is from the wall and how fast it nears it; x or y alone.
template <class Real> struct WallApproach {
    Real gap{};
    Real speed{}; // positive towards the wall
};

template <class Real>
WallApproach<Real> approachTo(Side side, const Real& wall, const Vec2<Real>& p, const Vec2<Real>& v,
                              const Real& radius) {
    switch (side) {
    case Side::Left:
        return {p.x - radius - wall, -v.x};
    case Side::Right:
        return {wall - (p.x + radius), v.x};
    case Side::Bottom:
        return {p.y - radius - wall, -v.y};
    default:
        return {wall - (p.y + radius), v.y};
    }
}

// The contact triangle of a wall: from the point touched to the centre; θ is 0°, 180°, 90° or 270°.
template <class Real> PairCollision<Real> collideWithSide(const Disc<Real>& disc, Side side, const Real& e) {
    const Real r = disc.radius;
    const Real zero(0), one(1);
    switch (side) {
    case Side::Left:
        return collideWithWall(disc, {disc.position.x - r, disc.position.y}, {r, zero, r, one, zero}, e);
    case Side::Right:
        return collideWithWall(disc, {disc.position.x + r, disc.position.y}, {-r, zero, r, -one, zero}, e);
    case Side::Bottom:
        return collideWithWall(disc, {disc.position.x, disc.position.y - r}, {zero, r, r, zero, one}, e);
    default:
        return collideWithWall(disc, {disc.position.x, disc.position.y + r}, {zero, -r, r, zero, -one}, e);
    }
}

// What happens to a body's velocity at the edges of a lane (a declared rule, for discs):
// over a side it is lost to play and runs on until the middle of the gutter takes its sideways speed;
// over the end it drops into the pit, loses its sideways speed, and stops at the back.
template <class Real> struct LaneEdges {
    static inline const Real far = std::numeric_limits<Real>::infinity();
    Real left = -far, right = far, gutterLeft = -far, gutterRight = far, end = far, back = far;

    explicit LaneEdges(const std::optional<Lane>& lane) {
        if (!lane)
            return;
        left = Real(lane->left);
        right = Real(lane->right);
        gutterLeft = left - Real(lane->gutterWidth) / 2;
        gutterRight = right + Real(lane->gutterWidth) / 2;
        end = Real(lane->end);
        back = end + Real(lane->pitDepth);
    }
};

enum class LaneEvent { None, OverSide, GutterMiddle, OverEnd, PitBack };

template <class Real> struct NextLaneEvent {
    Real in{}; // time until it
    LaneEvent event = LaneEvent::None;
};

// The next line that a body's centre crosses, from where it is.
template <class Real>
NextLaneEvent<Real> nextLaneEvent(const LaneEdges<Real>& lane, const Vec2<Real>& p, const Vec2<Real>& v,
                                  const Real& radius, Place place) {
    NextLaneEvent<Real> next{std::numeric_limits<Real>::infinity(), LaneEvent::None};
    const auto consider = [&next](const Real& distance, const Real& speed, LaneEvent event) {
        if (!(speed > 0))
            return;
        const Real in = distance > 0 ? distance / speed : Real(0);
        if (in < next.in)
            next = {in, event};
    };
    switch (place) {
    case Place::Play:
        consider(lane.right - p.x, v.x, LaneEvent::OverSide);
        consider(p.x - lane.left, -v.x, LaneEvent::OverSide);
        consider(lane.end - p.y, v.y, LaneEvent::OverEnd);
        break;
    case Place::Gutter:
        consider(lane.gutterRight - p.x, v.x, LaneEvent::GutterMiddle);
        consider(p.x - lane.gutterLeft, -v.x, LaneEvent::GutterMiddle);
        consider(lane.end - p.y, v.y, LaneEvent::OverEnd);
        break;
    case Place::Pit:
        consider(lane.back - radius - p.y, v.y, LaneEvent::PitBack);
        break;
    }
    return next;
}

// Where the body is and how it moves after the event.
template <class Real> void applyLaneEvent(LaneEvent event, Vec2<Real>& v, Place& place) {
    switch (event) {
    case LaneEvent::OverSide:
        place = Place::Gutter;
        break;
    case LaneEvent::GutterMiddle:
        v.x = Real(0);
        break;
    case LaneEvent::OverEnd:
        place = Place::Pit;
        v.x = Real(0);
        break;
    case LaneEvent::PitBack:
        v = {};
        break;
    case LaneEvent::None:
        break;
    }
}

} // namespace thetalane

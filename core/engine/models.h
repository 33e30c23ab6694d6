// What a scene asks an engine to model, and the models in an engine's own real type.
#pragma once

#include "core/motion/zones.h"
#include "core/scene/scene.h"
#include "core/timeline/timeline.h"

#include <limits>

namespace thetalane {

// Model only what a scene requires: the engines are compiled for each combination.
template <bool Frame, bool Lane, bool Friction> struct Models {
    static constexpr bool frame = Frame;
    static constexpr bool lane = Lane;
    static constexpr bool friction = Friction;
};

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
// Between kickbacks a pin flies over the gutter, is thrown back, and stays in play; the gutter has it when it
// stops there, or comes out on this side of the plates.
template <class Real> struct LaneEdges {
    static inline const Real far = std::numeric_limits<Real>::infinity();
    Real left = -far, right = far, gutterLeft = -far, gutterRight = far, end = far, back = far;
    bool hasKickbacks = false;
    Real kickbacksFrom = far, kickbackLeft = -far, kickbackRight = far, kickbackRestitution{0};

    explicit LaneEdges(const std::optional<Lane>& lane) {
        if (!lane)
            return;
        left = Real(lane->left);
        right = Real(lane->right);
        gutterLeft = left - Real(lane->gutterWidth) / 2;
        gutterRight = right + Real(lane->gutterWidth) / 2;
        end = Real(lane->end);
        back = end + Real(lane->pitDepth);
        if (!lane->kickbacks)
            return;
        hasKickbacks = true;
        kickbacksFrom = Real(lane->kickbacks->from);
        kickbackLeft = left - Real(lane->gutterWidth);
        kickbackRight = right + Real(lane->gutterWidth);
        kickbackRestitution = Real(lane->kickbacks->restitution);
    }
};

enum class LaneEvent { None, OverSide, Landing, GutterMiddle, OverEnd, PitBack };

template <class Real> struct NextLaneEvent {
    Real in{}; // time until it
    LaneEvent event = LaneEvent::None;
};

// Where a body is with respect to a lane.
struct LanePlace {
    Place place = Place::Play;
    bool canFly = false;    // a pin of a lane with kickbacks
    signed char flying = 0; // over the gutter on the left (-1) or right (1), still in play
};

// The next line that a body's centre crosses, from p with velocity v and acceleration a.
template <class Real>
NextLaneEvent<Real> nextLaneEvent(const LaneEdges<Real>& lane, const Vec2<Real>& p, const Vec2<Real>& v,
                                  const Vec2<Real>& a, const Real& radius, const LanePlace& where) {
    NextLaneEvent<Real> next{std::numeric_limits<Real>::infinity(), LaneEvent::None};
    const auto consider = [&next](const Real& distance, const Real& speed, const Real& acceleration,
                                  LaneEvent event) {
        const Real in = timeToCross<Real>(distance > Real(0) ? distance : Real(0), speed, acceleration);
        if (in < next.in)
            next = {in, event};
    };
    const bool lost = where.place != Place::Play;
    if (where.place == Place::Pit) {
        consider(lane.back - radius - p.y, v.y, Real(0), LaneEvent::PitBack);
        return next;
    }
    if (lost) {
        consider(lane.gutterRight - p.x, v.x, Real(0), LaneEvent::GutterMiddle);
        consider(p.x - lane.gutterLeft, -v.x, Real(0), LaneEvent::GutterMiddle);
    } else if (where.flying == 0) {
        consider(lane.right - p.x, v.x, a.x, LaneEvent::OverSide);
        consider(p.x - lane.left, -v.x, -a.x, LaneEvent::OverSide);
    } else {
        const bool right = where.flying > 0;
        consider(right ? Real(p.x - lane.right) : Real(lane.left - p.x), right ? Real(-v.x) : v.x,
                 right ? Real(-a.x) : a.x, LaneEvent::Landing);
        consider(p.y - lane.kickbacksFrom, -v.y, -a.y, LaneEvent::OverSide);
    }
    consider(lane.end - p.y, v.y, lost ? Real(0) : a.y, LaneEvent::OverEnd);
    return next;
}

// Where the body, at p, is and how it moves after the event.
template <class Real>
void applyLaneEvent(LaneEvent event, const LaneEdges<Real>& lane, const Vec2<Real>& p, Vec2<Real>& v,
                    LanePlace& where) {
    switch (event) {
    case LaneEvent::OverSide:
        if (where.canFly && where.flying == 0 && !(p.y < lane.kickbacksFrom))
            where.flying = v.x > Real(0) ? 1 : -1;
        else
            where = {Place::Gutter};
        break;
    case LaneEvent::Landing:
        where.flying = 0;
        break;
    case LaneEvent::GutterMiddle:
        v.x = Real(0);
        break;
    case LaneEvent::OverEnd:
        where = {Place::Pit};
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

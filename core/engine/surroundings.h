// What a body meets on its own, whichever way its partners are found: walls, the edges of a lane, the end of
// its stretch of motion.
#pragma once

#include "core/engine/held_contacts.h"
#include "core/engine/models.h"
#include "core/engine/traveller.h"

#include <limits>
#include <vector>

namespace thetalane {

enum class EventKind : unsigned char { None, Pair, Wall, Kickback, LaneEdge, StretchEnd, Cell };

inline bool isContact(EventKind kind) {
    return kind == EventKind::Pair || kind == EventKind::Wall || kind == EventKind::Kickback;
}

// What happens next to one body. Only a search for partners knows of cells.
template <class Real> struct NextEvent {
    Real time = std::numeric_limits<Real>::infinity();
    unsigned partner = 0; // of a pair
    EventKind kind = EventKind::None;
    unsigned char detail = 0; // which Side or LaneEvent
};

template <class Real, class Models> class Surroundings {
public:
    static constexpr bool hasFrame = Models::frame;
    static constexpr bool hasLane = Models::lane;
    static constexpr bool hasFriction = Models::friction;

    explicit Surroundings(const Scene& scene)
        : m_walls(scene.frame)
        , m_lane(scene.lane)
        , m_places(hasLane ? scene.bodies.size() : 0) {
        if (hasLane && m_lane.hasKickbacks)
            for (std::size_t i = 0; i < scene.bodies.size(); ++i)
                m_places[i].canFly = scene.bodies[i].kind == BodyKind::Pin;
    }

    const Walls<Real>& walls() const { return m_walls; }
    const LaneEdges<Real>& lane() const { return m_lane; }
    Place place(std::size_t i) const { return hasLane ? m_places[i].place : Place::Play; }
    LanePlace& placeOf(std::size_t i) { return m_places[i]; } // of a scene with a lane
    bool inPlay(std::size_t i) const { return place(i) == Place::Play; }

    HeldContacts& held() { return m_held; }
    bool holdsPair(std::size_t i, std::size_t j) const { return hasFriction && m_held.holdsPair(i, j); }

    bool holdsWall(std::size_t i, Side side) const { return hasFriction && m_held.holdsWall(i, side); }

    std::vector<std::size_t> partnersOf(std::size_t i) const { return m_held.partnersOf(i); }

    Real restitutionOf(EventKind kind) const {
        return kind == EventKind::Kickback ? m_lane.kickbackRestitution : m_walls.restitution;
    }

    // The next event of body i on its own.
    NextEvent<Real> next(std::size_t i, const Real& now, const Traveller<Real>& t) const {
        NextEvent<Real> own;
        if constexpr (hasFriction)
            own = {t.until, 0, t.until < own.time ? EventKind::StretchEnd : EventKind::None, 0};
        forEachWall(i, [&](EventKind kind, Side side, const Real& wall) {
            const auto gap = approachTo(side, wall, t.p, t.v, t.radius);
            if (holdsWall(i, side))
                return;
            Real in;
            if constexpr (hasFriction)
                in = timeToCross<Real>(gap.gap > Real(0) ? gap.gap : Real(0), gap.speed,
                                       approachTo(side, wall, t.p, t.a, t.radius).speed);
            else if (!(gap.speed > 0) || gap.gap == std::numeric_limits<Real>::infinity())
                return;
            else
                in = gap.gap > 0 ? Real(gap.gap / gap.speed) : Real(0);
            if (now + in < own.time)
                own = {now + in, 0, kind, static_cast<unsigned char>(side)};
        });
        if constexpr (hasLane) {
            const auto edge = nextLaneEvent<Real>(m_lane, t.p, t.v, t.a, t.radius, m_places[i]);
            if (edge.event != LaneEvent::None && now + edge.in < own.time)
                own = {now + edge.in, 0, EventKind::LaneEdge, static_cast<unsigned char>(edge.event)};
        }
        return own;
    }

    // f(kind, side, where it stands) for each wall that body i can meet.
    template <class F> void forEachWall(std::size_t i, F&& f) const {
        if constexpr (hasFrame)
            for (const Side side : sides)
                f(EventKind::Wall, side, m_walls.at[int(side)]);
        if constexpr (hasLane)
            if (m_places[i].flying != 0) {
                const bool right = m_places[i].flying > 0;
                f(EventKind::Kickback, right ? Side::Right : Side::Left,
                  right ? m_lane.kickbackRight : m_lane.kickbackLeft);
            }
    }

private:
    Walls<Real> m_walls;
    LaneEdges<Real> m_lane;
    std::vector<LanePlace> m_places;
    HeldContacts m_held;
};

} // namespace thetalane

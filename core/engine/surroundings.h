// What a body meets on its own, whichever way its partners are found: walls, the edges of a lane.
#pragma once

#include "core/engine/models.h"

#include <limits>
#include <vector>

namespace thetalane {

enum class EventKind : unsigned char { None, Pair, Wall, LaneEdge, Cell };

// What happens next to one body. Only a search for partners knows of cells.
template <class Real> struct NextEvent {
    Real time = std::numeric_limits<Real>::infinity();
    unsigned partner = 0; // of a pair
    EventKind kind = EventKind::None;
    unsigned char detail = 0; // which Side or LaneEvent
};

template <class Real, bool HasFrame, bool HasLane> class Surroundings {
public:
    static constexpr bool hasFrame = HasFrame;
    static constexpr bool hasLane = HasLane;

    explicit Surroundings(const Scene& scene)
        : m_walls(scene.frame)
        , m_lane(scene.lane)
        , m_places(HasLane ? scene.bodies.size() : 0, Place::Play) {}

    const Walls<Real>& walls() const { return m_walls; }
    Place place(std::size_t i) const { return HasLane ? m_places[i] : Place::Play; }
    Place& placeOf(std::size_t i) { return m_places[i]; } // of a scene with a lane
    bool inPlay(std::size_t i) const { return place(i) == Place::Play; }

    // The next event of body i, now at p, on its own.
    NextEvent<Real> next(std::size_t i, const Real& now, const Vec2<Real>& p, const Vec2<Real>& v,
                         const Real& radius) const {
        NextEvent<Real> own;
        if constexpr (HasFrame)
            considerWalls(now, p, v, radius, own);
        if constexpr (HasLane) {
            const auto edge = nextLaneEvent(m_lane, p, v, radius, m_places[i]);
            if (edge.event != LaneEvent::None && now + edge.in < own.time)
                own = {now + edge.in, 0, EventKind::LaneEdge, static_cast<unsigned char>(edge.event)};
        }
        return own;
    }

private:
    void considerWalls(const Real& now, const Vec2<Real>& p, const Vec2<Real>& v, const Real& radius,
                       NextEvent<Real>& own) const {
        for (const Side side : sides) {
            const auto a = approachTo(side, m_walls.at[int(side)], p, v, radius);
            if (!(a.speed > 0) || a.gap == std::numeric_limits<Real>::infinity())
                continue;
            const Real time = now + (a.gap > 0 ? Real(a.gap / a.speed) : Real(0));
            if (time < own.time)
                own = {time, 0, EventKind::Wall, static_cast<unsigned char>(side)};
        }
    }

    Walls<Real> m_walls;
    LaneEdges<Real> m_lane;
    std::vector<Place> m_places;
};

} // namespace thetalane

// What happened, whole: every engine returns one, and no view can tell which engine made it.
// A state at any time is looked up, never computed in reverse, so forward and back show the same bits for
// every e.
#pragma once

#include "core/collision/pair_collision.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace thetalane {

// Where a body is: in play on the lane (or in a scene without one), or lost to play.
enum class Place : std::uint8_t { Play, Gutter, Pit };

// One stretch of motion, from `start` until the body's next segment: p(t) = p + v τ + ½ a τ², τ = t - start.
struct Segment {
    double start = 0; // s
    Vec2d position;
    Vec2d velocity;
    Vec2d acceleration;
    Place place = Place::Play;
};

// How a body turns during a stretch of motion, on a floor with friction: ω(t) = spin + rate τ.
struct Rotation {
    Spin<double> spin; // rad/s
    Spin<double> rate; // rad/s²
    FloorPhase phase = FloorPhase::Rest;
};

struct BodyState {
    Vec2d position;
    Vec2d velocity;
    Place place = Place::Play;
    Spin<double> spin{};                 // rad/s; zero in a scene without friction
    FloorPhase phase = FloorPhase::Rest; // Rest in a scene without friction

    friend bool operator==(const BodyState&, const BodyState&) = default;
};

// A body that met another, or a wall.
struct Collision {
    double time = 0;
    int first = 0;          // index into Scene::bodies; less than second
    int second = -1;        // index, or -1 for a wall
    Side side = Side::Left; // which wall, where second is -1
    int group = 0;          // contacts of the same instant share a number from 1; 0: alone
    int pass = 0;           // in a group: those resolved together share a pass, from 1; 0: alone
    int together = 1;       // how many contacts were resolved in that pass
    PairCollision<double> steps;

    bool isWall() const { return second < 0; }
    bool involves(int body) const { return first == body || second == body; }
};

// A body that left the lane: into a gutter, or over the end into the pit.
struct Departure {
    double time = 0;
    int body = 0;
    Place place = Place::Gutter;
};

// Two bodies, or a body and a wall, that were pressed together by friction and stayed together.
struct LastingContact {
    double from = 0;
    double to = 0;
    int first = 0;
    int second = -1;        // as in Collision
    Side side = Side::Left; // which wall, where second is -1
};

enum class EndReason { Until, AtRest, NoMoreCollisions, MaxCollisions };

// What the engine wrote down, in the order in which it happened.
struct TimelineRecord {
    struct BodySegment {
        int body = 0;
        Segment segment;
    };
    std::vector<BodySegment> segments; // every body's first one at time 0
    std::vector<Rotation> rotations;   // of the segments, one each; none without friction
    std::vector<Collision> collisions;
    std::vector<Departure> departures;
    std::vector<LastingContact> lasting;
    std::vector<double> struckSpeeds; // of the bodies, or none
    std::int64_t collisionCount = 0;  // may exceed collisions.size(): a summary keeps none
    double endTime = 0;
    EndReason endReason = EndReason::Until;
};

class Timeline {
public:
    Timeline() = default;
    Timeline(std::size_t bodyCount, TimelineRecord record);

    std::size_t bodyCount() const { return m_firstSegment.empty() ? 0 : m_firstSegment.size() - 1; }
    double endTime() const { return m_endTime; }
    EndReason endReason() const { return m_endReason; }
    std::int64_t collisionCount() const { return m_collisionCount; }

    // In the order of time; the k-th has the number k + 1.
    std::span<const Collision> collisions() const { return m_collisions; }
    std::span<const Departure> departures() const { return m_departures; }

    std::span<const LastingContact> lastingContacts() const { return m_lasting; }

    // A body's stretches of motion, in the order of time: its path. The last one lasts to the end.
    std::span<const Segment> segments(std::size_t body) const;
    // How it turns in each of them; empty in a scene without friction.
    std::span<const Rotation> rotations(std::size_t body) const;

    // The greatest speed that any of its collisions left the body with [m/s]; 0 where it had none. A summary
    // knows it, too.
    double struckSpeed(std::size_t body) const {
        return body < m_struckSpeeds.size() ? m_struckSpeeds[body] : 0;
    }

    // The state at t, clamped to [0, endTime()]. At the very time of an event: after it.
    BodyState bodyAt(std::size_t body, double t) const;
    std::vector<BodyState> stateAt(double t) const;
    void stateAt(double t,
                 std::vector<BodyState>& states) const; // into a vector that is kept, for every frame

    // Indices into collisions(): the last one strictly before t, the first one strictly after t.
    std::optional<std::size_t> collisionBefore(double t) const;
    std::optional<std::size_t> collisionAfter(double t) const;

private:
    std::vector<Segment> m_segments;         // all bodies', body by body
    std::vector<Rotation> m_rotations;       // in the same order, or none
    std::vector<std::size_t> m_firstSegment; // of each body; one past the last body's at the end
    std::vector<Collision> m_collisions;
    std::vector<Departure> m_departures;
    std::vector<LastingContact> m_lasting;
    std::vector<double> m_struckSpeeds;
    std::int64_t m_collisionCount = 0;
    double m_endTime = 0;
    EndReason m_endReason = EndReason::Until;
};

// Sums over all bodies: momentum [kg·m/s], kinetic energy [J].
struct Totals {
    Vec2d momentum;
    double energy = 0;
};
Totals totals(const Scene& scene, std::span<const BodyState> states);

} // namespace thetalane

// Contacts that last: friction presses bodies together, and they move on with just the forces that keep their
// gaps, until one is no longer pressed.
//
// The gap of two touching bodies opens with n·(a₁ - a₂) + w²/Z, n the line of centres, w the velocity across
// it. Where that is negative they are pressed; the least forces F >= 0 that make it 0 are found for all
// contacts of a cluster at once, as impulses are (core/collision/contact_group.h). They hold for a short
// while, in which the line of centres hardly turns, and are found anew.
#pragma once

#include "core/collision/contact_group.h"
#include "core/engine/contact_cluster.h"
#include "core/engine/floor_motion.h"

namespace thetalane {

template <class Real> class Pressing {
public:
    using Index = std::size_t;
    using Discs = MovingDiscs<Real, true>;
    using Touches = std::vector<Touch<Real>>;
    using Velocities = std::vector<Vec2<Real>>;

    Pressing(const FloorMotion<Real>& floor, const Discs& discs, double contactTime)
        : m_floor(floor)
        , m_discs(discs)
        , m_contactTime(contactTime) {}

    // Whether, parting with velocities v, the two would be back within the contact time.
    bool lasts(const Touch<Real>& t, const Velocities& v) const {
        const Real rebound = opening(t, v);
        return rebound >= Real(0) && 2 * rebound <= -acceleration(t, v) * m_contactTime;
    }

    // The forces of a cluster whose bodies have velocities v. pushes(): each body's acceleration by them;
    // pressed(): the touches that last; holdsFor(): for how long.
    void solve(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        m_pushes.assign(bodies.size(), {});
        m_pressed.clear();
        m_holdsFor = Real(longestHold);
        for (Index k = 0; k < touches.size(); ++k)
            if (isPressed(touches[k], v))
                m_pressed.push_back(k);
        if (m_pressed.empty())
            return;
        for (const Index k : m_pressed)
            m_holdsFor = std::min(m_holdsFor, steadyFor(touches[k], v));
        find(bodies, touches, v);
    }
    const Velocities& pushes() const { return m_pushes; }
    const std::vector<Index>& pressed() const { return m_pressed; }
    const Real& holdsFor() const { return m_holdsFor; }

private:
    static constexpr double longestHold = 5e-3; // s

    // How fast the gap opens [m/s].
    Real opening(const Touch<Real>& t, const Velocities& v) const {
        return dot(t.normal(), between(t, v[t.first], t.name.isWall() ? Vec2<Real>{} : v[t.second]));
    }
    static Vec2<Real> between(const Touch<Real>& t, const Vec2<Real>& first, const Vec2<Real>& second) {
        return t.name.isWall() ? first : first - second;
    }
    Vec2<Real> frictionOf(Index body, const Vec2<Real>& v) const {
        return m_floor.frictionAt(body, m_discs.position(body), v);
    }
    Vec2<Real> relativeFriction(const Touch<Real>& t, const Velocities& v) const {
        const Vec2<Real> first = frictionOf(t.name.first, v[t.first]);
        return t.name.isWall() ? first : first - frictionOf(t.name.second, v[t.second]);
    }
    // How the opening changes: w²/Z for two discs, whose line of centres turns.
    Real turning(const Touch<Real>& t, const Velocities& v) const {
        if (t.name.isWall())
            return Real(0);
        const Real across = cross(t.normal(), v[t.first] - v[t.second]);
        return across * across / t.contact.Z;
    }
    Real acceleration(const Touch<Real>& t, const Velocities& v) const {
        return dot(t.normal(), relativeFriction(t, v)) + turning(t, v);
    }

    bool isPressed(const Touch<Real>& t, const Velocities& v) const {
        using std::abs;
        const Vec2<Real> a = relativeFriction(t, v);
        const Real closing = -(dot(t.normal(), a) + turning(t, v));
        const Real rounding = 65536 * std::numeric_limits<Real>::epsilon() * norm(a);
        return closing > rounding && 2 * abs(opening(t, v)) <= closing * m_contactTime;
    }

    // How long the gap stays within 1e-13 of the reach while the line of centres turns: it changes by
    // w b t³/2Z, b the relative acceleration across.
    Real steadyFor(const Touch<Real>& t, const Velocities& v) const {
        using std::abs;
        using std::pow;
        const Real shortest = m_contactTime / 16;
        if (t.name.isWall())
            return Real(longestHold);
        const Real w = abs(cross(t.normal(), v[t.first] - v[t.second]));
        const Real b = abs(cross(t.normal(), relativeFriction(t, v))) + w * w / t.contact.Z;
        const Real allowed = 2e-13 * t.contact.Z * t.contact.Z;
        if (!(w * b > Real(0)))
            return Real(longestHold);
        const Real time = Real(pow(Real(allowed / (w * b)), Real(1) / 3));
        return time > shortest ? time : shortest;
    }

    // The forces; a body at rest holds still until they exceed what friction can hold.
    void find(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        m_loose.assign(bodies.size(), {});
        std::vector<bool> held(bodies.size());
        for (Index b = 0; b < bodies.size(); ++b)
            held[b] = m_floor.wouldRest(bodies[b], v[b]);
        for (;;) {
            const auto solution = solveContacts<Real>(demands(touches, v), inverseMasses(bodies, v, held));
            if (!loosen(bodies, touches, solution.impulse, held)) {
                for (Index b = 0; b < bodies.size(); ++b)
                    m_pushes[b] = solution.change[b] + (held[b] ? Vec2<Real>{} : m_loose[b]);
                keepThoseThatPush(solution.impulse);
                return;
            }
        }
    }

    std::vector<GroupContact<Real>> demands(const Touches& touches, const Velocities& v) const {
        std::vector<GroupContact<Real>> contacts;
        for (const Index k : m_pressed) {
            const Touch<Real>& t = touches[k];
            const bool wall = t.name.isWall();
            Real demand = acceleration(t, v) + opening(t, v) / m_holdsFor;
            demand += dot(t.normal(), between(t, m_loose[t.first], wall ? Vec2<Real>{} : m_loose[t.second]));
            contacts.push_back({t.first, wall ? GroupContact<Real>::wall : t.second, t.normal(), demand});
        }
        return contacts;
    }

    std::vector<Real> inverseMasses(const std::vector<Index>& bodies, const Velocities& v,
                                    const std::vector<bool>& held) const {
        std::vector<Real> out;
        for (Index b = 0; b < bodies.size(); ++b)
            out.push_back(held[b]
                              ? Real(0)
                              : Real(1 / (m_discs.massOf(bodies[b]) * m_floor.slowness(bodies[b], v[b]))));
        return out;
    }

    // True if one more resting body gives way; friction then opposes the push.
    bool loosen(const std::vector<Index>& bodies, const Touches& touches, const std::vector<Real>& forces,
                std::vector<bool>& held) {
        for (Index b = 0; b < bodies.size(); ++b) {
            if (!held[b])
                continue;
            Vec2<Real> push;
            for (Index k = 0; k < m_pressed.size(); ++k) {
                const Touch<Real>& t = touches[m_pressed[k]];
                if (t.first == b)
                    push = push + t.normal() * forces[k];
                else if (t.second == b)
                    push = push - t.normal() * forces[k];
            }
            const Real holding = m_floor.holding(bodies[b]), size = norm(push);
            if (!(size > holding * m_discs.massOf(bodies[b])))
                continue;
            held[b] = false;
            m_loose[b] = push * (-holding / size);
            return true;
        }
        return false;
    }

    void keepThoseThatPush(const std::vector<Real>& forces) {
        Index kept = 0;
        for (Index k = 0; k < m_pressed.size(); ++k)
            if (forces[k] > Real(0))
                m_pressed[kept++] = m_pressed[k];
        m_pressed.resize(kept);
    }

    const FloorMotion<Real>& m_floor;
    const Discs& m_discs;
    Real m_contactTime;
    Velocities m_pushes;
    Velocities m_loose; // friction on those that gave way
    std::vector<Index> m_pressed;
    Real m_holdsFor{};
};

} // namespace thetalane

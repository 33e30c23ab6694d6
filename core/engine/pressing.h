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

    // A contact that would part no faster than this would be back within the contact time; 0 if nothing
    // presses it. Among several, one may be pressed by what presses another.
    Real slowestRebound(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        lookAt(bodies, touches, v);
        const Real closing = touches.size() > 1 ? strongest(touches) : Real(-acceleration(touches[0], v));
        return closing > Real(0) ? Real(closing * m_contactTime / 2) : Real(0);
    }

    // What friction would stop within a thousandth of the contact time is at rest [m/s].
    Real restingSpeed(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        lookAt(bodies, touches, v);
        return strongest(touches) * m_contactTime * Real(1e-3f);
    }

    // The forces of a cluster whose bodies have velocities v. pushes(): each body's acceleration by them;
    // pressed(): the touches that last; holdsFor(): for how long.
    void solve(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        m_pushes.assign(bodies.size(), {});
        m_pressed.clear();
        m_holdsFor = Real(longestHold);
        if (touches.empty())
            return;
        lookAt(bodies, touches, v);
        if (!anyPressed(touches, v))
            return;
        const Real slow = strongest(touches) * m_contactTime / 2;
        for (Index k = 0; k < touches.size(); ++k)
            if (const Real u = opening(touches[k], v); u <= slow && -u <= slow)
                m_pressed.push_back(k);
        for (const Index k : m_pressed)
            m_holdsFor = std::min(m_holdsFor, steadyFor(touches[k], v));
        ease(bodies, touches, v);
        do
            find(bodies, touches, v);
        while (harden(v));
        keepThoseThatLast(touches, v);
        for (Index b = 0; b < bodies.size(); ++b) // on the floor it meets friction as it is
            m_pushes[b] = m_pushes[b] + m_friction[b] * (1 - 1 / m_ease[b]);
    }
    const Velocities& pushes() const { return m_pushes; }
    const std::vector<Index>& pressed() const { return m_pressed; }
    const Real& holdsFor() const { return m_holdsFor; }

    // As the floor lets them be moved: not at all where they are at rest.
    std::vector<Real> inverseMasses(const std::vector<Index>& bodies, const Velocities& v) const {
        return inverseMasses(bodies, v, resting(bodies, v));
    }

private:
    using Contacts = std::vector<GroupContact<Real>>;
    static constexpr double longestHold = 5e-3; // s
    static constexpr double creeping = 1e-13;   // of a contact's Z

    // Of the first body relative to the second, or to a wall; what is kept by the bodies' places.
    static Vec2<Real> between(const Touch<Real>& t, const Velocities& of, const Vec2<Real>& wall) {
        return of[t.first] - (t.name.isWall() ? wall : of[t.second]);
    }
    // How fast the gap opens, and how fast they slide by each other [m/s].
    Real opening(const Touch<Real>& t, const Velocities& v) const {
        return dot(t.normal(), between(t, v, {}));
    }
    Real across(const Touch<Real>& t, const Velocities& v) const {
        return cross(t.normal(), between(t, v, {}));
    }
    // What friction does to each body that touches another, which is asked for again and again.
    void lookAt(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        m_friction.resize(bodies.size());
        m_seen.assign(bodies.size(), false);
        const auto look = [&](Index b) {
            if (!m_seen[b])
                m_friction[b] = m_floor.frictionAt(bodies[b], m_discs.position(bodies[b]), v[b]);
            m_seen[b] = true;
        };
        for (const Touch<Real>& t : touches) {
            look(t.first);
            if (!t.name.isWall())
                look(t.second);
        }
    }
    Vec2<Real> relativeFriction(const Touch<Real>& t) const { return between(t, m_friction, {}); }
    // How the opening changes: w²/Z for two discs, whose line of centres turns.
    Real turning(const Touch<Real>& t, const Velocities& v) const {
        if (t.name.isWall())
            return Real(0);
        const Real w = across(t, v);
        return w * w / t.contact.Z;
    }
    Real acceleration(const Touch<Real>& t, const Velocities& v) const {
        return dot(t.normal(), relativeFriction(t)) + turning(t, v);
    }

    // The largest difference that friction makes between two that touch [m/s²].
    Real strongest(const Touches& touches) const {
        Real most(0);
        for (const Touch<Real>& t : touches)
            most = std::max(most, norm(relativeFriction(t)));
        return most;
    }

    // Friction turns with the velocity it opposes, but for a ball that slips. A body that is pushed along so
    // slowly that it would turn within the contact time takes the friction that its velocity has at the end
    // of the hold, where k = |a|/|v| stays: v' = v + h (F/m - k v') is 1/(1 + k h) of what friction at the
    // start and F alone would add. It neither overshoots nor sets the friction to and fro.
    void ease(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        m_ease.assign(bodies.size(), Real(1));
        const auto look = [&](Index b) {
            const Real slowing = norm(m_friction[b]), speed = norm(v[b]);
            if (m_ease[b] < Real(1) || m_floor.slips(bodies[b], v[b]) || !(speed > Real(0)) ||
                !(speed < slowing * m_contactTime))
                return;
            m_ease[b] = speed / (speed + slowing * m_holdsFor);
            m_friction[b] = m_friction[b] * m_ease[b];
        };
        for (const Index k : m_pressed) {
            look(touches[k].first);
            if (!touches[k].name.isWall())
                look(touches[k].second);
        }
    }

    // Where a push turns out to oppose the velocity, the friction of the end would drive the body until then:
    // it takes what there is at the start, after all. True if there is such a body.
    bool harden(const Velocities& v) {
        bool changed = false;
        for (Index b = 0; b < m_ease.size(); ++b) {
            const Real left = m_ease[b];
            if (!(left < Real(1)) || !(dot(v[b], m_friction[b] - m_pushes[b] * (1 / left - 1)) > Real(0)))
                continue;
            m_friction[b] = m_friction[b] * (1 / left);
            m_ease[b] = Real(1);
            changed = true;
        }
        return changed;
    }

    // By friction alone, be it by rounding, or the contact would be met again at once; and not about to part.
    bool anyPressed(const Touches& touches, const Velocities& v) const {
        return std::any_of(touches.begin(), touches.end(), [&](const Touch<Real>& t) {
            const Real closing = -acceleration(t, v);
            return closing > Real(0) && 2 * opening(t, v) <= closing * m_contactTime;
        });
    }

    // How long until the gap has opened by a quarter of what a held contact may drift: the terms in t⁴ of
    //     |Z n + (w t + ½ b t²) τ - ½ (w²/Z) t² n|, b the relative acceleration across.
    // Where a body was stopped between others, one may still creep upon another, which the force then takes
    // up by the end: soon enough not to be seen in the gap.
    Real steadyFor(const Touch<Real>& t, const Velocities& v) const {
        using std::sqrt;
        const Real creep = -opening(t, v), least = Real(m_contactTime / 16);
        if (creep > Real(0) && creep * longestHold > t.contact.Z * creeping)
            return std::max(Real(t.contact.Z * creeping / creep), least);
        if (t.name.isWall())
            return Real(longestHold);
        const Real Z = t.contact.Z, w = across(t, v), b = norm(relativeFriction(t));
        const Real growth = (w * w * w * w / (Z * Z) + b * b) / (8 * Z);
        if (!(growth > Real(0)))
            return Real(longestHold);
        const Real time = sqrt(sqrt(Real(heldSlack<Real>(Z) / 4 / growth)));
        return std::min(Real(longestHold), std::max(time, least));
    }

    // The forces; a body at rest holds still until they exceed what friction can hold. How the line of
    // centres goes on turning depends on the forces themselves: a few rounds settle that.
    void find(const std::vector<Index>& bodies, const Touches& touches, const Velocities& v) {
        m_loose.assign(bodies.size(), {});
        std::vector<bool> held = resting(bodies, v);
        m_settled.assign(bodies.size(), false);
        GroupSolution<Real> solution;
        Contacts asked;
        for (int round = 0; round < 4;) {
            Contacts contacts = demands(touches, v);
            if (round > 0 && sameDemands(contacts, asked))
                break; // and the same answer
            asked = std::move(contacts);
            solution = solveForces<Real>(asked, mobilities(bodies, v, held));
            for (Index b = 0; b < bodies.size(); ++b)
                m_pushes[b] = solution.change[b] + (held[b] ? Vec2<Real>{} : m_loose[b]);
            const bool changed = loosen(bodies, touches, solution.impulse, held) || stick(held);
            round = changed ? 0 : round + 1;
        }
        m_forces = std::move(solution.impulse);
    }

    std::vector<bool> resting(const std::vector<Index>& bodies, const Velocities& v) const {
        std::vector<bool> out(bodies.size());
        for (Index b = 0; b < bodies.size(); ++b)
            out[b] = m_floor.wouldRest(bodies[b], v[b]);
        return out;
    }

    static bool sameDemands(const Contacts& a, const Contacts& b) {
        return std::equal(a.begin(), a.end(), b.begin(),
                          [](const auto& x, const auto& y) { return x.demand == y.demand; });
    }

    // One that gave way, yet is not moved the way it was pushed, held still after all: true if there is one.
    bool stick(std::vector<bool>& held) {
        for (Index b = 0; b < held.size(); ++b) {
            if (held[b] || m_loose[b] == Vec2<Real>{} || dot(m_pushes[b], m_loose[b]) < Real(0))
                continue;
            held[b] = m_settled[b] = true;
            m_loose[b] = {};
            return true;
        }
        return false;
    }

    // By how much each gap would open: the acceleration now; what brings a gap that has drifted back to
    // nothing by the end of the hold; and, where the turning slows (w b < 0), what keeps the gap from closing
    // as it does.
    Contacts demands(const Touches& touches, const Velocities& v) const {
        Contacts contacts;
        for (const Index k : m_pressed) {
            const Touch<Real>& t = touches[k];
            Real demand =
                acceleration(t, v) + opening(t, v) / m_holdsFor + dot(t.normal(), between(t, m_loose, {}));
            if (!t.name.isWall()) {
                const Real drift = driftOf(t);
                const Real slowing =
                    across(t, v) * cross(t.normal(), relativeFriction(t) + between(t, m_pushes, {}));
                demand += 2 * drift / (m_holdsFor * m_holdsFor);
                if (slowing < Real(0))
                    demand += slowing * m_holdsFor / t.contact.Z;
            }
            contacts.push_back(
                {t.first, t.name.isWall() ? GroupContact<Real>::wall : t.second, t.normal(), demand});
        }
        return contacts;
    }

    // By how much a gap has opened; what is rounding is no drift, and not worth a force.
    Real driftOf(const Touch<Real>& t) const {
        using std::abs;
        const Vec2<Real> p = m_discs.position(t.name.first);
        const Real drift = t.contact.Z - m_discs.radiusOf(t.name.first) - m_discs.radiusOf(t.name.second);
        const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (abs(p.x) + abs(p.y) + t.contact.Z);
        return drift > -rounding && drift < rounding + t.contact.Z * creeping ? Real(0) : drift;
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
    std::vector<Real> mobilities(const std::vector<Index>& bodies, const Velocities& v,
                                 const std::vector<bool>& held) const {
        std::vector<Real> out = inverseMasses(bodies, v, held);
        for (Index b = 0; b < bodies.size(); ++b)
            out[b] = out[b] * m_ease[b];
        return out;
    }

    // True if one more resting body gives way; friction then opposes the push.
    bool loosen(const std::vector<Index>& bodies, const Touches& touches, const std::vector<Real>& forces,
                std::vector<bool>& held) {
        for (Index b = 0; b < bodies.size(); ++b) {
            if (!held[b] || m_settled[b])
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

    void keepThoseThatLast(const Touches& touches, const Velocities& v) {
        Index kept = 0;
        const Real rounding = strongest(touches) * Real(1e-10f);
        for (Index k = 0; k < m_pressed.size(); ++k)
            if (m_forces[k] > Real(0) || isBalanced(touches[m_pressed[k]], v, rounding))
                m_pressed[kept++] = m_pressed[k];
        m_pressed.resize(kept);
    }

    // The others' forces leave a contact neither pressed nor parting; it would be met again at once.
    bool isBalanced(const Touch<Real>& t, const Velocities& v, const Real& rounding) const {
        const auto isPushed = [&](Index b) { return norm(m_pushes[b]) > 1024 * rounding; };
        return (isPushed(t.first) || (!t.name.isWall() && isPushed(t.second))) &&
               opening(t, v) * m_holdsFor <= t.contact.Z * creeping &&
               acceleration(t, v) + dot(t.normal(), between(t, m_pushes, {})) <= rounding;
    }

    const FloorMotion<Real>& m_floor;
    const Discs& m_discs;
    Real m_contactTime;
    Velocities m_friction;
    std::vector<bool> m_seen;
    std::vector<Real> m_ease; // what is left of friction and push where they turn within the hold
    Velocities m_pushes;
    std::vector<Real> m_forces;  // of the pressed contacts
    Velocities m_loose;          // friction on those that gave way
    std::vector<bool> m_settled; // those that did not, after all
    std::vector<Index> m_pressed;
    Real m_holdsFor{};
};

} // namespace thetalane

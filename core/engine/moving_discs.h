// The discs of a running engine, a column for each quantity, so that one disc is compared with all others at
// once.
#pragma once

#include "core/collision/pair_collision.h"
#include "core/engine/traveller.h"
#include "core/engine/two.h"
#include "core/motion/impact.h"
#include "core/motion/quadratic_impact.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace thetalane {

// Each disc keeps its own time: its position and velocity are those it had at `since`, when its motion last
// changed. Accelerated: on a floor with friction it has an acceleration, too, which holds until `until`.
template <class Real, bool Accelerated> class MovingDiscs {
public:
    explicit MovingDiscs(const std::vector<Body>& bodies)
        : m_count(bodies.size())
        , m_stride(m_count + m_count % 2)
        , m_columns(columnCount * m_stride, Real(0)) {
        for (std::size_t i = 0; i < m_count; ++i) {
            at(X, i) = Real(bodies[i].position.x);
            at(Y, i) = Real(bodies[i].position.y);
            at(Vx, i) = Real(bodies[i].velocity.x);
            at(Vy, i) = Real(bodies[i].velocity.y);
            at(Radius, i) = Real(bodies[i].radius);
            at(Mass, i) = Real(bodies[i].mass);
        }
    }

    std::size_t count() const { return m_count; }
    Vec2<Real> velocity(std::size_t i) const { return {at(Vx, i), at(Vy, i)}; } // at since(i)
    Vec2<Real> position(std::size_t i) const { return {at(X, i), at(Y, i)}; }   // at since(i)
    Real since(std::size_t i) const { return at(Since, i); }
    Real massOf(std::size_t i) const { return at(Mass, i); }
    Real radiusOf(std::size_t i) const { return at(Radius, i); }
    Disc<Real> disc(std::size_t i) const { return {massOf(i), radiusOf(i), position(i), velocity(i)}; }

    Vec2<Real> acceleration(std::size_t i) const {
        if constexpr (Accelerated)
            return {at(Ax, i), at(Ay, i)};
        return {};
    }
    Real until(std::size_t i) const {
        if constexpr (Accelerated)
            return at(Until, i);
        return std::numeric_limits<Real>::infinity();
    }

    Vec2<Real> positionAt(std::size_t i, const Real& now) const {
        const Real elapsed = now - since(i);
        if constexpr (Accelerated)
            return position(i) + (velocity(i) + acceleration(i) * (elapsed / 2)) * elapsed;
        return {at(X, i) + at(Vx, i) * elapsed, at(Y, i) + at(Vy, i) * elapsed};
    }
    Vec2<Real> velocityAt(std::size_t i, const Real& now) const {
        if constexpr (Accelerated)
            return velocity(i) + acceleration(i) * Real(now - since(i));
        return velocity(i);
    }

    void moveTo(std::size_t i, const Real& now) { put(i, positionAt(i, now), velocityAt(i, now), now); }
    void put(std::size_t i, const Vec2<Real>& position, const Vec2<Real>& velocity, const Real& now) {
        at(X, i) = position.x;
        at(Y, i) = position.y;
        at(Since, i) = now;
        setVelocity(i, velocity);
    }
    void setVelocity(std::size_t i, const Vec2<Real>& v) {
        at(Vx, i) = v.x;
        at(Vy, i) = v.y;
    }
    void setAcceleration(std::size_t i, const Vec2<Real>& a, const Real& until) {
        static_assert(Accelerated);
        at(Ax, i) = a.x;
        at(Ay, i) = a.y;
        at(Until, i) = until;
    }

    bool allAtRest() const {
        for (std::size_t i = 0; i < m_count; ++i)
            if (!(velocity(i) == Vec2<Real>{}))
                return false;
        return true;
    }

    // in[j] for j in [from, count()): the time from now until free discs i and j touch and approach; infinity
    // for never.
    void timesToImpact(std::size_t i, std::size_t from, const Real& now, Real* __restrict in) const {
        static_assert(!Accelerated);
        const Vec2<Real> p = positionAt(i, now);
        const Vec2<Real> v = velocity(i);
        const Real speed2 = dot(v, v);
        const Real r = radiusOf(i);
        for (std::size_t j = from; j < m_count; ++j) {
            const Vec2<Real> u = velocity(j);
            in[j] = timeToImpact<Real>(p - positionAt(j, now), v - u, r + radiusOf(j), speed2 + dot(u, u));
        }
    }

    // The time from now until the traveller and disc j touch and approach; infinity for never, or not before
    // one of the two moves otherwise, or not before `last`.
    Real timeToImpactWith(const Traveller<Real>& t, std::size_t j, const Real& now, const Real& last) const {
        static_assert(Accelerated);
        const Vec2<Real> u = velocityAt(j, now);
        const Real horizon = std::min(std::min(t.until, until(j)), last) - now;
        return timeToImpact<Real>(t.p - positionAt(j, now), t.v - u, t.a - acceleration(j),
                                  t.radius + radiusOf(j), dot(t.v, t.v) + dot(u, u), horizon);
    }

    // Of discs j and j + 1, j even, the bits 0 and 1: whether bounds alone leave it open that the traveller
    // meets it so; see timeToImpactWith().
    unsigned mayMeet(const Traveller<Real>& t, std::size_t j, const Real& now, const Real& last) const {
        if constexpr (!std::is_floating_point_v<Real>) {
            return j + 1 < m_count ? 3 : 1;
        } else {
            using Both = Two<Real>;
            const auto both = [](const Real& x) { return Both{x, x}; };
            const Both elapsed = both(now) - two(Since, j), until = two(Until, j);
            const Both ax = two(Ax, j), ay = two(Ay, j), vx = two(Vx, j), vy = two(Vy, j);
            const Both x = two(X, j) + (vx + ax * (elapsed / 2)) * elapsed;
            const Both y = two(Y, j) + (vy + ay * (elapsed / 2)) * elapsed;
            const Vec2<Both> dp{t.p.x - x, t.p.y - y}, da{t.a.x - ax, t.a.y - ay};
            const Vec2<Both> dv{t.v.x - (vx + ax * elapsed), t.v.y - (vy + ay * elapsed)};
            const Both reach = t.radius + two(Radius, j);
            const Real soonest = std::min(t.until, last);
            const Both horizon = (until < soonest ? until : both(soonest)) - now;
            const auto apart = staysApart<Both>(dp, dv, da, reach * reach, horizon) &
                               isBounded<Both>(dv, da, horizon, both(std::numeric_limits<Real>::infinity()));
            return ~bitsOf(apart) & (j + 1 < m_count ? 3 : 1);
        }
    }

private:
    enum Column { X, Y, Vx, Vy, Since, Radius, Mass, Ax, Ay, Until };
    static constexpr std::size_t columnCount = Accelerated ? Until + 1 : Mass + 1;
    Real& at(Column c, std::size_t i) { return m_columns[c * m_stride + i]; }
    auto two(Column c, std::size_t i) const {
        Two<Real> pair;
        std::memcpy(&pair, &at(c, i), sizeof pair);
        return pair;
    }
    const Real& at(Column c, std::size_t i) const { return m_columns[c * m_stride + i]; }

    std::size_t m_count;
    std::size_t m_stride; // a column's length: two at a time
    std::vector<Real> m_columns;
};

} // namespace thetalane

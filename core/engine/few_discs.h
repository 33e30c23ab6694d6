// The discs of a running engine where they are few and free: columns of a fixed length, which cost no
// allocation and are read two at a time.
#pragma once

#include "core/collision/pair_collision.h"
#include "core/engine/two.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace thetalane {

template <class Real> class FewDiscs {
public:
    static constexpr std::size_t most = 32;
    using Two = thetalane::Two<Real>;

    explicit FewDiscs(const std::vector<Body>& bodies)
        : m_count(bodies.size()) {
        for (std::size_t i = 0; i < m_count; ++i) {
            const Body& b = bodies[i];
            put(X, i, Real(b.position.x));
            put(Y, i, Real(b.position.y));
            put(Vx, i, Real(b.velocity.x));
            put(Vy, i, Real(b.velocity.y));
            put(Since, i, Real(0));
            put(Radius, i, Real(b.radius));
            m_mass[i] = Real(b.mass);
        }
        if (m_count % 2 != 0) { // which nobody meets
            for (const Column c : {X, Y, Vx, Vy, Since})
                put(c, m_count, Real(0));
            put(Radius, m_count, std::numeric_limits<Real>::quiet_NaN());
        }
    }

    std::size_t count() const { return m_count; }
    std::size_t pairs() const { return (m_count + 1) / 2; }

    Vec2<Real> velocity(std::size_t i) const { return {at(Vx, i), at(Vy, i)}; }
    Vec2<Real> position(std::size_t i) const { return {at(X, i), at(Y, i)}; } // at since(i)
    Real since(std::size_t i) const { return at(Since, i); }
    Real massOf(std::size_t i) const { return m_mass[i]; }
    Real radiusOf(std::size_t i) const { return at(Radius, i); }
    Disc<Real> disc(std::size_t i) const { return {massOf(i), radiusOf(i), position(i), velocity(i)}; }
    Vec2<Real> acceleration(std::size_t) const { return {}; }

    Vec2<Real> positionAt(std::size_t i, const Real& now) const {
        const Real elapsed = now - since(i);
        return {at(X, i) + at(Vx, i) * elapsed, at(Y, i) + at(Vy, i) * elapsed};
    }
    Vec2<Real> velocityAt(std::size_t i, const Real&) const { return velocity(i); }

    void moveTo(std::size_t i, const Real& now) {
        const Vec2<Real> p = positionAt(i, now);
        put(X, i, p.x);
        put(Y, i, p.y);
        put(Since, i, now);
    }
    void setVelocity(std::size_t i, const Vec2<Real>& v) {
        put(Vx, i, v.x);
        put(Vy, i, v.y);
    }

    bool allAtRest() const {
        for (std::size_t i = 0; i < m_count; ++i)
            if (!(velocity(i) == Vec2<Real>{}))
                return false;
        return true;
    }

    // Discs 2k and 2k + 1.
    struct Couple {
        Two x, y, vx, vy, radius;
    };
    Couple coupleAt(std::size_t k, Two now) const {
        const Two vx = m_columns[Vx][k], vy = m_columns[Vy][k];
        const Two elapsed = now - m_columns[Since][k];
        return {m_columns[X][k] + vx * elapsed, m_columns[Y][k] + vy * elapsed, vx, vy, m_columns[Radius][k]};
    }

private:
    enum Column { X, Y, Vx, Vy, Since, Radius };
    static constexpr std::size_t columnCount = Radius + 1;

    Real at(Column c, std::size_t i) const { return m_columns[c][i / 2][i % 2]; }
    void put(Column c, std::size_t i, const Real& value) { putInto(m_columns[c], i, value); }

    std::size_t m_count;
    Two m_columns[columnCount][most / 2];
    Real m_mass[most];
};

} // namespace thetalane

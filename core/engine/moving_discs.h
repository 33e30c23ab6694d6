// The discs of a running engine, a column for each quantity, so that one disc is compared with all others at
// once.
#pragma once

#include "core/collision/pair_collision.h"
#include "core/motion/impact.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <vector>

namespace thetalane {

// Each disc keeps its own time: its position is the one it had at `since`, when its velocity last changed.
template <class Real> class MovingDiscs {
public:
    explicit MovingDiscs(const std::vector<Body>& bodies)
        : m_count(bodies.size())
        , m_columns(columnCount * m_count, Real(0)) {
        for (std::size_t i = 0; i < m_count; ++i) {
            x()[i] = Real(bodies[i].position.x);
            y()[i] = Real(bodies[i].position.y);
            vx()[i] = Real(bodies[i].velocity.x);
            vy()[i] = Real(bodies[i].velocity.y);
            radius()[i] = Real(bodies[i].radius);
            mass()[i] = Real(bodies[i].mass);
        }
    }

    std::size_t count() const { return m_count; }
    Vec2<Real> velocity(std::size_t i) const { return {vx()[i], vy()[i]}; }
    Vec2<Real> position(std::size_t i) const { return {x()[i], y()[i]}; } // at since(i)
    Real since(std::size_t i) const { return since()[i]; }

    Vec2<Real> positionAt(std::size_t i, const Real& now) const {
        const Real elapsed = now - since()[i];
        return {x()[i] + vx()[i] * elapsed, y()[i] + vy()[i] * elapsed};
    }

    void moveTo(std::size_t i, const Real& now) {
        const Vec2<Real> p = positionAt(i, now);
        x()[i] = p.x;
        y()[i] = p.y;
        since()[i] = now;
    }

    void setVelocity(std::size_t i, const Vec2<Real>& v) {
        vx()[i] = v.x;
        vy()[i] = v.y;
    }

    Disc<Real> disc(std::size_t i) const { return {mass()[i], radius()[i], position(i), velocity(i)}; }
    Real radiusOf(std::size_t i) const { return radius()[i]; }

    bool allAtRest() const {
        for (std::size_t i = 0; i < m_count; ++i)
            if (vx()[i] != Real(0) || vy()[i] != Real(0))
                return false;
        return true;
    }

    // in[j] for j in [from, count()): the time from now until discs i and j touch and approach; infinity for
    // never.
    void timesToImpact(std::size_t i, std::size_t from, const Real& now, Real* __restrict in) const {
        const Vec2<Real> p = positionAt(i, now);
        const Vec2<Real> v = velocity(i);
        const Real speed2 = dot(v, v);
        const Real r = radius()[i];
        const Real *const xs = x(), *const ys = y(), *const us = vx(), *const ws = vy(), *const ts = since(),
                          *const rs = radius();
        for (std::size_t j = from; j < m_count; ++j) {
            const Real elapsed = now - ts[j];
            const Vec2<Real> u{us[j], ws[j]};
            const Vec2<Real> q{xs[j] + u.x * elapsed, ys[j] + u.y * elapsed};
            in[j] = timeToImpact<Real>(p - q, v - u, r + rs[j], speed2 + dot(u, u));
        }
    }

private:
    static constexpr std::size_t columnCount = 7;
    Real* column(std::size_t k) { return m_columns.data() + k * m_count; }
    const Real* column(std::size_t k) const { return m_columns.data() + k * m_count; }
    Real* x() { return column(0); }
    Real* y() { return column(1); }
    Real* vx() { return column(2); }
    Real* vy() { return column(3); }
    Real* since() { return column(4); }
    Real* radius() { return column(5); }
    Real* mass() { return column(6); }
    const Real* x() const { return column(0); }
    const Real* y() const { return column(1); }
    const Real* vx() const { return column(2); }
    const Real* vy() const { return column(3); }
    const Real* since() const { return column(4); }
    const Real* radius() const { return column(5); }
    const Real* mass() const { return column(6); }

    std::size_t m_count;
    std::vector<Real> m_columns;
};

} // namespace thetalane

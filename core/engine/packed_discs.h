// The discs of a running engine, a cache line for each, so that a disc among many is fetched at once.
#pragma once

#include "core/collision/pair_collision.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

namespace thetalane {

// Where a disc was at `since`, when its velocity last changed, and its place among its neighbours.
template <class Real> struct alignas(sizeof(Real) == 8 ? 64 : alignof(Real)) PackedDisc {
    Vec2<Real> position;
    Vec2<Real> velocity;
    Real since{0};
    Real radius{};
    std::uint32_t changes = 0; // of course, so far: an event that counted on an earlier one is void
    std::uint16_t column = 0;  // of its cell
    std::uint16_t row = 0;
    Real mass{1};

    Vec2<Real> positionAt(const Real& now) const {
        const Real elapsed = now - since;
        return {position.x + velocity.x * elapsed, position.y + velocity.y * elapsed};
    }
};
static_assert(sizeof(PackedDisc<double>) == 64);

template <class Real> class PackedDiscs {
public:
    explicit PackedDiscs(const std::vector<Body>& bodies) {
        m_discs.reserve(bodies.size());
        for (const Body& b : bodies)
            m_discs.push_back({convert<Real>(b.position), convert<Real>(b.velocity), Real(0), Real(b.radius),
                               0, 0, 0, Real(b.mass)});
    }

    std::size_t count() const { return m_discs.size(); }
    PackedDisc<Real>& operator[](std::size_t i) { return m_discs[i]; }
    const PackedDisc<Real>& operator[](std::size_t i) const { return m_discs[i]; }

    Vec2<Real> velocity(std::size_t i) const { return m_discs[i].velocity; }
    Vec2<Real> position(std::size_t i) const { return m_discs[i].position; } // at since(i)
    Real since(std::size_t i) const { return m_discs[i].since; }

    void moveTo(std::size_t i, const Real& now) {
        m_discs[i].position = m_discs[i].positionAt(now);
        m_discs[i].since = now;
    }
    Vec2<Real> positionAt(std::size_t i, const Real& now) const { return m_discs[i].positionAt(now); }
    Vec2<Real> velocityAt(std::size_t i, const Real&) const { return m_discs[i].velocity; }
    Vec2<Real> acceleration(std::size_t) const { return {}; }
    Real massOf(std::size_t i) const { return m_discs[i].mass; }
    Real radiusOf(std::size_t i) const { return m_discs[i].radius; }
    void setVelocity(std::size_t i, const Vec2<Real>& v) { m_discs[i].velocity = v; }

    Disc<Real> disc(std::size_t i) const {
        return {m_discs[i].mass, m_discs[i].radius, m_discs[i].position, m_discs[i].velocity};
    }

    bool allAtRest() const {
        for (const auto& d : m_discs)
            if (!(d.velocity == Vec2<Real>{}))
                return false;
        return true;
    }

private:
    std::vector<PackedDisc<Real>> m_discs;
};

} // namespace thetalane

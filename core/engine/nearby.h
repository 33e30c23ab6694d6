// The discs about one disc, brought together in columns, so that their times to impact are found two at a
// time and nothing has to be guessed.
#pragma once

#include "core/engine/packed_discs.h"
#include "core/motion/impact.h"

#include <cstddef>
#include <limits>

namespace thetalane {

template <class Real> class Nearby {
public:
    Nearby(const PackedDisc<Real>& disc, const Real& now)
        : m_now(now)
        , m_p(disc.positionAt(now))
        , m_v(disc.velocity)
        , m_radius(disc.radius)
        , m_speed2(dot(m_v, m_v)) {}

    struct Meeting {
        Real time;
        std::uint32_t partner;
    };
    // The earliest with one of the `count` discs named in `who`, if earlier than `best`. Of equals the first
    // in the scene, as if all were asked in turn. `plays(j)`: whether j can be met at all.
    template <class Plays>
    Meeting earliest(const PackedDiscs<Real>& discs, const std::uint32_t* who, std::size_t count,
                     Meeting best, Plays&& plays) {
        for (; count > atOnce; who += atOnce, count -= atOnce)
            best = earliestOfFew(discs, who, atOnce, best, plays);
        return earliestOfFew(discs, who, count, best, plays);
    }

private:
    static constexpr std::size_t atOnce = 16;

    template <class Plays>
    [[gnu::flatten]] Meeting earliestOfFew(const PackedDiscs<Real>& discs, const std::uint32_t* who,
                                           std::size_t count, Meeting best, Plays&& plays) {
        for (std::size_t k = 0; k < count; ++k)
            compare(k, discs[who[k]]);
        for (std::size_t k = 0; k < count; ++k)
            m_in[k] = timeToImpact<Real>({m_x[k], m_y[k]}, {m_vx[k], m_vy[k]}, m_reach[k], m_speeds2[k]);
        for (std::size_t k = 0; k < count; ++k) {
            const Real time = m_now + m_in[k];
            const bool sooner = (time < best.time) | ((time == best.time) & (who[k] < best.partner));
            if (sooner && m_in[k] < std::numeric_limits<Real>::infinity() && plays(who[k]))
                best = {time, who[k]};
        }
        return best;
    }

    void compare(std::size_t k, const PackedDisc<Real>& other) {
        const Vec2<Real> p = m_p - other.positionAt(m_now);
        const Vec2<Real> v = m_v - other.velocity;
        m_x[k] = p.x;
        m_y[k] = p.y;
        m_vx[k] = v.x;
        m_vy[k] = v.y;
        m_reach[k] = m_radius + other.radius;
        m_speeds2[k] = m_speed2 + dot(other.velocity, other.velocity);
    }

    Real m_now;
    Vec2<Real> m_p;
    Vec2<Real> m_v;
    Real m_radius;
    Real m_speed2;
    Real m_x[atOnce], m_y[atOnce], m_vx[atOnce], m_vy[atOnce], m_reach[atOnce], m_speeds2[atOnce],
        m_in[atOnce];
};

} // namespace thetalane

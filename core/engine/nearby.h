// The discs about one disc: when it meets the first of them, and when the next.
#pragma once

#include "core/engine/packed_discs.h"
#include "core/engine/two.h"
#include "core/motion/impact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace thetalane {

// The earliest of the meetings looked at, and when the next of them comes.
template <class Real> struct Meeting {
    Real time = std::numeric_limits<Real>::infinity();
    Real next = std::numeric_limits<Real>::infinity();
    std::uint32_t partner = 0;
};

// A disc as it is now, to be compared with others. Two at a time, which every processor with vectors does for
// the price of one, and without a branch, so that nothing is mispredicted.
template <class Real> class Nearby {
public:
    static constexpr std::size_t atOnce = 2;

    Nearby(const PackedDisc<Real>& disc, const Real& now)
        : m_position(disc.positionAt(now))
        , m_now(both(now))
        , m_x(both(m_position.x))
        , m_y(both(m_position.y))
        , m_vx(both(disc.velocity.x))
        , m_vy(both(disc.velocity.y))
        , m_radius(both(disc.radius))
        , m_speed2(both(dot(disc.velocity, disc.velocity))) {}

    const Vec2<Real>& position() const { return m_position; }

    // The earliest of the meetings with those from `who` to `end`, rounded up to whole pairs, and of what is
    // known so far; of equals the first in the scene. `at` has room for when each of them is met.
    Meeting<Real> earliest(const PackedDisc<Real>* discs, const std::uint32_t* who, const std::uint32_t* end,
                           Real* at, const Meeting<Real>& sofar) const {
        Two time{sofar.time, never}, next{sofar.next, never};
        Real* const begin = at;
        Real* t = at;
        const std::uint32_t* w = who;
        for (; w < end; w += atOnce)
            for (std::size_t k = 0; k < atOnce; k += 2, t += 2) {
                const Two times = meetingTimes(discs[w[k]], discs[w[k + 1]]);
                t[0] = times[0];
                t[1] = times[1];
                const Two later = times < time ? time : times;
                next = later < next ? later : next;
                time = times < time ? times : time;
            }
        Meeting<Real> best{std::min(time[0], time[1]),
                           std::min(std::min(next[0], next[1]), std::max(time[0], time[1])), sofar.partner};
        std::uint32_t partner = sofar.time == best.time ? sofar.partner : 0;
        for (w = who; w < end; w += atOnce, at += atOnce)
            for (std::size_t k = 0; k < atOnce; ++k)
                partner |= w[k] & -std::uint32_t(at[k] == best.time);
        best.partner = best.time < never ? partner : 0;
        if (best.next == best.time && best.time < never) [[unlikely]]
            best.partner = firstOfEquals(who, end, begin, best, sofar);
        return best;
    }

private:
    static inline constexpr Real never = std::numeric_limits<Real>::infinity();
    using Two = thetalane::Two<Real>;

    static Two both(const Real& x) { return Two{x, x}; }

    static std::uint32_t firstOfEquals(const std::uint32_t* who, const std::uint32_t* end, const Real* at,
                                       const Meeting<Real>& best, const Meeting<Real>& sofar) {
        std::uint32_t partner = sofar.time == best.time ? sofar.partner : ~0u;
        for (; who < end; ++who, ++at)
            if (*at == best.time && *who < partner)
                partner = *who;
        return partner;
    }

    // now + timeToImpact() of core/motion/impact.h, its very bits, with either.
    Two meetingTimes(const PackedDisc<Real>& a, const PackedDisc<Real>& b) const {
        const Two zero{0, 0};
        const Two ux{a.velocity.x, b.velocity.x}, uy{a.velocity.y, b.velocity.y};
        const Two elapsed = m_now - Two{a.since, b.since};
        const Two dx = m_x - (Two{a.position.x, b.position.x} + ux * elapsed);
        const Two dy = m_y - (Two{a.position.y, b.position.y} + uy * elapsed);
        const Two wx = m_vx - ux, wy = m_vy - uy;
        const Two reach = m_radius + Two{a.radius, b.radius};
        const Two speed2 = m_speed2 + (ux * ux + uy * uy);

        const Two closing = dx * wx + dy * wy;
        const Two distance2 = dx * dx + dy * dy;
        const Two reach2 = reach * reach;
        const Two gap = distance2 - reach2;
        const Two side = dx * wy - dy * wx;
        const Two discriminant = (wx * wx + wy * wy) * reach2 - side * side;
        const Two arrival =
            (gap > zero ? gap : zero) / (root(discriminant > zero ? discriminant : zero) - closing);
        const Two noise2 = both(approachNoise<Real>() * approachNoise<Real>()) * speed2;
        const auto meets =
            (closing < zero) & (closing * closing > noise2 * distance2) & (discriminant > noise2 * reach2);
        return m_now + (meets ? arrival : both(never));
    }

    static Two root(Two x) {
        using std::sqrt;
        return Two{sqrt(x[0]), sqrt(x[1])};
    }

    Vec2<Real> m_position;
    Two m_now, m_x, m_y, m_vx, m_vy, m_radius, m_speed2;
};

} // namespace thetalane

// An independent solver of the same model, with 50 digits: after every collision all discs are moved, all
// pairs and walls are looked at again (nothing is remembered), contact is found from the time of closest
// approach, and the exchange is an impulse along the line of centres. It shares no code with core/.
#pragma once

#include "core/scene/scene.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <vector>

namespace thetalane::testing {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;

class ReferenceSolver {
public:
    struct Met {
        int first = 0;
        int second = -1; // -1 to -4: left, right, bottom, top
        friend bool operator==(const Met&, const Met&) = default;
    };

    explicit ReferenceSolver(const Scene& scene)
        : m_e(scene.restitution) {
        for (const Body& b : scene.bodies)
            m_discs.push_back({Wide(b.mass), Wide(b.radius), Wide(b.position.x), Wide(b.position.y),
                               Wide(b.velocity.x), Wide(b.velocity.y)});
        if (!scene.frame)
            return;
        m_wallE = Wide(scene.frame->restitution);
        for (const Side s : sides)
            if (const auto& at = scene.frame->side(s))
                m_walls.push_back({int(s), Wide(*at)});
    }

    // Every position and velocity a little off, by `relative` of 1 m and 1 m/s; k picks the pattern.
    void disturb(const Wide& relative, unsigned k) {
        for (Disc& d : m_discs)
            for (Wide* value : {&d.x, &d.y, &d.vx, &d.vy}) {
                k = k * 1664525u + 1013904223u;
                *value += relative * (Wide(k) / 2147483648.0 - 1);
            }
    }

    // Up to the collision with the given number, or until nothing more will meet; how many there were.
    int runTo(int collisions) {
        while (int(m_met.size()) < collisions) {
            const Found next = find();
            if (next.met.first < 0)
                break;
            drift(next.in);
            m_times.push_back(m_now);
            m_met.push_back(next.met);
            exchange(next.met);
        }
        return int(m_met.size());
    }

    void drift(const Wide& t) {
        for (Disc& d : m_discs) {
            d.x += d.vx * t;
            d.y += d.vy * t;
        }
        m_now += t;
    }

    // Until the next collision from here; a large number when there is none.
    Wide untilNext() const { return find().in; }

    const Wide& now() const { return m_now; }
    const std::vector<Met>& met() const { return m_met; }
    const std::vector<Wide>& times() const { return m_times; }
    Wide x(std::size_t i) const { return m_discs[i].x; }
    Wide y(std::size_t i) const { return m_discs[i].y; }
    Wide vx(std::size_t i) const { return m_discs[i].vx; }
    Wide vy(std::size_t i) const { return m_discs[i].vy; }

    // The largest difference of any coordinate [m] or component [m/s].
    Wide distanceTo(const ReferenceSolver& other) const {
        Wide worst = 0;
        for (std::size_t i = 0; i < m_discs.size(); ++i) {
            const Disc &a = m_discs[i], &b = other.m_discs[i];
            for (const Wide& d : {Wide(a.x - b.x), Wide(a.y - b.y), Wide(a.vx - b.vx), Wide(a.vy - b.vy)})
                worst = std::max(worst, Wide(abs(d)));
        }
        return worst;
    }

private:
    struct Disc {
        Wide mass, radius, x, y, vx, vy;
    };
    struct Wall {
        int side;
        Wide at;
    };
    struct Found {
        Wide in = 1e9;
        Met met{-1, -1};
    };

    // Closest approach is at t* = -s/w² (s = Δp·Δv, w = |Δv|), |Δp × Δv|/w apart; contact is √(R² - d²)/w
    // sooner.
    static Wide contactTime(const Disc& a, const Disc& b) {
        const Wide dx = a.x - b.x, dy = a.y - b.y, wx = a.vx - b.vx, wy = a.vy - b.vy;
        const Wide s = dx * wx + dy * wy, w2 = wx * wx + wy * wy, reach = a.radius + b.radius;
        // What is left of an approach after an inelastic collision is the rounding of 50 digits.
        if (s >= Wide(-1e-40))
            return Wide(1e9);
        const Wide c = dx * wy - dy * wx, d2 = c * c / w2;
        if (d2 >= reach * reach)
            return Wide(1e9);
        const Wide t = -s / w2 - sqrt((reach * reach - d2) / w2);
        return t > 0 ? t : Wide(0);
    }

    Found find() const {
        Found best;
        const auto take = [&best](const Wide& in, int first, int second) {
            if (in < best.in)
                best = {in, {first, second}};
        };
        for (std::size_t i = 0; i < m_discs.size(); ++i) {
            for (std::size_t j = i + 1; j < m_discs.size(); ++j)
                take(contactTime(m_discs[i], m_discs[j]), int(i), int(j));
            for (const Wall& w : m_walls) {
                const Disc& d = m_discs[i];
                const Wide at = w.side < 2 ? d.x : d.y, v = w.side < 2 ? d.vx : d.vy;
                const bool low = w.side % 2 == 0;
                if (low ? v < 0 : v > 0) {
                    const Wide t = ((low ? w.at + d.radius : w.at - d.radius) - at) / v;
                    take(t > 0 ? t : Wide(0), int(i), -1 - w.side);
                }
            }
        }
        return best;
    }

    void exchange(const Met& met) {
        Disc& a = m_discs[std::size_t(met.first)];
        if (met.second < 0) {
            Wide& v = met.second > -3 ? a.vx : a.vy;
            v = -m_wallE * v;
            return;
        }
        Disc& b = m_discs[std::size_t(met.second)];
        const Wide dx = b.x - a.x, dy = b.y - a.y, d2 = dx * dx + dy * dy;
        const Wide approach = (a.vx - b.vx) * dx + (a.vy - b.vy) * dy;
        const Wide j = (1 + m_e) * approach / d2 / (1 / a.mass + 1 / b.mass);
        a.vx -= j / a.mass * dx;
        a.vy -= j / a.mass * dy;
        b.vx += j / b.mass * dx;
        b.vy += j / b.mass * dy;
    }

    Wide m_e;
    Wide m_wallE = 1;
    Wide m_now = 0;
    std::vector<Disc> m_discs;
    std::vector<Wall> m_walls;
    std::vector<Met> m_met;
    std::vector<Wide> m_times;
};

} // namespace thetalane::testing

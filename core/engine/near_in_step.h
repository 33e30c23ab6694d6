// Which bodies come near each other within a step: sort and sweep along y, as lanes are long.
#pragma once

#include "core/engine/moving_discs.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace thetalane {

template <class Real> class NearInStep {
public:
    using Index = std::size_t;

    explicit NearInStep(const Scene& scene)
        : m_extents(scene.bodies.size())
        , m_order(scene.bodies.size()) {
        std::iota(m_order.begin(), m_order.end(), Index(0));
    }

    // f(i, j) once for every pair that could touch within `end`; in an order that is nobody's business.
    template <bool Accelerated, class F>
    void forEachPair(const MovingDiscs<Real, Accelerated>& discs, const Real& end, F&& f) {
        using std::abs;
        for (Index i = 0; i < m_extents.size(); ++i)
            m_extents[i] = extentOf(discs, i, end);
        sort();
        for (Index a = 0; a < m_order.size(); ++a) {
            const Extent& e = m_extents[m_order[a]];
            for (Index b = a + 1; b < m_order.size(); ++b) {
                const Extent& other = m_extents[m_order[b]];
                if (other.low > e.high)
                    break;
                if (!(abs(e.x - other.x) > e.reach + other.reach))
                    f(m_order[a], m_order[b]);
            }
        }
    }

private:
    struct Extent {
        Real low{}, high{}; // y
        Real x{};
        Real reach{}; // radius and way
    };

    template <bool Accelerated>
    static Extent extentOf(const MovingDiscs<Real, Accelerated>& discs, Index i, const Real& end) {
        const Vec2<Real> p = discs.positionAt(i, Real(0)), v = discs.velocityAt(i, Real(0));
        const Vec2<Real> a = discs.acceleration(i);
        Real way(0);
        if (!(v == Vec2<Real>{} && a == Vec2<Real>{}))
            way = (norm(v) + norm(a) * end / 2) * end;
        using std::abs;
        const Real slack = abs(p.x) + abs(p.y); // its rounding decides nothing
        const Real reach =
            (discs.radiusOf(i) + way) * Real(1.001f) + 64 * std::numeric_limits<Real>::epsilon() * slack;
        return {p.y - reach, p.y + reach, p.x, reach};
    }

    // From one step to the next little changes.
    void sort() {
        for (Index a = 1; a < m_order.size(); ++a) {
            const Index moved = m_order[a];
            Index at = a;
            for (; at > 0 && m_extents[m_order[at - 1]].low > m_extents[moved].low; --at)
                m_order[at] = m_order[at - 1];
            m_order[at] = moved;
        }
    }

    std::vector<Extent> m_extents;
    std::vector<Index> m_order;
};

} // namespace thetalane

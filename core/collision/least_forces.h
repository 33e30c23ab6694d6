// The least forces that keep contacts from closing, also where no forces can.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace thetalane {

// min ½ λᵀ G λ + bᵀ λ over λ >= 0, for a G that may be singular and a b that may ask for what cannot be: a
// body wedged between two that hold still, which already overlap by rounding. Each contact yields a little,
// by ε Gₖₖ (λₖ - what it was), which makes the problem sound whatever G and b are (the proximal point method,
// Rockafellar 1976): what can be met is met after three rounds but for ε³, what cannot is shared among the
// contacts as least squares would. Each round is solved by the active-set method of Lawson and Hanson
// (Solving Least Squares Problems, 1974, ch. 23).
template <class Real> class LeastForces {
public:
    // g: row by row.
    LeastForces(std::vector<Real> g, std::vector<Real> b)
        : m_count(b.size())
        , m_g(std::move(g))
        , m_b(std::move(b))
        , m_goal(m_count)
        , m_lambda(m_count, Real(0))
        , m_anchored(m_count)
        , m_factor(m_count * m_count) {
        m_active.reserve(m_count);
    }

    std::vector<Real> solve() {
        constexpr int rounds = 3;
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t k = 0; k < m_count; ++k)
                m_anchored[k] = m_b[k] - yielding() * g(k, k) * m_lambda[k];
            settle();
            // Each entry lowers the objective; the bound is for rounding alone.
            for (std::size_t entry = 0; entry < 16 * m_count + 16; ++entry) {
                const std::size_t k = mostViolated();
                if (k == m_count)
                    break;
                enter(k);
                settle();
            }
        }
        return std::move(m_lambda);
    }

private:
    static const Real& yielding() { // ε
        using std::sqrt;
        static const Real epsilon = sqrt(std::numeric_limits<Real>::epsilon());
        return epsilon;
    }
    static Real magnitude(const Real& x) { return x < Real(0) ? Real(-x) : x; }

    const Real& g(std::size_t k, std::size_t l) const { return m_g[k * m_count + l]; }
    Real& factor(std::size_t row, std::size_t column) { return m_factor[row * m_count + column]; }
    bool isActive(std::size_t k) const {
        return std::find(m_active.begin(), m_active.end(), k) != m_active.end();
    }

    std::size_t mostViolated() const {
        const Real tolerance = 256 * std::numeric_limits<Real>::epsilon();
        std::size_t worst = m_count;
        Real least(0);
        for (std::size_t k = 0; k < m_count; ++k) {
            if (!(g(k, k) > Real(0)) || isActive(k)) // between what cannot be moved
                continue;
            Real w = m_anchored[k], scale = magnitude(w);
            for (const std::size_t l : m_active) {
                const Real term = g(k, l) * m_lambda[l];
                w += term;
                scale += magnitude(term);
            }
            if (w < -tolerance * scale && w < least) {
                least = w;
                worst = k;
            }
        }
        return worst;
    }

    void enter(std::size_t k) {
        m_active.push_back(k);
        factorize(m_active.size() - 1);
    }

    // To the best forces of the active contacts; those whose force would turn negative leave.
    void settle() {
        while (!m_active.empty()) {
            solveActive();
            Real step(1);
            std::size_t leaves = m_active.size();
            for (std::size_t a = 0; a < m_active.size(); ++a) {
                if (m_goal[a] > Real(0))
                    continue;
                const Real& from = m_lambda[m_active[a]];
                const Real reach = from > m_goal[a] ? Real(from / (from - m_goal[a])) : Real(0);
                if (leaves == m_active.size() || reach < step) {
                    step = reach;
                    leaves = a;
                }
            }
            for (std::size_t a = 0; a < m_active.size(); ++a) {
                Real& lambda = m_lambda[m_active[a]];
                lambda = leaves == m_active.size() ? m_goal[a] : lambda + step * (m_goal[a] - lambda);
            }
            if (leaves == m_active.size())
                return;
            m_lambda[m_active[leaves]] = Real(0);
            m_active.erase(m_active.begin() + std::ptrdiff_t(leaves));
            for (std::size_t row = leaves; row < m_active.size(); ++row)
                factorize(row);
        }
    }

    // Row `row` of L and D, where L D Lᵀ = G + ε diag G over the active contacts; D on the diagonal.
    void factorize(std::size_t row) {
        const std::size_t k = m_active[row];
        for (std::size_t c = 0; c < row; ++c) {
            Real sum = g(k, m_active[c]);
            for (std::size_t j = 0; j < c; ++j)
                sum -= factor(row, j) * factor(c, j) * factor(j, j);
            factor(row, c) = sum / factor(c, c);
        }
        Real pivot = g(k, k) * (1 + yielding());
        for (std::size_t j = 0; j < row; ++j)
            pivot -= factor(row, j) * factor(row, j) * factor(j, j);
        factor(row, row) = std::max(pivot, Real(g(k, k) * yielding() / 2)); // less is rounding
    }

    void solveActive() {
        const std::size_t n = m_active.size();
        for (std::size_t r = 0; r < n; ++r) {
            Real sum = -m_anchored[m_active[r]];
            for (std::size_t c = 0; c < r; ++c)
                sum -= factor(r, c) * m_goal[c];
            m_goal[r] = sum;
        }
        for (std::size_t r = n; r-- > 0;) {
            Real sum = m_goal[r] / factor(r, r);
            for (std::size_t c = r + 1; c < n; ++c)
                sum -= factor(c, r) * m_goal[c];
            m_goal[r] = sum;
        }
    }

    std::size_t m_count;
    std::vector<Real> m_g;
    std::vector<Real> m_b;
    std::vector<Real> m_goal; // of the active, in their order
    std::vector<Real> m_lambda;
    std::vector<Real> m_anchored; // b with what the contacts already yielded to
    std::vector<Real> m_factor;
    std::vector<std::size_t> m_active;
};

} // namespace thetalane

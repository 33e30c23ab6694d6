#include "core/collision/contact_group.h"

#include "core/collision/least_forces.h"
#include "core/math/quad.h"

#include <algorithm>
#include <optional>

namespace thetalane {
namespace {

// min ½ λᵀ G λ + bᵀ λ over λ >= 0, by the active-set method of Lawson and Hanson (Solving Least Squares
// Problems, 1974, ch. 23).
template <class Number> class ActiveSet {
public:
    ActiveSet(std::vector<std::vector<Number>> g, std::vector<Number> b, Number tolerance)
        : m_g(std::move(g))
        , m_b(std::move(b))
        , m_tolerance(std::move(tolerance))
        , m_lambda(m_b.size(), Number(0))
        , m_hopeless(m_b.size(), false) {}

    std::vector<Number> solve() {
        // Each round lowers the objective; the bound is for rounding alone.
        for (std::size_t round = 0; round < 16 * m_b.size() + 16; ++round) {
            const std::size_t k = mostViolated();
            if (k == m_b.size())
                break;
            take(k);
        }
        return m_lambda;
    }

private:
    static Number magnitude(const Number& x) { return x < 0 ? Number(-x) : x; }

    std::size_t mostViolated() const {
        std::size_t worst = m_b.size();
        Number least(0);
        for (std::size_t k = 0; k < m_b.size(); ++k) {
            if (isActive(k) || m_hopeless[k])
                continue;
            Number w = m_b[k], scale = magnitude(m_b[k]);
            for (const std::size_t l : m_active) {
                w += m_g[k][l] * m_lambda[l];
                scale += magnitude(Number(m_g[k][l] * m_lambda[l]));
            }
            if (w < -m_tolerance * scale && w < least) {
                least = w;
                worst = k;
            }
        }
        return worst;
    }

    bool isActive(std::size_t k) const {
        return std::find(m_active.begin(), m_active.end(), k) != m_active.end();
    }

    // Contact k joins; those whose impulse would turn negative leave.
    void take(std::size_t k) {
        if (const auto direction = dependence(k)) {
            if (!walk(*direction, k)) {
                m_hopeless[k] = true;
                return;
            }
        }
        m_active.push_back(k);
        for (;;) {
            const std::vector<Number> goal = solveActive();
            Number step(1);
            std::size_t leaves = m_active.size();
            for (std::size_t a = 0; a < m_active.size(); ++a) {
                if (goal[a] > 0)
                    continue;
                const Number& from = m_lambda[m_active[a]];
                const Number reach = from > goal[a] ? Number(from / (from - goal[a])) : Number(0);
                if (leaves == m_active.size() || reach < step) {
                    step = reach;
                    leaves = a;
                }
            }
            for (std::size_t a = 0; a < m_active.size(); ++a)
                m_lambda[m_active[a]] += step * (goal[a] - m_lambda[m_active[a]]);
            if (leaves == m_active.size())
                return;
            m_lambda[m_active[leaves]] = 0;
            m_active.erase(m_active.begin() + std::ptrdiff_t(leaves));
        }
    }

    // Where the active contacts already do what k does (two walls on one body): along which impulses trade
    // places without moving anything.
    std::optional<std::vector<Number>> dependence(std::size_t k) const {
        std::vector<Number> right;
        for (const std::size_t l : m_active)
            right.push_back(-m_g[l][k]);
        const std::vector<Number> d = solveFor(right);
        Number left = m_g[k][k];
        for (std::size_t a = 0; a < m_active.size(); ++a)
            left += m_g[k][m_active[a]] * d[a];
        if (left > m_tolerance * m_g[k][k])
            return std::nullopt;
        return d;
    }

    // As far as possible; false if nothing bounds it, which a body that could not escape would need.
    bool walk(const std::vector<Number>& d, std::size_t k) {
        std::size_t leaves = m_active.size();
        Number step(0);
        for (std::size_t a = 0; a < m_active.size(); ++a) {
            if (!(d[a] < 0))
                continue;
            const Number reach = -m_lambda[m_active[a]] / d[a];
            if (leaves == m_active.size() || reach < step) {
                step = reach;
                leaves = a;
            }
        }
        if (leaves == m_active.size())
            return false;
        for (std::size_t a = 0; a < m_active.size(); ++a)
            m_lambda[m_active[a]] += step * d[a];
        m_lambda[k] = step;
        m_lambda[m_active[leaves]] = 0;
        m_active.erase(m_active.begin() + std::ptrdiff_t(leaves));
        return true;
    }

    std::vector<Number> solveActive() const {
        std::vector<Number> right;
        for (const std::size_t k : m_active)
            right.push_back(-m_b[k]);
        return solveFor(std::move(right));
    }

    // G x = right over the active contacts: G is symmetric and positive there.
    std::vector<Number> solveFor(std::vector<Number> x) const {
        const std::size_t n = m_active.size();
        std::vector<std::vector<Number>> a(n, std::vector<Number>(n));
        for (std::size_t r = 0; r < n; ++r)
            for (std::size_t c = 0; c < n; ++c)
                a[r][c] = m_g[m_active[r]][m_active[c]];
        for (std::size_t p = 0; p < n; ++p) {
            for (std::size_t r = p + 1; r < n; ++r) {
                const Number factor = a[r][p] / a[p][p];
                for (std::size_t c = p; c < n; ++c)
                    a[r][c] -= factor * a[p][c];
                x[r] -= factor * x[p];
            }
        }
        for (std::size_t p = n; p-- > 0;) {
            for (std::size_t c = p + 1; c < n; ++c)
                x[p] -= a[p][c] * x[c];
            x[p] /= a[p][p];
        }
        return x;
    }

    std::vector<std::vector<Number>> m_g;
    std::vector<Number> m_b;
    Number m_tolerance; // relative to the terms of a sum: less is rounding
    std::vector<Number> m_lambda;
    std::vector<std::size_t> m_active;
    std::vector<bool> m_hopeless; // between what cannot be moved
};

template <class Number, class Real>
Number coupling(const GroupContact<Real>& k, const GroupContact<Real>& l, std::span<const Real> inverseMass) {
    const Number along = Number(k.normal.x) * Number(l.normal.x) + Number(k.normal.y) * Number(l.normal.y);
    Number sum(0);
    const auto share = [&](std::size_t a, std::size_t b, int sign) {
        if (a == b && a != GroupContact<Real>::wall)
            sum += sign * Number(inverseMass[a]);
    };
    share(k.first, l.first, 1);
    share(k.first, l.second, -1);
    share(k.second, l.first, -1);
    share(k.second, l.second, 1);
    return sum * along;
}

template <class Number, class Real>
std::vector<Number> impulsesIn(std::span<const GroupContact<Real>> contacts,
                               std::span<const Real> inverseMass, const Number& tolerance) {
    std::vector<std::vector<Number>> g(contacts.size(), std::vector<Number>(contacts.size()));
    std::vector<Number> b;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        b.emplace_back(contacts[k].demand);
        for (std::size_t l = 0; l < contacts.size(); ++l)
            g[k][l] = coupling<Number, Real>(contacts[k], contacts[l], inverseMass);
    }
    return ActiveSet<Number>(std::move(g), std::move(b), tolerance).solve();
}

// Projected relaxation, then one scaling along the whole, after which the energy law holds whatever is left.
template <class Real> class Relaxation {
public:
    Relaxation(std::span<const GroupContact<Real>> contacts, std::span<const Real> inverseMass)
        : m_contacts(contacts)
        , m_inverseMass(inverseMass)
        , m_lambda(contacts.size(), Real(0))
        , m_change(inverseMass.size()) {}

    std::vector<Quad> solve() {
        constexpr int sweeps = 1000;
        for (int sweep = 0; sweep < sweeps && relax(); ++sweep) {
        }
        Real work(0), quadratic(0);
        for (std::size_t k = 0; k < m_contacts.size(); ++k) {
            work -= m_contacts[k].demand * m_lambda[k];
            quadratic += normalChange(k) * m_lambda[k];
        }
        const Real scale = quadratic > work && quadratic > Real(0) ? Real(work / quadratic) : Real(1);
        std::vector<Quad> out;
        for (const Real& lambda : m_lambda)
            out.emplace_back(lambda * scale);
        return out;
    }

private:
    Real normalChange(std::size_t k) const {
        const auto& c = m_contacts[k];
        const Vec2<Real> second =
            c.second == GroupContact<Real>::wall ? Vec2<Real>{} : Vec2<Real>(m_change[c.second]);
        return dot(c.normal, m_change[c.first] - second);
    }

    // True while an impulse still changes by more than rounding.
    bool relax() {
        using std::abs;
        bool changed = false;
        for (std::size_t k = 0; k < m_contacts.size(); ++k) {
            const auto& c = m_contacts[k];
            const bool wall = c.second == GroupContact<Real>::wall;
            const Real mobility = m_inverseMass[c.first] + (wall ? Real(0) : Real(m_inverseMass[c.second]));
            if (!(mobility > Real(0)))
                continue;
            const Real wanted = m_lambda[k] - (normalChange(k) + c.demand) / mobility;
            const Real next = wanted > Real(0) ? wanted : Real(0);
            const Real more = next - m_lambda[k];
            changed |= abs(more) > 4 * std::numeric_limits<Real>::epsilon() * next;
            m_lambda[k] = next;
            m_change[c.first] = m_change[c.first] + c.normal * (more * m_inverseMass[c.first]);
            if (!wall)
                m_change[c.second] = m_change[c.second] - c.normal * (more * m_inverseMass[c.second]);
        }
        return changed;
    }

    std::span<const GroupContact<Real>> m_contacts;
    std::span<const Real> m_inverseMass;
    std::vector<Real> m_lambda;
    std::vector<Vec2<Real>> m_change;
};

// A body's change of velocity. What cancels but for the last of the 113 bits is zero: mirror images then stay
// so.
class Change {
public:
    void add(const Quad& x, const Quad& y) {
        m_x.add(x);
        m_y.add(y);
    }
    template <class Real> Vec2<Real> rounded() const {
        return {static_cast<Real>(m_x.value()), static_cast<Real>(m_y.value())};
    }

private:
    struct Sum {
        Quad total{0};
        Quad size{0};
        void add(const Quad& q) {
            total += q;
            size += abs(q);
        }
        Quad value() const {
            return abs(total) > 64 * std::numeric_limits<Quad>::epsilon() * size ? total : Quad(0);
        }
    };
    Sum m_x;
    Sum m_y;
};

} // namespace

template <class Real>
GroupSolution<Real> solveContacts(std::span<const GroupContact<Real>> contacts,
                                  std::span<const Real> inverseMass) {
    constexpr std::size_t mostExact = 32;
    const std::vector<Quad> impulses =
        contacts.size() <= mostExact
            ? impulsesIn<Quad, Real>(contacts, inverseMass, Quad(std::numeric_limits<Real>::epsilon()) / 16)
            : Relaxation<Real>(contacts, inverseMass).solve();
    std::vector<Change> change(inverseMass.size());
    GroupSolution<Real> out;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const auto& c = contacts[k];
        const Quad x = Quad(c.normal.x) * impulses[k], y = Quad(c.normal.y) * impulses[k];
        const Quad first(inverseMass[c.first]);
        change[c.first].add(x * first, y * first);
        if (c.second != GroupContact<Real>::wall) {
            const Quad second(inverseMass[c.second]);
            change[c.second].add(-x * second, -y * second);
        }
        out.impulse.push_back(static_cast<Real>(impulses[k]));
    }
    for (const Change& c : change)
        out.change.push_back(c.rounded<Real>());
    return out;
}

template <class Real>
GroupSolution<Real> solveForces(std::span<const GroupContact<Real>> contacts,
                                std::span<const Real> inverseMass) {
    std::vector<Real> g, b;
    g.reserve(contacts.size() * contacts.size());
    b.reserve(contacts.size());
    for (const GroupContact<Real>& k : contacts) {
        b.push_back(k.demand);
        for (const GroupContact<Real>& l : contacts)
            g.push_back(coupling<Real, Real>(k, l, inverseMass));
    }
    GroupSolution<Real> out;
    out.impulse = LeastForces<Real>(std::move(g), std::move(b)).solve();
    out.change.resize(inverseMass.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const auto& c = contacts[k];
        const Vec2<Real> push = c.normal * out.impulse[k];
        out.change[c.first] = out.change[c.first] + push * inverseMass[c.first];
        if (c.second != GroupContact<Real>::wall)
            out.change[c.second] = out.change[c.second] - push * inverseMass[c.second];
    }
    return out;
}

template GroupSolution<float> solveForces(std::span<const GroupContact<float>>, std::span<const float>);
template GroupSolution<double> solveForces(std::span<const GroupContact<double>>, std::span<const double>);
template GroupSolution<Quad> solveForces(std::span<const GroupContact<Quad>>, std::span<const Quad>);

template GroupSolution<float> solveContacts(std::span<const GroupContact<float>>, std::span<const float>);
template GroupSolution<double> solveContacts(std::span<const GroupContact<double>>, std::span<const double>);
template GroupSolution<Quad> solveContacts(std::span<const GroupContact<Quad>>, std::span<const Quad>);

} // namespace thetalane

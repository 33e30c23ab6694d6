// Real roots of polynomials with 100 digits, counted by Sturm's theorem: an independent judge of closed
// forms.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <optional>
#include <vector>

namespace thetalane::testing {

using Hundred = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                              boost::multiprecision::et_off>;
using Polynomial = std::vector<Hundred>; // lowest power first

inline Hundred valueOf(const Polynomial& p, const Hundred& x) {
    Hundred v = 0;
    for (std::size_t k = p.size(); k-- > 0;)
        v = v * x + p[k];
    return v;
}

inline Polynomial derivativeOf(const Polynomial& p) {
    Polynomial d;
    for (std::size_t k = 1; k < p.size(); ++k)
        d.push_back(p[k] * int(k));
    return d;
}

class Sturm {
public:
    explicit Sturm(Polynomial p) {
        trim(p, Hundred(0));
        m_chain.push_back(std::move(p));
        if (m_chain[0].size() > 1)
            m_chain.push_back(derivativeOf(m_chain[0]));
        while (m_chain.back().size() > 1) {
            Polynomial next = negativeRemainder(m_chain[m_chain.size() - 2], m_chain.back());
            if (next.empty())
                break;
            m_chain.push_back(std::move(next));
        }
    }

    const Polynomial& polynomial() const { return m_chain[0]; }

    // The first zero in (low, high) at which the sign changes; none if there is none.
    std::optional<Hundred> firstChange(Hundred low, const Hundred& high) const {
        if (m_chain[0].empty())
            return {};
        while (low < high) {
            Hundred to = high;
            int before = changes(low), roots = before - changes(to);
            if (roots <= 0)
                return {};
            for (int k = 0; roots > 1 && k < 400; ++k) {
                const Hundred middle = (low + to) / 2;
                const int left = before - changes(middle);
                (left > 0 ? to : low) = middle;
                roots = left > 0 ? left : roots;
            }
            if (valueOf(m_chain[0], low) == 0) // a zero at the start itself is not counted
                low += (to - low) * Hundred("1e-45");
            const Hundred f = valueOf(m_chain[0], low), g = valueOf(m_chain[0], to);
            if ((f > 0 && g < 0) || (f < 0 && g > 0))
                return refined(low, to, f > 0);
            low = to; // touched without crossing, or just at the end
        }
        return {};
    }

private:
    static void trim(Polynomial& p, const Hundred& below) {
        while (!p.empty() && abs(p.back()) <= below)
            p.pop_back();
    }

    static Polynomial negativeRemainder(Polynomial a, const Polynomial& b) {
        Hundred largest = 0;
        for (const Hundred& c : a)
            largest = std::max(largest, Hundred(abs(c)));
        while (a.size() >= b.size()) {
            const Hundred factor = a.back() / b.back();
            const std::size_t shift = a.size() - b.size();
            a.pop_back();
            for (std::size_t k = 0; k + 1 < b.size(); ++k)
                a[k + shift] -= factor * b[k];
        }
        trim(a, largest * Hundred("1e-95")); // what 100 digits leave of a zero
        for (Hundred& c : a)
            c = -c;
        return a;
    }

    int changes(const Hundred& x) const {
        int n = 0, last = 0;
        for (const Polynomial& p : m_chain) {
            const Hundred v = valueOf(p, x);
            const int sign = v > 0 ? 1 : v < 0 ? -1 : 0;
            n += sign != 0 && last != 0 && sign != last;
            last = sign != 0 ? sign : last;
        }
        return n;
    }

    // Newton's steps while they stay between, else the middle, to 60 digits.
    Hundred refined(Hundred low, Hundred high, bool falls) const {
        Hundred x = (low + high) / 2;
        for (int k = 0; k < 500; ++k) {
            const Hundred f = valueOf(m_chain[0], x), slope = valueOf(m_chain[1], x);
            if (f == 0)
                return x;
            ((f > 0) == falls ? low : high) = x;
            Hundred to = slope != 0 ? Hundred(x - f / slope) : low;
            if (!(to > low && to < high))
                to = (low + high) / 2;
            if (abs(to - x) <= abs(x) * Hundred("1e-50"))
                return to;
            x = to;
        }
        return x;
    }

    std::vector<Polynomial> m_chain;
};

} // namespace thetalane::testing

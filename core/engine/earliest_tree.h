// Which of many times is the earliest, when one of them changes at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace thetalane {

// Eight times fill a cache line; above each eight stands the least of them, and so on to the root. A change
// looks at one line a level and stops where the least stays; the earliest is found from the root down.
// Against a binary tournament half the lines and a fifth of the memory.
template <class Real> class EarliestTree {
public:
    explicit EarliestTree(std::size_t count) {
        std::vector<std::size_t> sizes;
        do {
            count = (count + fan - 1) / fan;
            sizes.push_back(count);
        } while (count > 1);
        std::size_t lines = 0;
        for (auto size = sizes.rbegin(); size != sizes.rend(); ++size) {
            m_levels.push_back(lines);
            lines += *size;
        }
        m_lines.resize(lines);
    }

    // The one that is earliest; of equals the first.
    std::size_t first() const {
        std::size_t n = 0;
        for (const std::size_t level : m_levels)
            n = n * fan + m_lines[level + n].earliest();
        return n;
    }

    // Without regard to the levels above, until build().
    void set(std::size_t i, const Real& time) { m_lines[m_levels.back() + i / fan].time[i % fan] = time; }

    void build() {
        for (std::size_t depth = m_levels.size(); --depth > 0;)
            for (std::size_t n = 0; n < m_levels[depth] - m_levels[depth - 1]; ++n)
                for (std::size_t k = 0; k < fan; ++k)
                    if (const std::size_t below = m_levels[depth] + n * fan + k; below < endOf(depth))
                        m_lines[m_levels[depth - 1] + n].time[k] = m_lines[below].least();
    }

    void change(std::size_t i, Real time) {
        for (std::size_t depth = m_levels.size(); depth-- > 0; i /= fan) {
            Line& line = m_lines[m_levels[depth] + i / fan];
            const Real before = line.least();
            line.time[i % fan] = time;
            time = line.least();
            if (time == before)
                return;
        }
    }

    void shiftTime(const Real& shift) {
        for (Line& line : m_lines)
            for (Real& time : line.time)
                time = time - shift;
    }

private:
    static constexpr std::size_t fan = 8;
    static inline const Real never = std::numeric_limits<Real>::infinity();
    struct alignas(sizeof(Real) == 8 ? 64 : alignof(Real)) Line {
        Real time[fan] = {never, never, never, never, never, never, never, never};

        static const Real& lesser(const Real& a, const Real& b) { return b < a ? b : a; }
        Real least() const {
            return lesser(lesser(lesser(time[0], time[1]), lesser(time[2], time[3])),
                          lesser(lesser(time[4], time[5]), lesser(time[6], time[7])));
        }
        std::size_t earliest() const {
            const Real t = least();
            std::size_t k = fan - 1;
            for (std::size_t j = fan - 1; j-- > 0;)
                k = time[j] == t ? j : k;
            return k;
        }
    };

    std::size_t endOf(std::size_t depth) const {
        return depth + 1 < m_levels.size() ? m_levels[depth + 1] : m_lines.size();
    }

    std::vector<std::size_t> m_levels; // where each begins, the root first
    std::vector<Line> m_lines;
};

} // namespace thetalane

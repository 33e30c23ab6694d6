// Which of many times is the earliest, when one of them changes at a time.
#pragma once

#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

namespace thetalane {

// A tournament: every node holds the winner of the two below it, with its time, so that a change looks at one
// node a level; it stops where it changes no winner, which is soon unless the winner itself has changed.
template <class Real> class WinnerTree {
public:
    explicit WinnerTree(std::size_t count)
        : m_leaves(std::bit_ceil(count > 1 ? count : 2))
        , m_nodes(2 * m_leaves) {
        for (std::size_t i = 0; i < m_leaves; ++i)
            m_nodes[m_leaves + i].body = unsigned(i);
    }

    unsigned first() const { return m_nodes[1].body; }
    const Real& firstTime() const { return m_nodes[1].time; }

    void set(std::size_t body, const Real& time) { m_nodes[m_leaves + body].time = time; }

    // After a set() of every body.
    void playAll() {
        for (std::size_t n = m_leaves; --n > 0;)
            m_nodes[n] = winnerBelow(n);
    }

    void change(std::size_t body, const Real& time) {
        std::size_t n = m_leaves + body;
        m_nodes[n].time = time;
        for (n /= 2; n > 0; n /= 2) {
            const Node winner = winnerBelow(n);
            const bool untouched = winner.body != body && m_nodes[n].body != body;
            m_nodes[n] = winner;
            if (untouched)
                return;
        }
    }

    void shiftTime(const Real& shift) {
        for (Node& node : m_nodes)
            node.time = node.time - shift;
    }

private:
    struct Node {
        Real time = std::numeric_limits<Real>::infinity();
        unsigned body = 0;
    };
    const Node& winnerBelow(std::size_t n) const {
        return m_nodes[2 * n + (m_nodes[2 * n + 1].time < m_nodes[2 * n].time)];
    }

    std::size_t m_leaves;
    std::vector<Node> m_nodes;
};

} // namespace thetalane

// Cells about one diameter of the largest disc wide: two discs that touch are in the same or adjacent ones.
#pragma once

#include "core/engine/packed_discs.h"
#include "core/engine/two.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace thetalane {

// The cells at the border have no outer edge: they hold whatever has left the region the cells were laid
// over. No more than a few cells a disc, however far apart the discs lie; then the cells are wider.
template <class Real> class CellGrid {
public:
    struct Range {
        Real low{};
        Real high{};
    };

    // The discs in a cell; with the bit `more` set, the list of the others begins at the second.
    struct Cell {
        std::uint32_t first, second;
    };

    std::uint32_t none() const { return m_none; }

    // Over a region, for discs of which two touch within `reach`; every list empty.
    void layOut(Range x, Range y, const Real& reach, std::size_t discs) {
        using std::abs;
        const Real far = abs(x.low) + abs(x.high) + abs(y.low) + abs(y.high);
        Real width = reach * Real(1 + 0x1p-20f) + far * (64 * std::numeric_limits<Real>::epsilon());
        const double most = 4.0 * double(discs) + 16;
        const auto along = [&width](const Range& r) {
            return std::max(1.0, std::floor(static_cast<double>(Real((r.high - r.low) / width))));
        };
        while (along(x) * along(y) > most || std::max(along(x), along(y)) > mostInRow)
            width = width * Real(1.2f);
        m_axes = {Axis(x, along(x)), Axis(y, along(y))};
        m_low = Two<Real>{m_axes[0].low, m_axes[1].low};
        m_width = Two<Real>{m_axes[0].width, m_axes[1].width};
        m_counts = Two<Real>{Real(m_axes[0].count), Real(m_axes[1].count)};
        m_none = std::uint32_t(discs);
        m_next.resize(discs + 1, m_none);
        // A ring of cells that stay empty saves asking for the border.
        m_stride = m_axes[0].count + 2;
        m_cells.assign(std::size_t(m_stride) * (m_axes[1].count + 2), {m_none, m_none});
    }

    struct Axis {
        Real low{};
        Real width{1};
        Real perWidth{1};
        std::uint32_t count = 1;

        Axis() = default;
        Axis(const Range& range, double cells)
            : low(range.low)
            , width((range.high - range.low) / Real(cells))
            , perWidth(Real(cells) / (range.high - range.low))
            , count(std::uint32_t(cells)) {}

        std::uint32_t cellAt(const Real& q) const {
            const Real cells = (q - low) * perWidth;
            if (!(cells > 0))
                return 0;
            return cells < Real(count) ? std::min(static_cast<std::uint32_t>(cells), count - 1) : count - 1;
        }
        bool holds(const Real& q) const { return q >= low && q <= low + width * Real(count); }
    };
    const Axis& columns() const { return m_axes[0]; }
    const Axis& rows() const { return m_axes[1]; }

    bool atBorder(std::uint32_t column, std::uint32_t row) const {
        return (column - 1 >= m_axes[0].count - 2) | (row - 1 >= m_axes[1].count - 2);
    }

    // When something at p with velocity v leaves its cell, and which way; never through the border.
    struct Leaving {
        Real in;
        bool alongY;
    };
    Leaving leaves(std::uint32_t column, std::uint32_t row, const Vec2<Real>& p, const Vec2<Real>& v) const {
        const Two<Real> zero{0, 0}, one{1, 1}, never = zero + std::numeric_limits<Real>::infinity();
        const Two<Real> cell{Real(column), Real(row)}, q{p.x, p.y}, speed{v.x, v.y};
        const auto up = speed > zero;
        const Two<Real> edge = cell + (up ? one : zero);
        const Two<Real> in = (m_low + m_width * edge - q) / speed;
        const auto stays = (speed == zero) | (edge == (up ? m_counts : zero));
        const Two<Real> leaving = stays ? never : (in > zero ? in : zero);
        return {std::min(leaving[0], leaving[1]), leaving[1] < leaving[0]};
    }

    void insert(const PackedDiscs<Real>& discs, std::uint32_t i) {
        Cell& cell = m_cells[cellOf(discs[i].column, discs[i].row)];
        if (cell.second == m_none) {
            cell.second = cell.first;
            cell.first = i;
            return;
        }
        const std::uint32_t second = cell.second & ~more;
        if (second == cell.second)
            m_next[second] = m_none;
        m_next[i] = second;
        cell.second = i | more;
    }
    void remove(const PackedDiscs<Real>& discs, std::uint32_t i) {
        Cell& cell = m_cells[cellOf(discs[i].column, discs[i].row)];
        const std::uint32_t second = cell.second & ~more;
        if (second == cell.second) {
            cell.first = cell.first == i ? second : cell.first;
            cell.second = m_none;
            return;
        }
        std::uint32_t rest = second;
        if (cell.first == i) {
            cell.first = second;
            rest = m_next[second];
        } else {
            std::uint32_t* link = &rest;
            while (*link != i)
                link = &m_next[*link];
            *link = m_next[i];
        }
        cell.second = rest | (m_next[rest] != m_none ? more : 0);
    }

    // Where the cells about one begin: it is the middle of three rows of three.
    const Cell* around(std::uint32_t column, std::uint32_t row) const {
        return &m_cells[std::size_t(row) * m_stride + column];
    }
    std::uint32_t stride() const { return m_stride; }

    template <class F> void forEachIn(const Cell& cell, F&& f) const {
        if (cell.first != m_none)
            f(cell.first);
        for (std::uint32_t j = cell.second & ~more; j != m_none; j = m_next[j]) {
            f(j);
            if (j == cell.second)
                return;
        }
    }

    // The discs but i in three cells, each `step` after the last, written to `out`, where there is room for
    // all and one more; returns the end. Every other cell is empty and hardly one holds two discs: so that no
    // branch has to guess, what is not there is written as well, and overwritten by the next. Disc i can only
    // be in the middle of the three, if `withSelf`.
    template <bool withSelf>
    std::uint32_t* gatherThree(std::uint32_t i, const Cell* cell, std::size_t step,
                               std::uint32_t* out) const {
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k, cell += step) {
            *out = cell->first;
            out += (cell->first != m_none) & !(withSelf && k == 1 && cell->first == i);
            if (cell->second != m_none) [[unlikely]]
                out = gatherRest(i, *cell, out);
        }
        return out;
    }

private:
    std::uint32_t* gatherRest(std::uint32_t i, const Cell& cell, std::uint32_t* out) const {
        std::uint32_t j = cell.second & ~more;
        *out = j;
        out += j != i;
        if (j != cell.second)
            while ((j = m_next[j]) != m_none) {
                *out = j;
                out += j != i;
            }
        return out;
    }

    static constexpr std::uint32_t more = 1u << 31;
    static constexpr double mostInRow = 65'000; // numbered in 16 bits

    std::size_t cellOf(std::uint32_t column, std::uint32_t row) const {
        return std::size_t(row + 1) * m_stride + column + 1;
    }

    std::array<Axis, 2> m_axes;
    Two<Real> m_low{}, m_width{}, m_counts{}; // of the axes
    std::uint32_t m_stride = 3;
    std::uint32_t m_none = 0;
    std::vector<Cell> m_cells;
    std::vector<std::uint32_t> m_next; // in the list of a crowded cell
};

} // namespace thetalane

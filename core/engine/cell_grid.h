// Cells about one diameter of the largest disc wide: two discs that touch are in the same or adjacent ones.
#pragma once

#include "core/engine/packed_discs.h"

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
        while (along(x) * along(y) > most)
            width = width * Real(1.2f);
        m_axes = {Axis(x, along(x)), Axis(y, along(y))};
        m_none = std::uint32_t(discs);
        // A ring of cells that stay empty saves asking for the border.
        m_stride = m_axes[0].count + 2;
        m_heads.assign(std::size_t(m_stride) * (m_axes[1].count + 2), m_none);
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
        bool atBorder(std::uint32_t cell) const { return cell == 0 || cell + 1 == count; }

        // Time until something at q with speed v leaves its cell; never through the border.
        Real leavesIn(std::uint32_t cell, const Real& q, const Real& v) const {
            const bool up = v > 0;
            const Real in = (low + width * Real(cell + up) - q) / v;
            const bool stays = (v == Real(0)) | (up ? cell + 1 == count : cell == 0);
            return stays ? std::numeric_limits<Real>::infinity() : in > 0 ? in : Real(0);
        }
    };
    const Axis& columns() const { return m_axes[0]; }
    const Axis& rows() const { return m_axes[1]; }

    void insert(PackedDiscs<Real>& discs, std::uint32_t i) {
        auto& head = m_heads[cellOf(discs[i].column, discs[i].row)];
        discs[i].nextInCell = head;
        head = i;
    }
    void remove(PackedDiscs<Real>& discs, std::uint32_t i) {
        std::uint32_t* link = &m_heads[cellOf(discs[i].column, discs[i].row)];
        while (*link != i)
            link = &discs[*link].nextInCell;
        *link = discs[i].nextInCell;
    }

    // The discs but i in columns c0…c1 and rows r0…r1, each counted from one, so that one past the border is
    // 0; written to `out`, where there is room for all and one more. Returns how many. Every other cell is
    // empty and hardly one holds two discs of about its size: so that no branch has to guess, an empty one
    // gives none(), which the next overwrites.
    std::size_t gather(const PackedDiscs<Real>& discs, std::uint32_t i, std::uint32_t c0, std::uint32_t c1,
                       std::uint32_t r0, std::uint32_t r1, std::uint32_t* out) const {
        std::size_t count = 0;
        for (std::uint32_t r = r0; r <= r1; ++r) {
            const std::uint32_t* cell = &m_heads[std::size_t(r) * m_stride + c0];
            for (const std::uint32_t* last = cell + (c1 - c0); cell <= last; ++cell) {
                std::uint32_t j = *cell;
                do {
                    out[count] = j;
                    count += (j != m_none) & (j != i);
                    j = discs[j].nextInCell;
                } while (j != m_none);
            }
        }
        return count;
    }

private:
    std::size_t cellOf(std::uint32_t column, std::uint32_t row) const {
        return std::size_t(row + 1) * m_stride + column + 1;
    }

    std::array<Axis, 2> m_axes;
    std::uint32_t m_stride = 3;
    std::uint32_t m_none = 0;
    std::vector<std::uint32_t> m_heads; // the first disc of each cell
};

} // namespace thetalane

// The search for many bodies: a disc is compared with those in its own and the adjacent cells, and events
// wait in a tournament.
//
// Each disc keeps its best collision and, apart, its next event on its own: a wall, an edge of the lane, or
// the edge of its cell, where it looks at the cells that become adjacent. The best collision is kept though
// it lie after the crossing: its partner may be adjacent already, and not be looked at again. A collision
// whose partner changed course stays in the queue, too early rather than too late, and is found again when it
// comes up. In an open scene the cells are laid anew once enough has happened outside of them.
#pragma once

#include "core/engine/cell_grid.h"
#include "core/engine/earliest_tree.h"
#include "core/engine/first_event.h"
#include "core/engine/nearby.h"
#include "core/engine/surroundings.h"

#include <algorithm>
#include <vector>

namespace thetalane {

template <class Real, bool> class Cells {
public:
    using Index = std::size_t;
    static constexpr Index nobody = Index(-1);
    static constexpr bool rebasesTime = true;

    explicit Cells(const Scene& scene)
        : m_discs(scene.bodies)
        , m_frame(scene.frame.value_or(Frame{}))
        , m_slots(m_discs.count())
        , m_queue(m_discs.count())
        , m_near(m_discs.count() + 1) {
        for (Index i = 0; i < m_discs.count(); ++i)
            m_reach = std::max(m_reach, Real(2 * m_discs[i].radius));
        m_open = !(m_frame.left && m_frame.right && m_frame.bottom && m_frame.top);
    }

    PackedDiscs<Real>& discs() { return m_discs; }
    const PackedDiscs<Real>& discs() const { return m_discs; }

    template <class Around> void start(const Around& around) { layOut(around, Real(0)); }

    // Crossings and collisions that have become void are dealt with on the way, also after the end of the
    // run: whether anything more will happen is known only then. In open space that is soon.
    template <class Around> FirstEvent<Real> earliest(const Around& around) {
        for (;;) {
            const auto i = unsigned(m_queue.first());
            const Slot& slot = m_slots[i];
            if (slot.pairTime < slot.own.time) {
                if (m_discs[slot.partner].changes == slot.partnerChanges)
                    return {i, {slot.pairTime, slot.partner, EventKind::Pair, 0}, false};
                const Real now = slot.pairTime;
                look(around, i, now);
            } else if (slot.own.kind == EventKind::Cell) {
                cross(around, i, slot.own.time);
            } else {
                return {i, slot.own, false};
            }
        }
    }

    template <class Around> void changedCourse(const Around& around, Index i, Index j, const Real& now) {
        ++m_events;
        ++m_discs[i].changes;
        if (j != nobody)
            ++m_discs[j].changes;
        look(around, unsigned(i), now);
        if (j != nobody)
            look(around, unsigned(j), now);
    }

    template <class Around>
    void changedCourse(const Around& around, std::span<const Index> bodies, const Real& now) {
        for (const Index b : bodies)
            ++m_discs[b].changes;
        m_events += bodies.size();
        for (const Index b : bodies)
            look(around, unsigned(b), now);
    }
    template <class F> void forEachNear(Index i, const Real&, F&& f) {
        const PackedDisc<Real>& d = m_discs[i];
        const std::size_t count =
            m_grid.gather(m_discs, unsigned(i), d.column, d.column + 2, d.row, d.row + 2, m_near.data());
        for (std::size_t k = 0; k < count; ++k)
            f(Index(m_near[k]));
    }

    void shiftTime(const Real& shift) {
        for (Index i = 0; i < m_discs.count(); ++i) {
            m_discs[i].since = m_discs[i].since - shift;
            m_slots[i].pairTime = m_slots[i].pairTime - shift;
            m_slots[i].own.time = m_slots[i].own.time - shift;
        }
        m_queue.shiftTime(shift);
    }

private:
    struct Slot {
        Real pairTime = std::numeric_limits<Real>::infinity();
        NextEvent<Real> own;
        std::uint32_t partner = 0;
        std::uint32_t partnerChanges = 0;
    };

    // All that can happen to disc i next.
    template <class Around> void look(const Around& around, unsigned i, const Real& now) {
        const PackedDisc<Real>& d = m_discs[i];
        m_slots[i].pairTime = std::numeric_limits<Real>::infinity();
        if (around.inPlay(i))
            lookIn(around, i, now, d.column, d.column + 2, d.row, d.row + 2);
        findOwn(around, i, now);
        wait(around, i, now);
    }

    // Rows and columns as CellGrid::visit() counts them.
    template <class Around>
    void lookIn(const Around& around, unsigned i, const Real& now, std::uint32_t c0, std::uint32_t c1,
                std::uint32_t r0, std::uint32_t r1) {
        Slot& slot = m_slots[i];
        const std::size_t count = m_grid.gather(m_discs, i, c0, c1, r0, r1, m_near.data());
        m_looked = count;
        Nearby<Real> nearby(m_discs[i], now);
        const auto best = nearby.earliest(m_discs, m_near.data(), count, {slot.pairTime, m_grid.none()},
                                          [&around](std::uint32_t j) { return around.inPlay(j); });
        if (best.partner != m_grid.none())
            slot = {best.time, slot.own, best.partner, m_discs[best.partner].changes};
    }

    template <class Around> void findOwn(const Around& around, unsigned i, const Real& now) {
        const PackedDisc<Real>& d = m_discs[i];
        const Vec2<Real> p = d.positionAt(now);
        NextEvent<Real>& own = m_slots[i].own;
        own = {};
        // Walls are reached from the cells at the border alone.
        const bool border = m_grid.columns().atBorder(d.column) || m_grid.rows().atBorder(d.row);
        if (Around::hasLane || (Around::hasFrame && border))
            own = around.next(i, now, {p, d.velocity, {}, d.radius});
        if (m_open && border && !(m_grid.columns().holds(p.x) && m_grid.rows().holds(p.y)))
            m_outside += 1 + m_looked;
        if (!around.inPlay(i))
            return;
        const Real inX = m_grid.columns().leavesIn(d.column, p.x, d.velocity.x);
        const Real inY = m_grid.rows().leavesIn(d.row, p.y, d.velocity.y);
        const Real time = now + std::min(inX, inY);
        if (time < own.time)
            own = {time, 0, EventKind::Cell, static_cast<unsigned char>(inY < inX)};
    }

    // Disc i enters the next cell: it stays as it is, and looks at the three cells that become adjacent.
    template <class Around> void cross(const Around& around, unsigned i, Real now) {
        PackedDisc<Real>& d = m_discs[i];
        m_grid.remove(m_discs, i);
        const bool alongY = m_slots[i].own.detail;
        const bool up = (alongY ? d.velocity.y : d.velocity.x) > 0;
        (alongY ? d.row : d.column) += up ? 1u : ~0u;
        m_grid.insert(m_discs, i);
        const std::uint32_t column = d.column, row = d.row, ahead = up ? 2 : 0;
        if (alongY)
            lookIn(around, i, now, column, column + 2, row + ahead, row + ahead);
        else
            lookIn(around, i, now, column + ahead, column + ahead, row, row + 2);
        findOwn(around, i, now);
        wait(around, i, now);
    }

    // Laying the cells anew costs a few looks of each disc; as many are wasted outside before.
    // Never without collisions: what only flies apart comes to its last crossing.
    template <class Around> void wait(const Around& around, unsigned i, const Real& now) {
        m_queue.change(i, std::min(m_slots[i].pairTime, m_slots[i].own.time));
        if (m_open && m_outside > 8 * m_discs.count() && 16 * m_events > m_discs.count())
            layOut(around, now);
    }

    template <class Around> void layOut(const Around& around, const Real& now) {
        m_outside = 0;
        m_events = 0;
        m_grid.layOut(region(now, &Vec2<Real>::x, m_frame.left, m_frame.right),
                      region(now, &Vec2<Real>::y, m_frame.bottom, m_frame.top), m_reach, m_discs.count());
        for (Index i = 0; i < m_discs.count(); ++i) {
            const Vec2<Real> p = m_discs[i].positionAt(now);
            m_discs[i].column = m_grid.columns().cellAt(p.x);
            m_discs[i].row = m_grid.rows().cellAt(p.y);
            m_slots[i] = {};
        }
        // Each looks at those before it, which are in their cells already: every pair once.
        for (unsigned i = 0; i < m_discs.count(); ++i) {
            const PackedDisc<Real>& d = m_discs[i];
            if (around.inPlay(i))
                lookIn(around, i, now, d.column, d.column + 2, d.row, d.row + 2);
            findOwn(around, i, now);
            m_grid.insert(m_discs, i);
            m_queue.set(i, std::min(m_slots[i].pairTime, m_slots[i].own.time));
        }
        m_queue.build();
    }

    // Where the cells are laid: to the walls, or half as far again as most of the centres lie.
    typename CellGrid<Real>::Range region(const Real& now, Real Vec2<Real>::*along,
                                          const std::optional<double>& low,
                                          const std::optional<double>& high) const {
        std::vector<Real> centres;
        for (Index i = 0; i < m_discs.count(); ++i)
            centres.push_back(m_discs[i].positionAt(now).*along);
        const auto strays = std::ptrdiff_t(centres.size() / 64);
        std::nth_element(centres.begin(), centres.begin() + strays, centres.end());
        const Real first = centres[std::size_t(strays)];
        std::nth_element(centres.begin(), centres.end() - 1 - strays, centres.end());
        const Real last = *(centres.end() - 1 - strays);
        const Real more = std::max(Real((last - first) / 2), m_reach);
        return {low ? Real(*low) : Real(first - more), high ? Real(*high) : Real(last + more)};
    }

    PackedDiscs<Real> m_discs;
    Frame m_frame;
    bool m_open = true;
    Real m_reach{0};
    std::vector<Slot> m_slots;
    CellGrid<Real> m_grid;
    EarliestTree<Real> m_queue;
    std::vector<std::uint32_t> m_near; // of the last lookIn()
    std::size_t m_looked = 0;          // at how many, the last time
    std::size_t m_events = 0;          // since the cells were laid
    std::size_t m_outside = 0;         // looks since the cells were laid, by discs outside of them
};

} // namespace thetalane

// The search for many bodies: a disc is compared with those in its own and the adjacent cells, and events
// wait in a calendar.
//
// Each disc keeps its best collision and, apart, its next event on its own: a wall, an edge of the lane, or
// the edge of its cell, where it looks at the cells that become adjacent. The best collision is kept though
// it lie after the crossing: its partner may be adjacent already, and not be looked at again. A collision
// whose partner changed course stays in the queue, too early rather than too late, and is found again when it
// comes up. In an open scene the cells are laid anew once enough has happened outside of them.
#pragma once

#include "core/engine/cell_grid.h"
#include "core/engine/event_calendar.h"
#include "core/engine/first_event.h"
#include "core/engine/nearby.h"
#include "core/engine/surroundings.h"

#include <algorithm>
#include <span>
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
        , m_queue(m_slots, known(m_discs.count())) {
        for (Index i = 0; i < m_discs.count(); ++i)
            m_reach = std::max(m_reach, Real(2 * m_discs[i].radius));
        m_fetches = m_discs.count() > manyDiscs;
        m_open = !(m_frame.left && m_frame.right && m_frame.bottom && m_frame.top);
    }

    // A copy, for a snapshot: without what is found again from the rest. resume() makes it a search.
    Cells(const Cells& other)
        : m_discs(other.m_discs)
        , m_frame(other.m_frame)
        , m_open(other.m_open)
        , m_reach(other.m_reach)
        , m_slots(other.m_slots)
        , m_grid(other.m_grid)
        , m_queue(m_slots, known(m_slots.size()))
        , m_lastShift(other.m_lastShift)
        , m_fetches(other.m_fetches)
        , m_events(other.m_events)
        , m_outside(other.m_outside) {}
    Cells& operator=(const Cells&) = delete;
    void resume() {
        makeRoom();
        m_queue.build();
    }

    PackedDiscs<Real>& discs() { return m_discs; }
    const PackedDiscs<Real>& discs() const { return m_discs; }

    template <class Around> void start(const Around& around) {
        makeRoom();
        layOut(around, Real(0));
    }

    // Crossings and collisions that have become void are dealt with on the way, also after the end of the
    // run: whether anything more will happen is known only then. In open space that is soon.
    template <class Around> FirstEvent<Real> earliest(const Around& around) {
        for (;;) {
            const auto [time, i] = m_queue.first();
            if (!(time < std::numeric_limits<Real>::infinity()))
                return {0, {}, false};
            if (m_fetches)
                fetchAhead();
            if (settle(around, i, time))
                continue;
            const FirstEvent<Real> first = firstOf(i);
            const Real end = windowEnd(time);
            bool settled = true, tied = tiedInSlot(around, i, first, end);
            if (!tied)
                m_queue.following(end, [&](const auto& other) {
                    settled = !settle(around, other.id, end);
                    tied = tied || tiedInSlot(around, other.id, first, end);
                    return settled && !tied;
                });
            if (settled && !settle(around, i, end))
                return {first.body, first.event, tied};
        }
    }

    template <class Around> void changedCourse(const Around& around, Index i, Index j, const Real& now) {
        const Index both[] = {i, j};
        changedCourse(around, std::span(both, j == nobody ? 1 : 2), now);
    }
    // A group, all moved to `now`.
    template <class Around>
    void changedCourse(const Around& around, std::span<const Index> bodies, const Real& now) {
        ++m_events;
        for (const Index i : bodies)
            ++m_discs[i].changes;
        for (const Index i : bodies)
            look(around, unsigned(i), now);
    }

    // f(j) for every other body j that could touch body i at this instant, and some that could not.
    template <class F> void forEachNear(Index i, const Real&, F&& f) const {
        const auto* row = m_grid.around(m_discs[i].column, m_discs[i].row);
        for (int k = 0; k < 3; ++k, row += m_grid.stride())
            for (int c = 0; c < 3; ++c)
                m_grid.forEachIn(row[c], [&](std::uint32_t j) {
                    if (j != i)
                        f(Index(j));
                });
    }

    void shiftTime(const Real& shift) {
        m_lastShift = shift;
        for (Index i = 0; i < m_discs.count(); ++i) {
            Slot& slot = m_slots[i];
            m_discs[i].since = m_discs[i].since - shift;
            slot.pair.time = slot.pair.time - shift;
            slot.pair.next = slot.pair.next - shift;
            slot.own.time = slot.own.time - shift;
        }
        m_queue.build();
    }

private:
    struct alignas(sizeof(Real) == 8 ? 64 : alignof(Real)) Slot {
        Meeting<Real> pair;
        std::uint32_t partnerChanges = 0;
        NextEvent<Real> own;

        bool isPair() const { return pair.time < own.time; }
        Real time() const { return std::min(pair.time, own.time); }
    };

    // So many discs are not in the processor's cache: what the next events need is asked for ahead, first the
    // disc and its partner, then the cells that will be looked at, then who is in them.
    void fetchAhead() {
        const auto third = m_queue.ahead(4);
        prefetch(&m_discs[third]);
        prefetch(&m_discs[m_slots[third].pair.partner]);
        prefetch(&m_slots[m_slots[third].pair.partner]);
        overCells(m_queue.ahead(2), [](const auto* row) {
            prefetch(row);
            prefetch(row + 2);
        });
        overCells(m_queue.ahead(1), [this](const auto* row) {
            for (int c = 0; c < 3; ++c)
                prefetch(&m_discs[0] + row[c].first);
        });
    }
    // f(row) for three rows of three cells, about disc i where it comes to be, and about its partner.
    template <class F> void overCells(unsigned i, F&& f) {
        const auto rowsAbout = [&](unsigned j, int right, int up) {
            const auto* row = m_grid.around(m_discs[j].column, m_discs[j].row) + right;
            row += std::ptrdiff_t(up) * m_grid.stride();
            for (int k = 0; k < 3; ++k, row += m_grid.stride())
                f(row);
        };
        const Slot& slot = m_slots[i];
        if (slot.isPair()) {
            rowsAbout(i, 0, 0);
            rowsAbout(slot.pair.partner, 0, 0);
        } else if (slot.own.kind == EventKind::Cell) {
            const Vec2<Real> v = m_discs[i].velocity;
            const bool alongY = slot.own.detail;
            rowsAbout(i, alongY ? 0 : v.x > 0 ? 1 : -1, !alongY ? 0 : v.y > 0 ? 1 : -1);
        }
    }
    static constexpr std::size_t manyDiscs = 5000;
    // How many events the calendar knows ahead.
    static std::size_t known(std::size_t discs) { return discs > manyDiscs ? 6 : 1; }
    void makeRoom() {
        m_near.resize(m_discs.count() + 2 + Nearby<Real>::atOnce);
        m_at.resize(m_near.size());
    }
    static void prefetch(const void* p) { __builtin_prefetch(p); }

    // If what disc i comes to until `end` is void or a mere crossing, it is dealt with.
    template <class Around> bool settle(const Around& around, unsigned i, const Real& end) {
        const Slot& slot = m_slots[i];
        if (slot.isPair() && m_discs[slot.pair.partner].changes != slot.partnerChanges)
            look(around, i, Real(slot.pair.time));
        else if (slot.own.kind == EventKind::Cell && slot.own.time <= end)
            cross(around, i, Real(slot.own.time));
        else
            return false;
        return true;
    }

    FirstEvent<Real> firstOf(unsigned i) const {
        const Slot& slot = m_slots[i];
        if (slot.isPair())
            return {i, {slot.pair.time, slot.pair.partner, EventKind::Pair, 0}, false};
        return {i, slot.own, false};
    }

    // Times of the same instant are as far apart as the rounding of positions and of times makes them.
    Real windowEnd(const Real& time) const { return time + tieWindow<Real>(std::abs(time) + m_lastShift); }

    // Whether disc i comes to another contact until `end`.
    template <class Around>
    bool tiedInSlot(const Around& around, unsigned i, const FirstEvent<Real>& first, const Real& end) const {
        const Slot& slot = m_slots[i];
        const bool pair = first.event.kind == EventKind::Pair, isFirst = i == first.body;
        const bool samePair =
            pair && (isFirst || (i == first.event.partner && slot.pair.partner == first.body));
        if (slot.pair.next <= end || (slot.pair.time <= end && !samePair))
            return true;
        if (slot.own.time <= end && (pair || !isFirst))
            return slot.own.kind != EventKind::Cell;
        return isFirst && first.event.kind == EventKind::Wall && inCorner(around, i, first.event, end);
    }

    // Whether disc i, which meets a wall, meets another until `end`.
    template <class Around>
    bool inCorner(const Around& around, unsigned i, const NextEvent<Real>& event, const Real& end) const {
        if constexpr (Around::hasFrame) {
            const PackedDisc<Real>& d = m_discs[i];
            const Vec2<Real> p = d.positionAt(event.time);
            for (const Side side : sides) {
                const Real wall = around.walls().at[int(side)];
                const auto a = approachTo(side, wall, p, d.velocity, d.radius);
                const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * (std::abs(wall) + d.radius);
                if (side != Side(event.detail) && a.speed > 0 &&
                    a.gap <= a.speed * (end - event.time) + rounding)
                    return !(a.gap == std::numeric_limits<Real>::infinity());
            }
        }
        return false;
    }

    // All that can happen to disc i next.
    template <class Around> void look(const Around& around, unsigned i, const Real& now) {
        const Real before = m_slots[i].time();
        m_looked = around.inPlay(i) ? gatherAll(i) : 0;
        find(around, i, now, {});
        wait(around, i, before, now);
    }

    std::size_t gatherAll(unsigned i) {
        const auto* row = m_grid.around(m_discs[i].column, m_discs[i].row);
        std::uint32_t* end = m_near.data();
        end = m_grid.template gatherThree<false>(i, row, 1, end);
        end = m_grid.template gatherThree<true>(i, row + m_grid.stride(), 1, end);
        end = m_grid.template gatherThree<false>(i, row + 2 * m_grid.stride(), 1, end);
        return std::size_t(end - m_near.data());
    }

    // What comes first, of what is known so far and with the discs gathered, and what disc i does on its own.
    template <class Around>
    void find(const Around& around, unsigned i, const Real& now, const Meeting<Real>& sofar) {
        std::uint32_t* end = m_near.data() + m_looked;
        if constexpr (Around::hasLane)
            end = std::remove_if(m_near.data(), end, [&](std::uint32_t j) { return !around.inPlay(j); });
        for (std::size_t k = 0; k + 1 < Nearby<Real>::atOnce; ++k)
            end[k] = i; // whom it never meets
        Nearby<Real> nearby(m_discs[i], now);
        Slot& slot = m_slots[i];
        slot.pair = nearby.earliest(&m_discs[0], m_near.data(), end, m_at.data(), sofar);
        if (slot.pair.next <= windowEnd(slot.pair.time) && sofar.time < std::numeric_limits<Real>::infinity())
            [[unlikely]]
            slot.pair.next = nextButFirst(nearby, i, end, slot.pair, sofar);
        const bool kept = (slot.pair.time == sofar.time) & (slot.pair.partner == sofar.partner);
        const std::uint32_t changes = m_discs[slot.pair.partner].changes;
        slot.partnerChanges = kept ? slot.partnerChanges : changes;
        findOwn(around, i, now, nearby.position());
    }

    // A disc that was known already and comes near again is not tied with itself.
    Real nextButFirst(const Nearby<Real>& nearby, unsigned i, const std::uint32_t* end,
                      const Meeting<Real>& first, const Meeting<Real>& sofar) {
        std::replace(m_near.data(), m_near.data() + m_looked, first.partner, std::uint32_t(i));
        const Real next = sofar.partner == first.partner ? sofar.next : std::min(sofar.time, sofar.next);
        return nearby
            .earliest(&m_discs[0], m_near.data(), end, m_at.data(), {first.time, next, first.partner})
            .next;
    }

    template <class Around>
    void findOwn(const Around& around, unsigned i, const Real& now, const Vec2<Real>& p) {
        const PackedDisc<Real>& d = m_discs[i];
        NextEvent<Real> own;
        // Walls are reached from the cells at the border alone.
        const bool border = m_grid.atBorder(d.column, d.row);
        if (Around::hasLane || (Around::hasFrame && border))
            own = around.next(i, now, {p, d.velocity, {}, d.radius});
        if (m_open && border && !(m_grid.columns().holds(p.x) && m_grid.rows().holds(p.y)))
            m_outside += 1 + m_looked;
        if (around.inPlay(i)) {
            const auto [in, alongY] = m_grid.leaves(d.column, d.row, p, d.velocity);
            const Real time = now + in;
            if (time < own.time)
                own = {time, 0, EventKind::Cell, static_cast<unsigned char>(alongY)};
        }
        m_slots[i].own = own;
    }

    // Disc i enters the next cell: it stays as it is, and looks at the three cells that become adjacent.
    template <class Around> void cross(const Around& around, unsigned i, const Real& now) {
        PackedDisc<Real>& d = m_discs[i];
        m_grid.remove(m_discs, i);
        const bool alongY = m_slots[i].own.detail;
        const bool up = (alongY ? d.velocity.y : d.velocity.x) > 0;
        (alongY ? d.row : d.column) += std::uint16_t(up ? 1 : -1);
        const std::size_t step = alongY ? 1 : m_grid.stride(), across = alongY ? m_grid.stride() : 1;
        const auto* cell = m_grid.around(d.column, d.row) + (up ? 2 * across : 0);
        const std::uint32_t* end = m_grid.template gatherThree<false>(i, cell, step, m_near.data());
        m_looked = std::size_t(end - m_near.data());
        m_grid.insert(m_discs, i);
        const Real before = m_slots[i].time();
        find(around, i, now, Meeting<Real>(m_slots[i].pair));
        wait(around, i, before, now);
    }

    // Laying the cells anew costs a few looks of each disc; as many are wasted outside before.
    // Never without collisions: what only flies apart comes to its last crossing.
    template <class Around> void wait(const Around& around, unsigned i, const Real& before, const Real& now) {
        if (m_slots[i].time() != before)
            m_queue.add(i);
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
            m_discs[i].column = std::uint16_t(m_grid.columns().cellAt(p.x));
            m_discs[i].row = std::uint16_t(m_grid.rows().cellAt(p.y));
            m_slots[i] = {};
        }
        // Each looks at those before it, which are in their cells already: every pair once.
        for (unsigned i = 0; i < m_discs.count(); ++i) {
            m_looked = around.inPlay(i) ? gatherAll(i) : 0;
            find(around, i, now, {});
            m_grid.insert(m_discs, i);
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
    EventCalendar<Real, Slot> m_queue;
    Real m_lastShift{0};
    bool m_fetches = false;
    std::vector<std::uint32_t> m_near; // of the last look
    std::vector<Real> m_at;            // when each of them is met
    std::size_t m_looked = 0;          // at how many, the last time
    std::size_t m_events = 0;          // since the cells were laid
    std::size_t m_outside = 0;         // looks since the cells were laid, by discs outside of them
};

} // namespace thetalane

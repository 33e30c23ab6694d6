// Which of many times are the earliest, when a few of them change at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace thetalane {

// Each slot knows the time() of its next event; here its number lies on a wheel of days a few events long
// (Brown's calendar queue, 1988; Paul, J. Comput. Phys. 221, 2007). Only the events of today are sorted. A
// slot that changes its time is written on another day and left where it was, too: an entry counts if the
// slot has its time still. What lies more than a turn of the wheel ahead waits apart and is looked through
// once in a turn. The cost does not grow with the count, a change touches one line of memory, and what comes
// next is known ahead.
template <class Real, class Slot> class EventCalendar {
public:
    using Id = std::uint32_t;
    struct Entry {
        Real time;
        Id id;
    };

    // `known`: how many events are wanted in order at any time.
    EventCalendar(const std::vector<Slot>& slots, std::size_t known)
        : m_slots(slots.data())
        , m_count(Id(slots.size()))
        , m_known(known) {}
    EventCalendar(const EventCalendar&) = delete; // the slots of a copy are others
    EventCalendar& operator=(const EventCalendar&) = delete;

    // From what the slots say.
    void build() {
        if (m_wheel.empty())
            makeWheel();
        m_from = never;
        for (Id i = 0; i < m_count; ++i)
            m_from = std::min(m_from, m_slots[i].time());
        m_from = m_from < never ? m_from : Real(0);
        m_today.clear();
        m_later.clear();
        m_crowds.resize(1);
        m_free = 0;
        std::fill(m_crowdOf.begin(), m_crowdOf.end(), 0);
        std::fill(m_counts.begin(), m_counts.end(), 0);
        if (!(m_perSecond > Real(0)))
            m_perSecond = guess();
        m_day = 0;
        m_endOfToday = Real(0);
        m_listed = m_sorted = m_passed = 0;
        for (Id i = 0; i < m_count; ++i)
            add(i);
    }

    // Slot i has another time now.
    void add(Id i) {
        const Real time = m_slots[i].time(), day = dayOf(time);
        if (day < m_endOfToday)
            insertToday({time, i});
        else if (day < endOfTurn())
            list(static_cast<std::int64_t>(day), i);
        else if (time < never)
            m_later.push_back({time, i});
    }

    // The earliest; of equals the first. The time is infinite if nothing is to come.
    Entry first() {
        if (m_today.size() > 4 * mostSorted && m_sorted > m_count)
            rebuild(guess());
        for (;;) {
            while (!m_today.empty() && !counts(m_today.back()))
                m_today.pop_back();
            if (m_today.size() >= m_known || !anyLeft())
                return m_today.empty() ? Entry{never, 0} : m_today.back();
            openNext();
        }
    }

    // Those after the first(), in order, up to `until`: f(entry) says whether to go on.
    template <class F> void following(const Real& until, F&& f) {
        for (const Real last = dayOf(until); last >= m_endOfToday && anyLeft();)
            openDay();
        for (std::size_t k = m_today.size() - 1; k-- > 0 && m_today[k].time <= until;)
            if (counts(m_today[k]) && !f(m_today[k]))
                return;
    }

    // Perhaps the k-th after the first(), for fetching it ahead.
    Id ahead(std::size_t k) const {
        const std::size_t left = m_today.size();
        return m_today[k < left ? left - 1 - k : 0].id;
    }

private:
    static constexpr int eventsADay = 4;
    static constexpr std::size_t mostSorted = 64;
    static constexpr std::int64_t mostDays = 1 << 22; // told apart by a float
    static inline const Real never = std::numeric_limits<Real>::infinity();

    static constexpr std::size_t room = 16;
    struct alignas(64) Day {
        std::array<Id, room> ids;
    };
    // What had no room on its day any more, sixteen at a time.
    struct Crowd {
        Day day;
        Id next; // of the same day; 0: no more
    };

    void makeWheel() {
        std::size_t days = 16;
        while (days * eventsADay < 2 * m_count)
            days *= 2;
        m_wheel.resize(days);
        m_counts.resize(days);
        m_crowdOf.resize(days);
        m_today.reserve(mostSorted);
    }

    bool counts(const Entry& e) const { return m_slots[e.id].time() == e.time; }
    bool anyLeft() const { return m_listed > 0 || !m_later.empty(); }
    Real dayOf(const Real& time) const { return (time - m_from) * m_perSecond; }
    Real endOfTurn() const { return Real(m_day + std::int64_t(m_wheel.size())); }
    std::size_t onWheel(std::int64_t day) const { return std::size_t(day) & (m_wheel.size() - 1); }

    void list(std::int64_t at, Id i) {
        const std::size_t day = onWheel(at);
        ++m_listed;
        if (m_counts[day] == room) [[unlikely]]
            makeRoom(day);
        m_wheel[day].ids[m_counts[day]++] = i;
    }
    void makeRoom(std::size_t day) {
        Id crowd = m_free;
        if (crowd == 0) {
            crowd = Id(m_crowds.size());
            m_crowds.emplace_back();
        } else {
            m_free = m_crowds[crowd].next;
        }
        m_crowds[crowd] = {m_wheel[day], m_crowdOf[day]};
        m_crowdOf[day] = crowd;
        m_counts[day] = 0;
    }

    static bool later(const Entry& a, const Entry& b) {
        return a.time > b.time || (a.time == b.time && a.id > b.id);
    }
    // A few are counted to their places, which leaves nothing to guess.
    static void sort(Entry* entries, std::size_t count) {
        std::array<Entry, 8> old;
        if (count > old.size())
            return std::sort(entries, entries + count, later);
        for (std::size_t a = 0; a < count; ++a)
            old[a] = entries[a];
        for (std::size_t a = 0; a < count; ++a) {
            std::size_t place = 0;
            for (std::size_t b = 0; b < count; ++b)
                place += (old[b].time > old[a].time) |
                         ((old[b].time == old[a].time) &
                          ((old[b].id > old[a].id) | ((old[b].id == old[a].id) & (b < a))));
            entries[place] = old[a];
        }
    }
    void insertToday(const Entry& e) {
        std::size_t k = m_today.size();
        m_today.push_back(e);
        ++m_sorted;
        for (; k > 0 && later(e, m_today[k - 1]); --k)
            m_today[k] = m_today[k - 1];
        m_today[k] = e;
    }

    void openNext() {
        const std::size_t before = m_today.size();
        for (std::size_t empty = 0; m_today.size() == before && anyLeft(); ++empty) {
            if (empty > m_wheel.size() || m_passed + m_sorted > 4 * m_count + 256) {
                adapt();
                return;
            }
            openDay();
        }
    }

    // The days' length is measured; after a turn of the wheel without an event they are made longer.
    void adapt() {
        const Real events = Real(m_sorted) / Real(m_passed + 1);
        if (m_sorted == 0)
            rebuild(m_perSecond / 16);
        else if (events > 2 * eventsADay || 2 * events < eventsADay || m_day > mostDays)
            rebuild(m_perSecond * events / eventsADay);
        else
            m_sorted = m_passed = 0;
    }
    void rebuild(const Real& perSecond) {
        m_perSecond = perSecond;
        build();
    }

    // The events of the next day, or what was left of a long one, are sorted in front of what is left of
    // today.
    void openDay() {
        if (!(m_endOfToday < Real(m_day + 1))) {
            ++m_day;
            ++m_passed;
            if (onWheel(m_day) == 0)
                fillTurn();
        }
        const std::size_t day = onWheel(m_day);
        const Real from = m_endOfToday;
        m_endOfToday = Real(m_day + 1);
        const std::size_t before = m_today.size();
        // Half of them may be void: written all the same, and overwritten by the next.
        m_today.resize(before + m_counts[day] + 1);
        Entry* end = m_today.data() + before;
        const auto take = [&](Id i) {
            const Real time = m_slots[i].time(), on = dayOf(time);
            *end = {time, i};
            end += (on >= from) & (on < m_endOfToday);
        };
        for (std::size_t k = 0; k < m_counts[day]; ++k)
            take(m_wheel[day].ids[k]);
        m_listed -= m_counts[day];
        while (const Id crowd = std::exchange(m_crowdOf[day], m_crowds[m_crowdOf[day]].next)) {
            const std::size_t taken = std::size_t(end - m_today.data());
            m_today.resize(taken + room + 1);
            end = m_today.data() + taken;
            for (const Id i : m_crowds[crowd].day.ids)
                take(i);
            m_listed -= room;
            m_crowds[crowd].next = std::exchange(m_free, crowd);
        }
        m_today.resize(std::size_t(end - m_today.data()));
        m_counts[day] = 0;
        const auto opened = m_today.begin() + std::ptrdiff_t(before);
        if (m_today.size() - before > mostSorted)
            split(opened);
        m_sorted += m_today.size() - before;
        sort(m_today.data() + before, m_today.size() - before);
        if (before > 0)
            std::rotate(m_today.begin(), opened, m_today.end());
        const std::size_t next = onWheel(m_day + 1);
        for (std::size_t k = 0; k < m_counts[next]; ++k)
            __builtin_prefetch(&m_slots[m_wheel[next].ids[k]]);
        __builtin_prefetch(&m_wheel[onWheel(m_day + 2)]);
    }

    // Of a long day only the beginning is sorted.
    void split(typename std::vector<Entry>::iterator opened) {
        std::nth_element(opened, opened + mostSorted, m_today.end(),
                         [](const Entry& a, const Entry& b) { return later(b, a); });
        const Real last = dayOf(opened[mostSorted].time);
        const auto rest =
            std::partition(opened, m_today.end(), [&](const Entry& e) { return !(dayOf(e.time) > last); });
        for (auto e = rest; e != m_today.end(); ++e) {
            m_endOfToday = std::min(m_endOfToday, dayOf(e->time));
            list(m_day, e->id);
        }
        m_today.erase(rest, m_today.end());
    }

    // A new turn of the wheel: of what waited apart, what falls into it.
    void fillTurn() {
        std::size_t kept = 0;
        for (const Entry& e : m_later) {
            const Real day = dayOf(e.time);
            if (!(day < endOfTurn()))
                m_later[kept++] = e;
            else if (day >= m_endOfToday)
                list(static_cast<std::int64_t>(day), e.id);
        }
        m_later.resize(kept);
        if (kept > 2 * std::size_t(m_count))
            std::erase_if(m_later, [this](const Entry& e) { return !counts(e); });
    }

    // Half of what is to come comes before the median; as if at a rate that decays.
    Real guess() const {
        std::vector<Real> times;
        for (Id i = 0; i < m_count; ++i)
            if (m_slots[i].time() < never)
                times.push_back(m_slots[i].time());
        if (times.empty())
            return Real(1);
        const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
        std::nth_element(times.begin(), middle, times.end());
        const Real perSecond = Real(times.size()) * Real(0.7f) / (eventsADay * (*middle - m_from));
        return perSecond > Real(0) && perSecond < never ? perSecond : Real(1);
    }

    const Slot* m_slots;
    Id m_count;
    std::size_t m_known;
    std::vector<Day> m_wheel;
    std::vector<std::uint8_t> m_counts; // of each day; apart, so that no one waits for a day to be fetched
    std::vector<Id> m_crowdOf;          // the first of each day
    std::vector<Crowd> m_crowds = std::vector<Crowd>(1);
    Id m_free = 0;              // the first crowd that is not in use
    std::vector<Entry> m_later; // more than a turn ahead
    std::vector<Entry> m_today; // the earliest at the end
    Real m_from{0};             // where the days begin
    Real m_perSecond{0};        // how many days
    std::int64_t m_day = 0;     // today
    Real m_endOfToday{0};       // in days; before the end of the day while it is split
    std::size_t m_listed = 0;   // how many are on the wheel and in the crowd
    std::size_t m_sorted = 0;   // events since build()
    std::size_t m_passed = 0;   // days since build()
};

} // namespace thetalane

// Which of many times are the earliest, when a few of them change at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace thetalane {

// Each of `count` keeps one time, by which it lies on a wheel of days a few events long (Brown's calendar
// queue, 1988; Paul, J. Comput. Phys. 221, 2007). Only the events of today are sorted. What changes its time
// is taken out of its day at once, or, if the day is today, merely crossed out: an event of today counts as
// long as its time is still the one kept. What lies more than a turn of the wheel ahead waits apart, and is
// looked through once in a turn. The cost does not grow with the count, and the next events are known ahead.
template <class Real> class EventCalendar {
public:
    using Id = std::uint32_t;
    struct Entry {
        Real time;
        Id id;
    };

    explicit EventCalendar(std::size_t count)
        : m_count(Id(count)) {
        while (m_days < count)
            m_days *= 2;
        m_nodes.resize(count + m_days + 1);
        m_today.reserve(64);
    }

    // Without regard to the order, until build().
    void set(Id i, const Real& time) { m_nodes[i].time = time; }
    Real timeOf(Id i) const { return m_nodes[i].time; }

    void build() {
        Real first = never;
        for (Id i = 0; i < m_count; ++i)
            first = std::min(first, m_nodes[i].time);
        m_from = first < never ? first : Real(0);
        if (!(m_perDay > Real(0)))
            m_perDay = guess();
        m_today.clear();
        m_day = 0;
        m_endOfToday = Real(0);
        m_linked = m_sorted = m_passed = 0;
        for (Id n = 0; n < m_nodes.size(); ++n)
            m_nodes[n].before = m_nodes[n].after = n;
        for (Id i = 0; i < m_count; ++i)
            link(i);
    }

    void change(Id i, const Real& time) {
        Node& node = m_nodes[i];
        if (node.time == time)
            return;
        remove(i);
        node.time = time;
        link(i);
    }

    // The earliest; of equals the first. The time is infinite if nothing is to come.
    Entry first() {
        if (m_today.size() > 4 * mostSorted && m_sorted > m_count)
            rebuild(guess());
        for (;;) {
            while (!m_today.empty()) {
                if (counts(m_today.back()))
                    return m_today.back();
                m_today.pop_back();
            }
            if (!openNext())
                return {never, 0};
        }
    }

    // Those after the first(), in order, up to `until`: f(entry) says whether to go on.
    template <class F> void following(const Real& until, F&& f) {
        for (const Real last = dayOf(until); last >= m_endOfToday && m_linked > 0;)
            openDay();
        for (std::size_t k = m_today.size() - 1; k-- > 0 && m_today[k].time <= until;)
            if (counts(m_today[k]) && !f(m_today[k]))
                return;
    }

    // Perhaps the k-th after the first(), as far as known: for fetching it ahead.
    Id ahead(std::size_t k) const {
        return m_today.size() > k ? m_today[m_today.size() - 1 - k].id : head(1);
    }

private:
    static constexpr int perDayWanted = 2;
    static constexpr std::size_t mostSorted = 64;
    static constexpr std::int64_t mostDays = 1 << 22; // told apart by a float
    static inline const Real never = std::numeric_limits<Real>::infinity();

    struct Node {
        Real time = never;
        Id before = 0, after = 0; // itself: in no list
    };

    bool counts(const Entry& e) const { return m_nodes[e.id].time == e.time && m_nodes[e.id].after == e.id; }
    Real dayOf(const Real& time) const { return (time - m_from) * m_perDay; }
    Id dayNode(std::int64_t day) const { return m_count + Id(std::uint64_t(day) & (m_days - 1)); }
    Id laterNode() const { return m_count + Id(m_days); }
    Id head(std::int64_t ahead) const {
        const Id i = m_nodes[dayNode(m_day + ahead)].after;
        return i < m_count ? i : 0;
    }

    void link(Id i) {
        const Real time = m_nodes[i].time, day = dayOf(time);
        if (day < m_endOfToday)
            return insertToday({time, i});
        if (!(time < never))
            return;
        // What lies up to a turn has a day of its own on the wheel.
        append(day < Real(m_day + std::int64_t(m_days)) ? dayNode(static_cast<std::int64_t>(day))
                                                        : laterNode(),
               i);
    }
    void append(Id list, Id i) {
        Node& node = m_nodes[i];
        node.before = list;
        node.after = m_nodes[list].after;
        m_nodes[node.after].before = i;
        m_nodes[list].after = i;
        ++m_linked;
    }

    static bool later(const Entry& a, const Entry& b) {
        return a.time > b.time || (a.time == b.time && a.id > b.id);
    }
    void insertToday(const Entry& e) {
        std::size_t k = m_today.size();
        m_today.push_back(e);
        ++m_sorted;
        for (; k > 0 && later(e, m_today[k - 1]); --k)
            m_today[k] = m_today[k - 1];
        m_today[k] = e;
    }

    // False: nothing is to come.
    bool openNext() {
        for (std::size_t empty = 0; m_today.empty() && m_linked > 0; ++empty) {
            if (empty > m_days || m_passed + m_sorted > 4 * m_count + 256) {
                adapt();
                empty = 0;
            }
            openDay();
        }
        return !m_today.empty();
    }

    // The days' length is measured; after a turn of the wheel without an event they are made longer.
    void adapt() {
        const Real perDay = Real(m_sorted) / Real(m_passed + 1);
        if (m_sorted == 0)
            rebuild(m_perDay / 16);
        else if (perDay > 2 * perDayWanted || 2 * perDay < perDayWanted || m_day > mostDays)
            rebuild(m_perDay * perDay / perDayWanted);
        else
            m_sorted = m_passed = 0;
    }
    void rebuild(const Real& perDay) {
        m_perDay = perDay;
        build();
    }

    // The events of the next day, or what was left of a long one, are sorted in front of what is left of
    // today.
    void openDay() {
        if (!(m_endOfToday < Real(m_day + 1))) {
            ++m_day;
            ++m_passed;
            if (dayNode(m_day) == m_count)
                fillTurn();
        }
        m_endOfToday = Real(m_day + 1);
        const std::size_t before = m_today.size();
        Id i = m_nodes[dayNode(m_day)].after;
        if (i >= m_count)
            return;
        for (; i < m_count; i = remove(i))
            m_today.push_back({m_nodes[i].time, i});
        auto opened = m_today.begin() + std::ptrdiff_t(before);
        if (m_today.size() - before > mostSorted)
            split(opened);
        m_sorted += m_today.size() - before;
        std::sort(opened, m_today.end(), later);
        std::rotate(m_today.begin(), m_today.begin() + std::ptrdiff_t(before), m_today.end());
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
            append(dayNode(m_day), e->id);
        }
        m_today.erase(rest, m_today.end());
    }

    // A new turn of the wheel: of what waited apart, what falls into it.
    void fillTurn() {
        for (Id i = m_nodes[laterNode()].after, next; i < m_count; i = next) {
            next = m_nodes[i].after;
            if (dayOf(m_nodes[i].time) < Real(m_day + std::int64_t(m_days))) {
                remove(i);
                link(i);
            }
        }
    }

    Id remove(Id i) {
        Node& node = m_nodes[i];
        const Id after = node.after;
        m_linked -= after != i;
        m_nodes[node.before].after = after;
        m_nodes[after].before = node.before;
        node.before = node.after = i;
        return after;
    }

    // Half of what is to come comes before the median; as if at a rate that decays.
    Real guess() const {
        std::vector<Real> times;
        for (Id i = 0; i < m_count; ++i)
            if (m_nodes[i].time < never)
                times.push_back(m_nodes[i].time);
        if (times.empty())
            return Real(1);
        const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
        std::nth_element(times.begin(), middle, times.end());
        const Real perDay = Real(times.size()) * Real(0.7f) / (perDayWanted * (*middle - m_from));
        return perDay > Real(0) && perDay < never ? perDay : Real(1);
    }

    Id m_count;
    std::size_t m_days = 1;
    std::vector<Node> m_nodes;  // of each; then one for each day of the wheel; one for what comes later
    std::vector<Entry> m_today; // the earliest at the end
    Real m_from{0};             // where the days begin
    Real m_perDay{0};           // days to a second
    std::int64_t m_day = 0;     // today
    Real m_endOfToday{0};       // in days; before the end of the day while it is split
    std::size_t m_linked = 0;   // how many are in a list
    std::size_t m_sorted = 0;   // events since build()
    std::size_t m_passed = 0;   // days since build()
};

} // namespace thetalane

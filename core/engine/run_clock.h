// The clock of a running engine, and which events are of one instant.
#pragma once

#include "core/engine/first_event.h"

#include <cstddef>
#include <vector>

namespace thetalane {

// Times in the engine count from an epoch, which follows the run: the later, the less of a double would be
// left for the gaps between discs.
template <class Real> class RunClock {
public:
    explicit RunClock(double until) // s
        : m_until(until) {}

    const Real& now() const { return m_now; }
    const Real& until() const { return m_until; }
    void set(const Real& now) { m_now = now; }
    double absolute(const Real& time) const { return static_cast<double>(Real(m_epoch + time)); } // s
    double absolute() const { return absolute(m_now); }

    // A contact at what is still the instant of the last one: bodies that touch pass something on, which may
    // go to and fro below all rounding. Then all that touch are looked at together.
    bool isInstantOfLastContact() {
        const bool again = m_now - m_lastContact <= tieWindow<Real>(m_now);
        m_lastContact = m_now;
        return again;
    }

    // Events without end within a millionth of the contact time, which only rounding can make.
    bool isStuck(std::size_t bodies, double contactTime) {
        const bool still = m_now - m_stuckAt <= contactTime * 1e-6;
        m_eventsNow = still ? m_eventsNow + 1 : 0;
        if (!still)
            m_stuckAt = m_now;
        return m_eventsNow > 64 * bodies;
    }

    // The epoch moves once in many events of each disc; by few enough bits to be exact.
    template <class Search> void followEvents(Search& search) {
        constexpr std::size_t eventsOfEach = 64;
        const auto& discs = search.discs();
        if (++m_events < eventsOfEach * discs.count())
            return;
        m_events = 0;
        const Real shift = Real(static_cast<float>(m_now) * 0.999f);
        std::vector<double> starts(discs.count());
        for (std::size_t i = 0; i < starts.size(); ++i)
            starts[i] = startOf(i, discs.since(i));
        m_epoch = m_epoch + shift;
        m_now = m_now - shift;
        m_until = m_until - shift;
        m_lastContact = m_lastContact - shift;
        search.shiftTime(shift);
        m_started.resize(starts.size());
        for (std::size_t i = 0; i < starts.size(); ++i)
            m_started[i] = {discs.since(i), starts[i]};
    }

    // When body i's present stretch of motion began: as it was recorded then, whatever was shifted since [s].
    double startOf(std::size_t i, const Real& since) const {
        if (!m_started.empty() && m_started[i].since == since)
            return m_started[i].absolute;
        return absolute(since);
    }

private:
    // A stretch of motion that began before times were last shifted, which may have cost its start a bit.
    struct Started {
        Real since;
        double absolute; // s
    };

    Real m_epoch{0};
    Real m_now{0};
    Real m_until;
    Real m_lastContact{-1};
    Real m_stuckAt{-1};
    std::size_t m_eventsNow = 0; // at one instant
    std::size_t m_events = 0;    // since the epoch moved
    std::vector<Started> m_started;
};

} // namespace thetalane

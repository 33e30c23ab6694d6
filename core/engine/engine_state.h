// What changes while the next-event engine runs: a copy is a snapshot, from which another engine goes on to
// the very same bits.
#pragma once

#include "core/engine/floor_motion.h"
#include "core/engine/surroundings.h"

#include <cstddef>
#include <vector>

namespace thetalane {

template <class Real, class Models, class Search> class EngineState {
public:
    EngineState(const Scene& scene, double until)
        : m_until(until)
        , m_around(scene)
        , m_search(scene)
        , m_floor(scene) {}

protected:
    // A stretch of motion that began before times were last shifted, which may have cost its start a bit.
    struct Started {
        Real since;
        double absolute; // s
    };

    Real m_epoch{0};
    Real m_now{0};
    Real m_until;
    std::size_t m_events = 0;
    Surroundings<Real, Models> m_around;
    Search m_search;
    FloorMotion<Real> m_floor;
    Real m_lastContact{-1};
    Real m_stuckAt{-1};
    std::size_t m_eventsNow = 0;    // at one instant, on a floor with friction
    std::vector<Started> m_started; // of each body
};

} // namespace thetalane

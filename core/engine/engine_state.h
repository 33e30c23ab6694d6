// What changes while the next-event engine runs: a copy is a snapshot, from which another engine goes on to
// the very same bits.
#pragma once

#include "core/engine/floor_motion.h"
#include "core/engine/run_clock.h"
#include "core/engine/surroundings.h"

namespace thetalane {

template <class Real, class Models, class Search> class EngineState {
public:
    EngineState(const Scene& scene, double until)
        : m_clock(until)
        , m_around(scene)
        , m_search(scene)
        , m_floor(scene) {}

protected:
    RunClock<Real> m_clock;
    Surroundings<Real, Models> m_around;
    Search m_search;
    FloorMotion<Real> m_floor;
};

} // namespace thetalane

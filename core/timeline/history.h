// Sums over all bodies as the time goes by: what a diagram over time draws. Every state is looked up in the
// timeline; nothing is computed again but the sums.
#pragma once

#include "core/timeline/timeline.h"

namespace thetalane {

// Of all bodies together. mass [kg], position [m], velocity [m/s].
struct CentreOfMass {
    double mass = 0;
    Vec2d position;
    Vec2d velocity;
};
CentreOfMass centreOfMass(const Scene& scene, std::span<const BodyState> states);

struct SummedMoment {
    double time = 0; // [s]
    Totals totals;
    CentreOfMass centre;
};

struct History {
    std::vector<SummedMoment> moments; // ascending in time
    bool everyEvent = true;            // each event is there twice, just before it and just after
};

// From `from` to `to`, of at most `most` moments. Where the events of the bodies are more than that, evenly
// spaced moments stand for them; between few events there are more moments where the floor has friction.
History history(const Scene& scene, const Timeline& timeline, double from, double to, std::size_t most);

} // namespace thetalane

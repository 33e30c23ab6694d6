// What a run did to energy, momentum and the discs themselves, judged from the states it went through.
#pragma once

#include "core/timeline/timeline.h"

#include <limits>
#include <optional>

namespace thetalane::benchmarks {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Verdict {
    double energyDrift = unknown;   // (E - E*)/E at the start; E* by 113 bits, or what e = 1 keeps
    double momentumDrift = unknown; // |ΔP|/Σ|p|, where no wall takes part
    double overlap = 0;             // the deepest, of the pair's mean diameter, or of a body's and a wall
    double speedError = unknown;    // rms over all bodies but the first, against the reference [m/s]
};

// The truth about a scene: its energy in the end, and its state at one moment on the way.
struct Reference {
    double energy = unknown;
    double moment = unknown;
    std::vector<BodyState> states;
};

class Judge {
public:
    Judge(const Scene& scene, Reference reference);

    double moment() const { return m_reference.moment; }

    // The states in the order of time; whoever goes by steps is compared at the first one at or past the
    // moment.
    void see(double t, std::span<const BodyState> states);
    void touched(const Collision& collision); // exactly as they met
    Verdict verdict() const { return m_verdict; }

private:
    const Scene& m_scene;
    Reference m_reference;
    Totals m_start;
    Verdict m_verdict;
    bool m_compared = false;
};

// The energy of an elastic scene stays.
Reference elasticReference(const Scene& scene);
// By the engine with 113 bits; the moment is `after` the first collision.
Reference quadReference(const Scene& scene, double until, double after);

std::vector<BodyState> startOf(const Scene& scene);

} // namespace thetalane::benchmarks

// Who takes part in a comparison: our engines and other people's libraries, each able to play a scene.
#pragma once

#include "core/engine/engine.h"
#include "tests/benchmarks/judge.h"
#include "tests/benchmarks/worlds.h"

#include <functional>

namespace thetalane::benchmarks {

struct Entry {
    std::string name;
    // The whole run, its set-up included.
    std::function<void(const Scene&)> play;
    // The processor time of the run without its start [s].
    std::function<double(const Scene&)> ongoing;
    // Once more, untimed, to be judged.
    std::function<void(const Scene&, Judge&)> replay;
};

EngineSettings eventSettings(double until, bool keepDetail = true, Precision precision = Precision::Double);
EngineSettings steppedSettings(double until, int stepsPerSecond);

// Also whatever an engine refuses to do ends the program: it is the benchmark's mistake.
Timeline mustRun(const Scene& scene, const EngineSettings& settings);
bool accepts(const Scene& scene, const EngineSettings& settings);

Entry eventEntry(std::string name, const EngineSettings& settings);
Entry steppedEntry(double until, int stepsPerSecond); // the paper's loop
Entry worldEntry(const WorldKind& kind, double until, int stepsPerSecond);

} // namespace thetalane::benchmarks

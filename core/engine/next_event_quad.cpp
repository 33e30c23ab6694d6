#include "core/engine/all_pairs.h"
#include "core/engine/engine_in_steps.h"
#include "core/engine/next_event_engine.h"
#include "core/math/quad.h"

namespace thetalane {

// The reference runs where time matters little: two builds with every model are enough.
Timeline runNextEventQuad(const Scene& scene, const EngineSettings& settings) {
    if (requirementsOf(scene).friction)
        return NextEventEngine<Quad, Models<true, true, true>, AllPairs>(scene, settings).run();
    return NextEventEngine<Quad, Models<true, true, false>, AllPairs>(scene, settings).run();
}

std::unique_ptr<EngineInSteps> startNextEventQuad(const Scene& scene, const EngineSettings& settings) {
    if (requirementsOf(scene).friction)
        return std::make_unique<NextEventInSteps<NextEventEngine<Quad, Models<true, true, true>, AllPairs>>>(
            scene, settings);
    return std::make_unique<NextEventInSteps<NextEventEngine<Quad, Models<true, true, false>, AllPairs>>>(
        scene, settings);
}

} // namespace thetalane

#include "core/engine/all_pairs.h"
#include "core/engine/engines.h"
#include "core/engine/next_event_engine.h"
#include "core/math/quad.h"

namespace thetalane {

// The reference runs where time does not matter: one build with every model is enough.
Timeline runNextEventQuad(const Scene& scene, const EngineSettings& settings) {
    return NextEventEngine<Quad, true, true, AllPairs>(scene, settings).run();
}

} // namespace thetalane

#include "core/engine/all_pairs.h"
#include "core/engine/cells.h"
#include "core/engine/engines.h"
#include "core/engine/next_event_engine.h"
#include "core/math/quad.h"

namespace thetalane {

// The reference runs where time does not matter: one build with every model is enough.
Timeline runNextEventQuad(const Scene& scene, const EngineSettings& settings, SearchKind search) {
    if (search == SearchKind::Cells)
        return NextEventEngine<Quad, true, true, Cells>(scene, settings).run();
    return NextEventEngine<Quad, true, true, AllPairs>(scene, settings).run();
}

} // namespace thetalane

#include "core/engine/engines.h"
#include "core/engine/models.h"
#include "core/engine/swept_engine.h"
#include "core/math/quad.h"

namespace thetalane {

// Where time matters little: two builds with every model are enough.
Timeline runSweptQuad(const Scene& scene, const EngineSettings& settings) {
    if (requirementsOf(scene).friction)
        return SweptEngine<Quad, Models<true, true, true>>(scene, settings).run();
    return SweptEngine<Quad, Models<true, true, false>>(scene, settings).run();
}

} // namespace thetalane

#include "core/engine/engines.h"
#include "core/engine/next_event_engine.h"

namespace thetalane {
namespace {

template <class Real> Timeline runWithModels(const Scene& scene, const EngineSettings& settings) {
    const Requirements needs = requirementsOf(scene);
    if (needs.frame && needs.lane)
        return NextEventEngine<Real, true, true>(scene, settings).run();
    if (needs.frame)
        return NextEventEngine<Real, true, false>(scene, settings).run();
    if (needs.lane)
        return NextEventEngine<Real, false, true>(scene, settings).run();
    return NextEventEngine<Real, false, false>(scene, settings).run();
}

} // namespace

Timeline runNextEvent(const Scene& scene, const EngineSettings& settings) {
    switch (settings.precision) {
    case Precision::Float:
        return runWithModels<float>(scene, settings);
    case Precision::Double:
        return runWithModels<double>(scene, settings);
    case Precision::Quad:
        break;
    }
    return runNextEventQuad(scene, settings);
}

} // namespace thetalane

#include "core/engine/engines.h"
#include "core/engine/models.h"
#include "core/engine/swept_engine.h"

namespace thetalane {
namespace {

// A scene pays only for what it has.
template <class Real> Timeline run(const Scene& scene, const EngineSettings& settings) {
    const Requirements needs = requirementsOf(scene);
    if (needs.friction && needs.frame)
        return SweptEngine<Real, Models<true, true, true>>(scene, settings).run();
    if (needs.friction)
        return SweptEngine<Real, Models<false, true, true>>(scene, settings).run();
    if (needs.frame && needs.lane)
        return SweptEngine<Real, Models<true, true, false>>(scene, settings).run();
    if (needs.frame)
        return SweptEngine<Real, Models<true, false, false>>(scene, settings).run();
    if (needs.lane)
        return SweptEngine<Real, Models<false, true, false>>(scene, settings).run();
    return SweptEngine<Real, Models<false, false, false>>(scene, settings).run();
}

} // namespace

Timeline runSwept(const Scene& scene, const EngineSettings& settings) {
    switch (settings.precision) {
    case Precision::Float:
        return run<float>(scene, settings);
    case Precision::Double:
        return run<double>(scene, settings);
    case Precision::Quad:
        break;
    }
    return runSweptQuad(scene, settings);
}

} // namespace thetalane

#include "core/engine/all_pairs.h"
#include "core/engine/cells.h"
#include "core/engine/engines.h"
#include "core/engine/next_event_engine.h"

namespace thetalane {
namespace {

constexpr std::size_t fewestForCells = 64;

template <class Real, template <class> class Search>
Timeline runWithModels(const Scene& scene, const EngineSettings& settings) {
    const Requirements needs = requirementsOf(scene);
    if (needs.frame && needs.lane)
        return NextEventEngine<Real, true, true, Search>(scene, settings).run();
    if (needs.frame)
        return NextEventEngine<Real, true, false, Search>(scene, settings).run();
    if (needs.lane)
        return NextEventEngine<Real, false, true, Search>(scene, settings).run();
    return NextEventEngine<Real, false, false, Search>(scene, settings).run();
}

template <class Real>
Timeline runWithSearch(const Scene& scene, const EngineSettings& settings, SearchKind search) {
    return search == SearchKind::Cells ? runWithModels<Real, Cells>(scene, settings)
                                       : runWithModels<Real, AllPairs>(scene, settings);
}

} // namespace

Timeline runNextEvent(const Scene& scene, const EngineSettings& settings, SearchKind search) {
    if (search == SearchKind::ByCount)
        search = scene.bodies.size() < fewestForCells ? SearchKind::AllPairs : SearchKind::Cells;
    switch (settings.precision) {
    case Precision::Float:
        return runWithSearch<float>(scene, settings, search);
    case Precision::Double:
        return runWithSearch<double>(scene, settings, search);
    case Precision::Quad:
        break;
    }
    return runNextEventQuad(scene, settings);
}

} // namespace thetalane

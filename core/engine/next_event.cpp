#include "core/engine/all_pairs.h"
#include "core/engine/cells.h"
#include "core/engine/engines.h"
#include "core/engine/next_event_engine.h"

namespace thetalane {
namespace {

// From how many bodies on the cells are cheaper. thetalane_crowd_bench, ns a collision in a gas of packing
// 0.4 (g++ 12 -O3, a busy 2.5 GHz Xeon, the least of 7 in turn), all pairs : cells:
//     8 bodies 389 : 457,  12: 533 : 503,  16: 651 : 520,  20: 764 : 536,  32: 1108 : 577,  100: 2878 : 637.
// Above the tie, as there are scenes where less happens than in a gas; a rack and its ball stay with all
// pairs.
constexpr std::size_t fewestForCells = 20;

template <class Real, template <class, bool> class Search>
Timeline runWithModels(const Scene& scene, const EngineSettings& settings) {
    const Requirements needs = requirementsOf(scene);
    if (needs.frame && needs.lane)
        return NextEventEngine<Real, Models<true, true, false>, Search>(scene, settings).run();
    if (needs.frame)
        return NextEventEngine<Real, Models<true, false, false>, Search>(scene, settings).run();
    if (needs.lane)
        return NextEventEngine<Real, Models<false, true, false>, Search>(scene, settings).run();
    return NextEventEngine<Real, Models<false, false, false>, Search>(scene, settings).run();
}

template <class Real> Timeline runOnFloor(const Scene& scene, const EngineSettings& settings) {
    const Requirements needs = requirementsOf(scene);
    if (needs.frame)
        return NextEventEngine<Real, Models<true, true, true>, AllPairs>(scene, settings).run();
    return NextEventEngine<Real, Models<false, true, true>, AllPairs>(scene, settings).run();
}

template <class Real>
Timeline runWithSearch(const Scene& scene, const EngineSettings& settings, SearchKind search) {
    if (requirementsOf(scene).friction)
        return runOnFloor<Real>(scene, settings);
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

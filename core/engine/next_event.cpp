#include "core/engine/all_pairs.h"
#include "core/engine/cells.h"
#include "core/engine/engine_in_steps.h"
#include "core/engine/engines.h"
#include "core/engine/few_pairs.h"
#include "core/engine/next_event_engine.h"

namespace thetalane {
namespace {

// Up to how many bodies columns are cheaper than cells. thetalane_bench --only search, ns a collision in a gas
// of packing 0.4 (g++ 12 -O3, a 2.5 GHz Xeon, the least of 9 in turn), few : cells:
//     4 bodies 170 : 345,  8: 234 : 427,  16: 319 : 453,  24: 394 : 482,  28: 429 : 473,  32: 463 : 487.
constexpr std::size_t mostWithoutCells = FewPairs<double, false>::most;

// `use` is called with the engine type that the scene needs.
template <class Real, template <class, bool> class Search, class Use>
auto withModels(const Scene& scene, Use&& use) {
    const Requirements needs = requirementsOf(scene);
    if (needs.frame && needs.lane)
        return use.template operator()<NextEventEngine<Real, Models<true, true, false>, Search>>();
    if (needs.frame)
        return use.template operator()<NextEventEngine<Real, Models<true, false, false>, Search>>();
    if (needs.lane)
        return use.template operator()<NextEventEngine<Real, Models<false, true, false>, Search>>();
    return use.template operator()<NextEventEngine<Real, Models<false, false, false>, Search>>();
}

template <class Real, class Use> auto onFloor(const Scene& scene, Use&& use) {
    if (requirementsOf(scene).frame)
        return use.template operator()<NextEventEngine<Real, Models<true, true, true>, AllPairs>>();
    return use.template operator()<NextEventEngine<Real, Models<false, true, true>, AllPairs>>();
}

template <class Real, class Use> auto withSearch(const Scene& scene, SearchKind search, Use&& use) {
    if (requirementsOf(scene).friction)
        return onFloor<Real>(scene, use);
    if (search == SearchKind::ByCount)
        search = scene.bodies.size() <= mostWithoutCells ? SearchKind::Few : SearchKind::Cells;
    if (search == SearchKind::Few)
        return withModels<Real, FewPairs>(scene, use);
    if (search == SearchKind::Cells)
        return withModels<Real, Cells>(scene, use);
    return use
        .template operator()<NextEventEngine<Real, Models<true, true, false>, AllPairs>>(); // to compare with
}

} // namespace

Timeline runNextEvent(const Scene& scene, const EngineSettings& settings, SearchKind search) {
    const auto run = [&]<class Engine>() { return Engine(scene, settings).run(); };
    switch (settings.precision) {
    case Precision::Float:
        return withSearch<float>(scene, search, run);
    case Precision::Double:
        return withSearch<double>(scene, search, run);
    case Precision::Quad:
        break;
    }
    return runNextEventQuad(scene, settings);
}

std::unique_ptr<EngineInSteps> startNextEvent(const Scene& scene, const EngineSettings& settings,
                                              SearchKind search) {
    const auto start = [&]<class Engine>() -> std::unique_ptr<EngineInSteps> {
        return std::make_unique<NextEventInSteps<Engine>>(scene, settings);
    };
    switch (settings.precision) {
    case Precision::Float:
        return withSearch<float>(scene, search, start);
    case Precision::Double:
        return withSearch<double>(scene, search, start);
    case Precision::Quad:
        break;
    }
    return startNextEventQuad(scene, settings);
}

} // namespace thetalane

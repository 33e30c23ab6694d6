// thetalane_crowd_bench [--quick]: what a collision costs in a gas of discs (packing 0.4, walls, e = 1,
// summary only) by either search, and what it does to energy, momentum and overlap. Both searches in turn,
// the least of the repetitions: a busy machine slows both alike. Processor time, not the clock's.
#include "core/engine/engines.h"
#include "core/scene/crowd_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <numeric>
#include <vector>

using namespace thetalane;

namespace {

double processorTime() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

struct Cost {
    double start = 1e300; // until the first collision, its part of the run [s]
    double run = 1e300;   // all collisions [s]
    Timeline timeline;

    double ofOne(std::int64_t collisions) const { return run / double(collisions) * 1e9; }
    double ofOneLater(std::int64_t collisions) const { return (run - start) / double(collisions) * 1e9; }
};

void measure(const Scene& scene, std::int64_t collisions, SearchKind search, Cost& cost) {
    EngineSettings settings;
    settings.until = 1e9;
    settings.keepDetail = false;
    const double begin = processorTime();
    settings.maxCollisions = 1;
    runNextEvent(scene, settings, search);
    const double started = processorTime();
    settings.maxCollisions = collisions;
    cost.timeline = runNextEvent(scene, settings, search);
    cost.start = std::min(cost.start, started - begin);
    cost.run = std::min(cost.run, processorTime() - started);
}

// Of a diameter: along x, as only neighbours can overlap.
double deepestOverlap(const Scene& scene, const std::vector<BodyState>& states) {
    const double diameter = 2 * scene.bodies[0].radius;
    std::vector<std::size_t> order(states.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](auto i, auto j) { return states[i].position.x < states[j].position.x; });
    double depth = 0;
    for (std::size_t a = 0; a < order.size(); ++a)
        for (std::size_t b = a + 1; b < order.size(); ++b) {
            const Vec2d between = states[order[b]].position - states[order[a]].position;
            if (between.x > diameter)
                break;
            depth = std::max(depth, 1 - norm(between) / diameter);
        }
    return depth;
}

// From how many bodies on the cells are cheaper, also for a short run of ten collisions a body.
void compareSearches(bool quick) {
    std::puts("| bodies | all pairs, ns a collision | cells | short run: all pairs | cells |");
    std::puts("|---:|---:|---:|---:|---:|");
    for (const int count : {4, 8, 12, 16, 20, 24, 28, 32, 40, 48, 64, 100, 200}) {
        const Scene scene = gasScene(count);
        const std::int64_t many = quick ? 100 : 10'000, few = 10 * count;
        Cost pairs, cells, pairsShort, cellsShort;
        for (int r = 0; r < (quick ? 1 : 7); ++r) {
            measure(scene, many, SearchKind::AllPairs, pairs);
            measure(scene, many, SearchKind::Cells, cells);
            measure(scene, few, SearchKind::AllPairs, pairsShort);
            measure(scene, few, SearchKind::Cells, cellsShort);
        }
        std::printf("| %d | %.0f | %.0f | %.0f | %.0f |\n", count, pairs.ofOne(many), cells.ofOne(many),
                    pairsShort.ofOne(few), cellsShort.ofOne(few));
    }
}

void measureGases(bool quick) {
    std::puts(
        "\n| bodies | collisions | start, ms | ns a collision | energy drift | ΔP/Σp, in pairs | overlap, "
        "diameters |");
    std::puts("|---:|---:|---:|---:|---:|---:|---:|");
    for (const int count : {100, 1000, 10'000, 100'000}) {
        if (quick && count > 1000)
            break;
        const Scene scene = gasScene(count);
        const std::int64_t collisions = quick ? 1000 : 500'000;
        Cost cost;
        for (int r = 0; r < (quick ? 1 : 5); ++r)
            measure(scene, collisions, SearchKind::Cells, cost);
        const auto end = cost.timeline.stateAt(cost.timeline.endTime());

        Scene open = scene; // without walls, which take momentum
        open.frame.reset();
        Cost free;
        measure(open, collisions, SearchKind::Cells, free);
        const Totals moved = totals(open, free.timeline.stateAt(free.timeline.endTime()));
        std::printf("| %d | %lld | %.2f | %.0f | %.1e | %.1e | %.1e |\n", count,
                    static_cast<long long>(collisions), cost.start * 1e3, cost.ofOneLater(collisions),
                    totals(scene, end).energy / (count / 2.0) - 1, norm(moved.momentum) / (0.886 * count),
                    deepestOverlap(scene, end));
    }
}

} // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    if (argc > 1 && !quick) {
        std::fputs("usage: thetalane_crowd_bench [--quick]\n", stderr);
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    compareSearches(quick);
    measureGases(quick);
    return 0;
}

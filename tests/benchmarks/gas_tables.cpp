// Gases of discs, e = 1, packing 0.4, between walls.
#include "core/engine/engines.h"
#include "core/scene/crowd_scenes.h"
#include "tests/benchmarks/contestants.h"
#include "tests/benchmarks/table.h"
#include "tests/benchmarks/tables.h"
#include "tests/benchmarks/timing.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace thetalane::benchmarks {
namespace {

// How long each is watched, so that there are enough collisions; whole steps of 1/60 s.
struct Gas {
    int count;
    int sixtieths;
    double until() const { return sixtieths / 60.0; }
};

std::vector<Entry> entriesFor(const Gas& gas) {
    const double until = gas.until();
    std::vector<Entry> entries{eventEntry("event, summary only", eventSettings(until, false)),
                               eventEntry("event", eventSettings(until))};
    const std::vector<int> rates =
        gas.count <= 1000 ? std::vector<int>{60, 240, 1000} : std::vector<int>{60, 240};
    for (const int rate : rates)
        if (gas.count <= 10'000) // the paper's loop compares all pairs
            entries.push_back(steppedEntry(until, rate));
    for (const WorldKind& kind : worlds())
        for (const int rate : rates)
            if (std::size_t(gas.count) <= kind.mostBodies)
                entries.push_back(worldEntry(kind, until, rate));
    return entries;
}

void gasTable(const Gas& gas, bool quick) {
    const Scene scene = gasScene(gas.count);
    const std::vector<Entry> entries = entriesFor(gas);
    std::vector<Contestant> contestants;
    for (const Entry& e : entries)
        contestants.push_back({e.name, [&scene, &e] { return e.ongoing(scene); }});
    takeTurns(contestants, quick ? 1 : gas.count <= 1000 ? 11 : gas.count <= 10'000 ? 5 : 3);

    const double collisions = double(mustRun(scene, eventSettings(gas.until(), false)).collisionCount());
    EngineSettings first = eventSettings(gas.until(), false);
    first.maxCollisions = 1;
    double start = std::numeric_limits<double>::infinity();
    for (int r = 0; r < 5; ++r)
        start = std::min(start, timed([&] { mustRun(scene, first); }));
    Table table("**A gas of " + whole(gas.count) +
                    " discs**, e = 1, packing 0.4, walls: processor time of a " + "simulated second, from " +
                    whole(gas.sixtieths) + "/60 s with " + whole(collisions) +
                    " collisions; set-up not included (event: " + seconds(start) + ").",
                {"a simulated second", "least", "median", "spread", "ratio", "median of a collision",
                 "least of a collision", "energy drift", "overlap"});
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const Contestant& c = contestants[k];
        Judge judge(scene, elasticReference(scene));
        entries[k].replay(scene, judge);
        const Verdict v = judge.verdict();
        table.row({c.name, seconds(c.least() / gas.until()), seconds(c.median() / gas.until()),
                   percent(c.spread()), times(c.median() / contestants[0].median()),
                   seconds(c.median() / collisions), seconds(c.least() / collisions), tiny(v.energyDrift),
                   tiny(v.overlap)});
    }
    for (const WorldKind& kind : worlds())
        if (std::size_t(gas.count) > kind.mostBodies)
            std::printf("\n%s is left out: a step takes seconds.\n", kind.name.c_str());
}

// What a collision costs by one search: over many, and over a short run of ten a body, start included.
std::vector<Contestant> searchContestants(const Scene& scene, std::int64_t many, std::int64_t few) {
    std::vector<Contestant> contestants;
    for (const std::int64_t collisions : {many, few})
        for (const SearchKind search : {SearchKind::Few, SearchKind::Cells}) {
            EngineSettings settings = eventSettings(1e9, false);
            settings.maxCollisions = collisions;
            contestants.push_back({"", [&scene, settings, search, collisions] {
                                       return timed([&] { runNextEvent(scene, settings, search); }) /
                                              double(collisions);
                                   }});
        }
    return contestants;
}

} // namespace

void gasTables(bool quick) {
    const std::vector<Gas> gases = quick
                                       ? std::vector<Gas>{{100, 6}, {1000, 2}}
                                       : std::vector<Gas>{{100, 120}, {1000, 24}, {10'000, 6}, {100'000, 2}};
    for (const Gas& gas : gases)
        gasTable(gas, quick);
}

void searchTable(bool quick) {
    Table table(
        "**Few or cells**: all pairs in fixed columns, or a grid; least and median of a collision in a gas "
        "(packing 0.4), summary only.",
        {"bodies", "few", "cells", "ratio", "ten collisions a body: few", "cells", "ratio"});
    for (const int count : {4, 8, 12, 16, 20, 24, 28, 32}) {
        const Scene scene = gasScene(count);
        auto contestants = searchContestants(scene, quick ? 100 : 10'000, 10 * count);
        takeTurns(contestants, quick ? 1 : 9);
        std::vector<std::string> cells{std::to_string(count)};
        for (const std::size_t k : {0u, 2u}) {
            for (const Contestant* c : {&contestants[k], &contestants[k + 1]})
                cells.push_back(seconds(c->least()) + " · " + seconds(c->median()));
            cells.push_back(times(contestants[k + 1].median() / contestants[k].median()));
        }
        table.row(cells);
    }
}

} // namespace thetalane::benchmarks

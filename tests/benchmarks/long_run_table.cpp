// Ten minutes of a gas of 1,000 in bounded memory: what they cost, how large the process gets, and how long
// any earlier moment takes that is computed again.
#include "core/engine/long_run.h"
#include "core/scene/crowd_scenes.h"
#include "tests/benchmarks/table.h"
#include "tests/benchmarks/tables.h"
#include "tests/benchmarks/timing.h"

#include <sys/resource.h>

#include <algorithm>
#include <random>
#include <vector>

namespace thetalane::benchmarks {
namespace {

double peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

void longRunRow(Table& table, int count, double until, int moments) {
    EngineSettings settings;
    settings.until = until;
    settings.maxCollisions = std::int64_t(1) << 60;
    LongRun run(gasScene(count), settings);
    const double taken = timed([&] { run.computeTo(until); });
    std::mt19937_64 random(1);
    std::vector<double> waits;
    for (int k = 0; k < moments; ++k) {
        const double t = until * double(random() >> 11) * 0x1p-53;
        waits.push_back(timed([&] { sink = run.chapterAt(t)->timeline.bodyAt(0, t).position.x; }));
    }
    std::sort(waits.begin(), waits.end());
    const double happened = double(run.collisionCount());
    table.row({"gas of " + whole(count), whole(until) + " s", whole(happened), times(taken) + " s",
               seconds(taken / happened), whole(double(run.snapshotCount())),
               seconds(waits[waits.size() / 2]), seconds(waits.back()), whole(peakMegabytes()) + " MB"});
}

} // namespace

void longRunTable(bool quick) {
    Table table("**A long run in chapters**: computed once, then moments at random. Peak: of the whole "
                "process so far.",
                {"scene", "simulated", "collisions", "computed in", "a collision", "snapshots",
                 "a moment, median", "a moment, worst", "peak"});
    longRunRow(table, 1000, quick ? 1 : 600, quick ? 5 : 300);
}

} // namespace thetalane::benchmarks

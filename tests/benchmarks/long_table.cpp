// Ten million elastic collisions: what rounding has done by then. Walls take momentum, and in the open any
// number of discs has only finitely many collisions; so momentum is watched in a crowd so large that it comes
// to ten million before it has dispersed.
#include "core/scene/crowd_scenes.h"
#include "tests/benchmarks/contestants.h"
#include "tests/benchmarks/table.h"
#include "tests/benchmarks/tables.h"
#include "tests/benchmarks/timing.h"

namespace thetalane::benchmarks {
namespace {

Scene openCrowd(int count) {
    Scene scene = gasScene(count);
    scene.frame.reset();
    for (Body& b : scene.bodies) // inwards at first
        b.velocity = b.velocity - 2.0 * b.position;
    return scene;
}

void longRow(Table& table, const std::string& name, const Scene& scene, std::int64_t collisions) {
    EngineSettings settings = eventSettings(1e9, false);
    settings.maxCollisions = collisions;
    Timeline timeline;
    const double taken = timed([&] { timeline = mustRun(scene, settings); });
    Judge judge(scene, elasticReference(scene));
    judge.see(timeline.endTime(), timeline.stateAt(timeline.endTime()));
    const Verdict v = judge.verdict();
    const double happened = double(timeline.collisionCount());
    table.row({name, whole(happened), times(timeline.endTime()) + " s", seconds(taken / happened),
               tiny(v.energyDrift), tiny(v.momentumDrift), tiny(v.overlap)});
}

} // namespace

void longTable(bool quick) {
    Table table("**Long runs**, event, summary only, e = 1. Overlap: of all neighbours in the end.",
                {"scene", "collisions", "simulated", "a collision", "energy drift",
                 "&#124;ΔP&#124;/Σ&#124;p&#124;", "overlap"});
    const std::int64_t most = quick ? 10'000 : 10'000'000;
    for (std::int64_t collisions = most / 1000; collisions <= most; collisions *= 10)
        longRow(table, "gas of 1,000, walls", gasScene(1000), collisions);
    const int crowd = quick ? 1000 : 100'000;
    longRow(table, "open crowd of " + whole(crowd), openCrowd(crowd), most);
}

} // namespace thetalane::benchmarks

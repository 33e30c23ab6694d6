// The rack, the lane, eleven discs in a box: cost and faithfulness of each way to play them.
#include "core/scene/bowling_scene.h"
#include "tests/benchmarks/box_scene.h"
#include "tests/benchmarks/contestants.h"
#include "tests/benchmarks/table.h"
#include "tests/benchmarks/tables.h"
#include "tests/benchmarks/timing.h"

#include <cstdio>

namespace thetalane::benchmarks {
namespace {

struct Comparison {
    Scene (*make)();
    double until = 1;
    std::vector<Entry> entries{};
    // The same scene with other parameters, where the speeds are compared, too.
    Scene (*variant)() = nullptr;
};

Scene rack() {
    return rackScene(0.0676, 0, 6.8);
}
Scene rackAt07() {
    return rackScene(0.0676, 0, 6.8, 0.7);
}
Scene lane() {
    return bowlingScene(Throw{});
}

void addOurs(Comparison& c) {
    c.entries.push_back(eventEntry("event", eventSettings(c.until)));
    c.entries.push_back(eventEntry("event, summary only", eventSettings(c.until, false)));
    c.entries.push_back(eventEntry("event, float", eventSettings(c.until, true, Precision::Float)));
    c.entries.push_back(eventEntry("event, 113 bits", eventSettings(c.until, true, Precision::Quad)));
    for (const int rate : {60, 240, 1000})
        if (accepts(c.make(), steppedSettings(c.until, rate)))
            c.entries.push_back(steppedEntry(c.until, rate));
}

void addWorlds(Comparison& c) {
    for (const WorldKind& kind : worlds())
        for (const int rate : {60, 240, 1000})
            c.entries.push_back(worldEntry(kind, c.until, rate));
}

std::vector<Contestant> measured(const Comparison& c, bool quick) {
    std::vector<Contestant> contestants;
    for (const Entry& e : c.entries)
        contestants.push_back(repeated(
            e.name, [make = c.make, play = e.play] { play(make()); }, quick ? 0 : 0.002));
    contestants.push_back(repeated(
        "the scene alone, made", [make = c.make] { sink = sink + double(make().bodies.size()); },
        quick ? 0 : 0.002));
    takeTurns(contestants, quick ? 1 : 31);
    return contestants;
}

Verdict verdictOf(const Entry& entry, const Scene& scene, const Reference& reference) {
    Judge judge(scene, reference);
    entry.replay(scene, judge);
    return judge.verdict();
}

std::vector<std::string> costs(const Contestant& c, double first) {
    return {c.name, seconds(c.least()), seconds(c.median()), percent(c.spread()), times(c.median() / first)};
}

// With the speeds 0.1 s after the impact, of the scene and of its variant.
void printRack(const Comparison& c, const std::vector<Contestant>& contestants) {
    Table table(
        "**The rack throw**, frictionless, e = 0.75, ball and ten pins to 1 s; set-up included. Speeds: "
        "rms error of the pins' velocities 0.1 s after impact [m/s].",
        {"a throw", "least", "median", "spread", "ratio", "energy drift", "overlap",
         "&#124;ΔP&#124;/Σ&#124;p&#124;", "speeds", "speeds, e = 0.7"});
    const Scene scene = c.make(), variant = c.variant();
    const Reference truth = quadReference(scene, c.until, 0.1), other = quadReference(variant, c.until, 0.1);
    for (std::size_t k = 0; k < contestants.size(); ++k) {
        auto cells = costs(contestants[k], contestants[0].median());
        if (k < c.entries.size()) {
            const Verdict v = verdictOf(c.entries[k], scene, truth);
            for (const double x : {v.energyDrift, v.overlap, v.momentumDrift, v.speedError,
                                   verdictOf(c.entries[k], variant, other).speedError})
                cells.push_back(tiny(x));
        } else {
            cells.resize(cells.size() + 5, "–");
        }
        table.row(cells);
    }
}

void printScene(const std::string& title, const Comparison& c, const std::vector<Contestant>& contestants,
                const Reference& reference) {
    Table table(title, {"a run", "least", "median", "spread", "ratio", "energy drift", "overlap"});
    const Scene scene = c.make();
    for (std::size_t k = 0; k < contestants.size(); ++k) {
        auto cells = costs(contestants[k], contestants[0].median());
        Verdict v{unknown, unknown, unknown, unknown};
        if (k < c.entries.size())
            v = verdictOf(c.entries[k], scene, reference);
        cells.push_back(tiny(v.energyDrift));
        cells.push_back(tiny(v.overlap));
        table.row(cells);
    }
}

} // namespace

void rackTable(bool quick) {
    Comparison c{rack, 1, {}, rackAt07};
    addOurs(c);
    addWorlds(c);
    printRack(c, measured(c, quick));
}

// The libraries know no lane: they get the bodies alone, which cross its edges and fly on.
void laneTable(bool quick) {
    Comparison c{lane, quick ? 3.0 : 10.0};
    addOurs(c);
    const std::vector<Contestant> ours = measured(c, quick);
    const Scene scene = lane();
    printScene("**The whole-lane throw** to 10 s, set-up included. The libraries are left out: they know no "
               "gutter, no pit" +
                   std::string(scene.friction ? ", no floor with friction." : "."),
               c, ours, quadReference(scene, c.until, 0.1));
}

void elevenTable(bool quick) {
    Comparison c{elevenInABox, quick ? 0.5 : 10.0};
    addOurs(c);
    addWorlds(c);
    const std::vector<Contestant> contestants = measured(c, quick);
    const double events = double(mustRun(elevenInABox(), eventSettings(c.until)).collisionCount());
    printScene("**Eleven discs in a box**, e = 1, " + times(c.until) + " s, " + whole(events) +
                   " collisions; set-up included.",
               c, contestants, elasticReference(elevenInABox()));
    std::printf(
        "\nA collision: event %s (least %s), summary only %s (least %s).\n",
        seconds(contestants[0].median() / events).c_str(), seconds(contestants[0].least() / events).c_str(),
        seconds(contestants[1].median() / events).c_str(), seconds(contestants[1].least() / events).c_str());
}

} // namespace thetalane::benchmarks

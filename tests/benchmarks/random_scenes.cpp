// Runs random scenes (2 to 12 bodies, every e, with and without friction, with and without walls) and looks
// for what must not be: overlap beyond rounding, energy from nowhere, a pull, a NaN, a run that does not end
// or takes events without number.
// Says what it saw; 1 if any.
#include "tests/benchmarks/scene_tally.h"
#include "tests/core/floor_scenes.h"

#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>

using namespace thetalane;
using namespace thetalane::testing;
using bench::SceneTally;

namespace {

constexpr const char* usage =
    "usage: thetalane_random_scenes [COUNT [FIRST]] [--only floor|plain] [--slowest K] [--progress] [--csv]\n"
    "       thetalane_random_scenes --merge FILE\n"
    "  COUNT scenes from number FIRST on (1000 from 0); --only those with friction, or those without.\n"
    "  --slowest K    name the K that took longest (5)\n"
    "  --progress     say on stderr how far it is\n"
    "  --csv          end with one line for --merge, which reads such lines and says what they are "
    "together\n";

struct Options {
    SceneTally tally;
    std::string merge;
    bool progress = false, csv = false;
};

std::optional<Options> readOptions(int argc, char** argv) {
    Options o;
    o.tally.count = 1000;
    int numbers = 0;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        const bool hasValue = k + 1 < argc;
        if (word == "--only" && hasValue)
            o.tally.kind = argv[++k];
        else if (word == "--slowest" && hasValue)
            o.tally.keepsSlowest = std::size_t(std::max(std::atoi(argv[++k]), 0));
        else if (word == "--merge" && hasValue)
            o.merge = argv[++k];
        else if (word == "--progress")
            o.progress = true;
        else if (word == "--csv")
            o.csv = true;
        else if (numbers < 2 && word.find_first_not_of("0123456789") == std::string::npos)
            (numbers++ ? o.tally.first : o.tally.count) = std::atoll(word.c_str());
        else
            return std::nullopt;
    }
    const std::string& kind = o.tally.kind;
    return o.tally.count > 0 && (kind == "all" || kind == "floor" || kind == "plain") ? std::optional(o)
                                                                                      : std::nullopt;
}

constexpr std::size_t mostSegments = 200'000; // a few tens of thousands is the most seen

bool hasFloor(std::int64_t number) {
    return number % 4 >= 2;
}

Scene sceneNumber(std::int64_t number) {
    Random random(std::uint32_t(number * 2654435761u + 12345u));
    const double picks[] = {0, 1, random.unit(), random.unit() * 0.1, 1 - random.unit() * 1e-3};
    const double e = picks[random.below(5)], speed = random.logUniform(0.1, 10);
    const int count = 2 + random.below(11);
    const bool walls = number % 2;
    return hasFloor(number) ? randomFloorScene(random, count, e, walls, speed)
                            : randomScene(random, count, e, walls, speed);
}

void look(std::int64_t number, SceneTally& tally) {
    const std::clock_t began = std::clock();
    const Scene scene = sceneNumber(number);
    EngineSettings settings = eventSettings(scene.friction ? 20 : 3);
    settings.maxCollisions = 100'000;
    const Timeline timeline = runOf(scene, settings);
    const Health h = healthOf(scene, timeline, 200);
    bool pulls = false;
    for (const Collision& c : timeline.collisions())
        pulls = pulls || !(c.steps.impulse > 0) || !(c.steps.energyLoss >= 0);
    ++tally.scenes;
    tally.collisions += timeline.collisionCount();
    tally.lasting += std::int64_t(timeline.lastingContacts().size());
    tally.mostSegments = std::max(tally.mostSegments, std::int64_t(h.events));
    tally.deepest.see(h.deepest, number);
    tally.gained.see(h.gained, number);
    tally.notFinite += !h.finite;
    tally.notEnded += h.finite && !h.ended;
    tally.pulls += pulls;
    tally.took(double(std::clock() - began) / CLOCKS_PER_SEC, number);
    const bool chatters = h.events > mostSegments;
    if (h.ended && !chatters && !pulls && h.deepest < 1e-12 && h.gained < 1e-12)
        return;
    ++tally.faults;
    std::printf(
        "scene %lld: e %g, %zu bodies, friction %d, walls %d: %s%s%s overlap %.1e m, energy gained %.1e\n",
        static_cast<long long>(number), scene.restitution, scene.bodies.size(),
        int(scene.friction.has_value()), int(scene.frame.has_value()), h.ended ? "" : "did not end;",
        chatters ? " events without number;" : "", pulls ? " a pull;" : "", h.deepest, h.gained);
    std::fflush(stdout);
}

void run(Options& o) {
    SceneTally& tally = o.tally;
    for (std::int64_t k = tally.first; k < tally.first + tally.count; ++k) {
        if (tally.kind == "all" || hasFloor(k) == (tally.kind == "floor"))
            look(k, tally);
        if (const std::int64_t done = k + 1 - tally.first; o.progress && done % 1000 == 0)
            std::fprintf(stderr, "%lld of %lld, %.0f s\n", static_cast<long long>(done),
                         static_cast<long long>(tally.count), tally.seconds);
    }
}

bool merge(Options& o) {
    std::ifstream in(o.merge);
    o.tally.count = 0;
    for (std::string line; std::getline(in, line);)
        if (const auto part = bench::readTally(line))
            o.tally.add(*part);
    return o.tally.count > 0;
}

} // namespace

int main(int argc, char** argv) {
    auto options = readOptions(argc, argv);
    if (!options) {
        std::fputs(usage, stderr);
        return 2;
    }
    if (options->merge.empty())
        run(*options);
    else if (!merge(*options)) {
        std::fprintf(stderr, "nothing to merge in %s\n", options->merge.c_str());
        return 2;
    }
    const SceneTally& tally = options->tally;
    std::printf("%s\n", tally.text().c_str());
    if (options->csv)
        std::printf("%s\n%s\n", SceneTally::header, tally.line().c_str());
    return tally.faults == 0 ? 0 : 1;
}

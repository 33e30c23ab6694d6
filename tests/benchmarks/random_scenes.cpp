// thetalane_random_scenes [COUNT [FIRST]]: runs COUNT random scenes (2 to 12 bodies, every e, with and
// without friction, with and without walls) from number FIRST on, and looks for what must not be: overlap
// beyond rounding, energy from nowhere, a pull, a NaN, a run that does not end. Says what it saw; 1 if any.
#include "tests/core/floor_scenes.h"

#include <cstdio>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Tally {
    std::int64_t scenes = 0, collisions = 0, lasting = 0, faults = 0;
    std::size_t mostSegments = 0;
    double deepest = 0, gained = 0;
};

Scene sceneNumber(std::int64_t number) {
    Random random(std::uint32_t(number * 2654435761u + 12345u));
    const double picks[] = {0, 1, random.unit(), random.unit() * 0.1, 1 - random.unit() * 1e-3};
    const double e = picks[random.below(5)], speed = random.logUniform(0.1, 10);
    const int count = 2 + random.below(11);
    const bool walls = number % 2;
    return number % 4 < 2 ? randomScene(random, count, e, walls, speed)
                          : randomFloorScene(random, count, e, walls, speed);
}

void look(std::int64_t number, Tally& tally) {
    const Scene scene = sceneNumber(number);
    EngineSettings settings = eventSettings(scene.friction ? 20 : 3);
    settings.maxCollisions = 100'000;
    const Timeline timeline = runOf(scene, settings);
    const Health h = healthOf(scene, timeline, 50);
    bool pulls = false;
    for (const Collision& c : timeline.collisions())
        pulls = pulls || !(c.steps.impulse > 0) || !(c.steps.energyLoss >= 0);
    ++tally.scenes;
    tally.collisions += timeline.collisionCount();
    tally.lasting += std::int64_t(timeline.lastingContacts().size());
    tally.mostSegments = std::max(tally.mostSegments, h.events);
    tally.deepest = std::max(tally.deepest, h.deepest);
    tally.gained = std::max(tally.gained, h.gained);
    if (h.ended && !pulls && h.deepest < 1e-12 && h.gained < 1e-12)
        return;
    ++tally.faults;
    std::printf(
        "scene %lld: e %g, %zu bodies, friction %d, walls %d: %s%s overlap %.1e m, energy gained %.1e\n",
        static_cast<long long>(number), scene.restitution, scene.bodies.size(),
        int(scene.friction.has_value()), int(scene.frame.has_value()), h.ended ? "" : "did not end;",
        pulls ? " a pull;" : "", h.deepest, h.gained);
}

} // namespace

int main(int argc, char** argv) {
    const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 1000;
    const std::int64_t first = argc > 2 ? std::atoll(argv[2]) : 0;
    if (argc > 3 || count <= 0 || first < 0) {
        std::fputs("usage: thetalane_random_scenes [COUNT [FIRST]]\n", stderr);
        return 2;
    }
    Tally tally;
    for (std::int64_t k = first; k < first + count; ++k)
        look(k, tally);
    std::printf("%lld scenes, %lld collisions, %lld lasting contacts, at most %zu segments in one;\n"
                "deepest overlap %.1e m, most energy gained %.1e of the whole; %lld at fault\n",
                static_cast<long long>(tally.scenes), static_cast<long long>(tally.collisions),
                static_cast<long long>(tally.lasting), tally.mostSegments, tally.deepest, tally.gained,
                static_cast<long long>(tally.faults));
    return tally.faults == 0 ? 0 : 1;
}

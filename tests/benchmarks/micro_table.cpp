// The parts: one time of impact, one exchange, one look-up, one kept collision.
#include "tests/benchmarks/box_scene.h"
#include "tests/benchmarks/contestants.h"
#include "tests/benchmarks/prediction_cases.h"
#include "tests/benchmarks/table.h"
#include "tests/benchmarks/tables.h"
#include "tests/benchmarks/timing.h"

#include <cstdio>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace thetalane::benchmarks {
namespace {

Contestant ofMany(std::string name, int count, std::function<void()> work) {
    return {std::move(name), [count, work = std::move(work)] { return timed(work) / count; }};
}

Contestant prediction(const char* name, testing::ImpactCase (*make)(testing::Random&)) {
    return ofMany(name, 16 * 4096, [cases = manyCases(make)] {
        for (int k = 0; k < 16; ++k)
            sink = sink + sumOfTimes(cases);
    });
}

using Pair = std::pair<Disc<double>, Disc<double>>;

std::vector<Pair> touchingPairs() {
    testing::Random random(2);
    std::vector<Pair> pairs;
    for (int k = 0; k < 4096; ++k) {
        const Disc<double> a{random.in(1, 7), 0.1, {}, testing::direction(random)};
        const Disc<double> b{random.in(1, 7), 0.1, testing::direction(random) * 0.2, {}};
        pairs.push_back({a, b});
    }
    return pairs;
}

// Called through a pointer, or the compiler drops what nobody looks at.
PairCollision<double> (*volatile exchange)(const Disc<double>&, const Disc<double>&,
                                           const double&) = collide<double>;

Contestant exchanges() {
    return ofMany("collide(): five steps and the check", 8 * 4096, [pairs = touchingPairs()] {
        const auto call = exchange;
        double sum = 0;
        for (int k = 0; k < 8; ++k)
            for (const auto& [a, b] : pairs)
                sum += call(a, b, 0.75).after.first.x;
        sink = sink + sum;
    });
}

// `timeline` outlives it.
Contestant seeks(const Timeline& timeline) {
    return ofMany("seek at random over " + whole(double(timeline.collisionCount())) +
                      " collisions of 11 discs: all states",
                  4096, [&timeline] {
                      std::uint32_t random = 1;
                      std::vector<BodyState> states;
                      for (int k = 0; k < 4096; ++k) {
                          random = random * 1664525u + 1013904223u;
                          timeline.stateAt(timeline.endTime() * random / 4294967296.0, states);
                          sink = sink + states[0].position.x;
                      }
                  });
}

EngineSettings manyCollisions(std::int64_t count) {
    EngineSettings settings = eventSettings(1e6);
    settings.maxCollisions = count;
    return settings;
}

// What the allocator has given out.
double bytesInUse() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const auto info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
#else
    return unknown;
#endif
}

void printMemory(bool quick) {
    const std::int64_t count = quick ? 1000 : 100'000;
    const double before = bytesInUse();
    const Timeline kept = mustRun(elevenInABox(), manyCollisions(count));
    const double each = (bytesInUse() - before) / double(count);
    std::printf(
        "\nA collision kept: %s bytes, by the allocator, over %s collisions of 11 discs; of these the "
        "record of its steps %zu and each segment of motion %zu.\n",
        whole(each).c_str(), whole(double(count)).c_str(), sizeof(Collision), sizeof(Segment));
}

} // namespace

void microTable(bool quick) {
    const Timeline seekable = mustRun(elevenInABox(), manyCollisions(quick ? 1000 : 10'000));
    std::vector<Contestant> contestants{
        prediction("time of impact: free pins", freeCase),
        prediction("time of impact: pins sliding to rest", pinsCase),
        prediction("time of impact: quadratic, generic (half are aimed)", testing::genericCase), exchanges(),
        seeks(seekable)};
    takeTurns(contestants, quick ? 1 : 31);
    Table table("**Parts**", {"one", "least", "median", "spread"});
    for (const Contestant& c : contestants)
        table.row({c.name, seconds(c.least()), seconds(c.median()), percent(c.spread())});
    printMemory(quick);
    std::printf("Of pairs that never meet, bounds alone turn away: sliding pins %.1f %%, generic %.1f %%.\n",
                100 * rejectedShare(manyCases(pinsCase)),
                100 * rejectedShare(manyCases(testing::genericCase)));
}

} // namespace thetalane::benchmarks

// What was seen of many random scenes: written as one line, so that parts run one by one can be merged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace thetalane::bench {

// The worst that was seen, and where.
struct Worst {
    double value = 0;
    std::int64_t scene = -1;

    void see(double seen, std::int64_t where) {
        if (seen > value)
            *this = {seen, where};
    }
};

struct SceneTally {
    static constexpr const char* header =
        "range,kind,first,count,scenes,collisions,lasting,most_segments,not_finite,not_ended,pulls,faults,"
        "deepest_m,deepest_scene,gained,gained_scene,cpu_s,slowest";

    std::string kind = "all"; // floor: with friction; plain: without
    std::int64_t first = 0, count = 0;
    std::int64_t scenes = 0, collisions = 0, lasting = 0, mostSegments = 0;
    std::int64_t notFinite = 0, notEnded = 0, pulls = 0, faults = 0;
    Worst deepest; // overlap [m]
    Worst gained;  // energy, of what there was at the start
    double seconds = 0;
    std::size_t keepsSlowest = 5;
    std::vector<Worst> slowest; // seconds, falling

    void took(double scene_s, std::int64_t scene);
    void add(const SceneTally& part);
    std::string line() const; // as `header` says
    std::string text() const;
};

// A line() read again; nothing if it is none.
std::optional<SceneTally> readTally(const std::string& line);

} // namespace thetalane::bench

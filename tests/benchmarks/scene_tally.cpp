#include "tests/benchmarks/scene_tally.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace thetalane::bench {
namespace {

template <class... Values> std::string formatted(const char* format, Values... values) {
    char buffer[640];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

using Long = long long;

} // namespace

void SceneTally::took(double scene_s, std::int64_t scene) {
    seconds += scene_s;
    slowest.push_back({scene_s, scene});
    std::stable_sort(slowest.begin(), slowest.end(),
                     [](const Worst& a, const Worst& b) { return a.value > b.value; });
    if (slowest.size() > keepsSlowest)
        slowest.resize(keepsSlowest);
}

void SceneTally::add(const SceneTally& part) {
    count += part.count;
    scenes += part.scenes;
    collisions += part.collisions;
    lasting += part.lasting;
    mostSegments = std::max(mostSegments, part.mostSegments);
    notFinite += part.notFinite;
    notEnded += part.notEnded;
    pulls += part.pulls;
    faults += part.faults;
    deepest.see(part.deepest.value, part.deepest.scene);
    gained.see(part.gained.value, part.gained.scene);
    const double sum = seconds + part.seconds;
    for (const Worst& w : part.slowest)
        took(w.value, w.scene);
    seconds = sum;
}

std::string SceneTally::line() const {
    std::string out =
        formatted("range,%s,%lld,%lld,%lld,%lld,%lld,%lld,%lld,%lld,%lld,%lld,%.3e,%lld,%.3e,%lld,%.3f,",
                  kind.c_str(), Long(first), Long(count), Long(scenes), Long(collisions), Long(lasting),
                  Long(mostSegments), Long(notFinite), Long(notEnded), Long(pulls), Long(faults),
                  deepest.value, Long(deepest.scene), gained.value, Long(gained.scene), seconds);
    for (const Worst& w : slowest)
        out += formatted("%lld:%.3f ", Long(w.scene), w.value);
    return out;
}

std::string SceneTally::text() const {
    std::string out = formatted(
        "%lld scenes, %lld collisions, %lld lasting contacts, at most %lld segments in one, %.1f s of CPU;\n"
        "deepest overlap %.1e m (number %lld), most energy gained %.1e of the whole (number %lld);\n"
        "%lld at fault: %lld not finite, %lld did not end, %lld pulled\nslowest:",
        Long(scenes), Long(collisions), Long(lasting), Long(mostSegments), seconds, deepest.value,
        Long(deepest.scene), gained.value, Long(gained.scene), Long(faults), Long(notFinite), Long(notEnded),
        Long(pulls));
    for (const Worst& w : slowest)
        out += formatted(" %lld in %.2f s;", Long(w.scene), w.value);
    return out;
}

std::optional<SceneTally> readTally(const std::string& line) {
    std::istringstream in(line);
    std::string range, colon;
    SceneTally t;
    const auto column = [&in](auto& value) {
        std::string text;
        std::getline(in, text, ',');
        std::istringstream(text) >> value;
    };
    column(range);
    column(t.kind);
    for (std::int64_t* value : {&t.first, &t.count, &t.scenes, &t.collisions, &t.lasting, &t.mostSegments,
                                &t.notFinite, &t.notEnded, &t.pulls, &t.faults})
        column(*value);
    column(t.deepest.value);
    column(t.deepest.scene);
    column(t.gained.value);
    column(t.gained.scene);
    column(t.seconds);
    if (range != "range" || !in || t.count <= 0)
        return std::nullopt;
    Worst slow;
    char between = 0;
    while (in >> slow.scene >> between >> slow.value)
        t.slowest.push_back(slow);
    return t;
}

} // namespace thetalane::bench

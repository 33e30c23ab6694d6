#include "core/study/spare_line.h"

#include "core/bowling/ball_path.h"
#include "core/study/vary_throw.h"

#include <cmath>
#include <vector>

namespace thetalane {
namespace {

using namespace regulation;

constexpr double stepAtPins = 0.015; // of where the ball comes to the pins [m]
constexpr double reach = 0.6;        // how far beside the head pin it is looked for [m]
constexpr int places = 9;            // on the foul line

double directionAt(const Throw& t, double x) {
    return std::atan((x - t.position) / foulLineToHeadPin);
}

// How far beside the place that it was rolled at the ball comes to the pins; hardly another for other
// directions. Nothing where it always falls into a gutter.
std::optional<double> hookOf(Throw t, const LaneConditions& lane) {
    constexpr double step = 0.2, furthest = 2; // m
    for (double aside = 0; aside <= furthest; aside += step)
        for (const double x : {aside, -aside}) {
            t.direction = directionAt(t, x);
            if (const auto entry = entryOf(t, lane.friction))
                return entry->offset - x;
        }
    return std::nullopt;
}

// The longest row of neighbours that all make it.
struct Row {
    int begin = 0, count = 0;
};
Row longestRow(const std::vector<bool>& makes) {
    Row best, now;
    for (int k = 0; k < int(makes.size()); ++k) {
        now = makes[std::size_t(k)] ? Row{now.count == 0 ? k : now.begin, now.count + 1} : Row{};
        if (now.count > best.count)
            best = now;
    }
    return best;
}

} // namespace

std::optional<SpareLine> spareLine(const Throw& base, const PinSet& standing, const LaneConditions& lane,
                                   const std::stop_token& stop) {
    if (standing.none())
        return std::nullopt;
    std::optional<SpareLine> best;
    constexpr double step = stepAtPins / foulLineToHeadPin;
    constexpr int each = int(2 * reach / stepAtPins) + 1;
    for (int place = 0; place < places; ++place) {
        Throw t = base;
        constexpr double edge = laneWidth / 2 - ballRadius;
        t.position = -edge + 2 * edge * place / (places - 1);
        const auto hook = hookOf(t, lane);
        if (!hook)
            continue;
        const double first = directionAt(t, -reach - *hook);
        std::vector<bool> makes(each);
        for (int k = 0; k < each; ++k) {
            if (stop.stop_requested())
                return std::nullopt;
            t.direction = first + k * step;
            makes[std::size_t(k)] = outcomeOf(t, standing, lane).clears();
        }
        const Row row = longestRow(makes);
        if (row.count == 0 || (best && row.count * step <= best->spread))
            continue;
        t.direction = first + (row.begin + (row.count - 1) / 2) * step;
        best = SpareLine{t, row.count * step};
    }
    return best;
}

} // namespace thetalane

#include "core/study/vary_throw.h"

#include "core/bowling/hit_tree.h"
#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"
#include "core/scene/validation.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

// Of a Throw and of a const Throw alike.
template <class T> auto& memberOf(T& t, ThrowQuantity quantity) {
    switch (quantity) {
    case ThrowQuantity::Mass:
        return t.mass;
    case ThrowQuantity::Speed:
        return t.speed;
    case ThrowQuantity::Direction:
        return t.direction;
    case ThrowQuantity::Position:
        return t.position;
    case ThrowQuantity::Spin:
        return t.spin;
    case ThrowQuantity::Axis:
        break;
    }
    return t.axis;
}

std::optional<int> firstPinOf(const Run& run) {
    const auto& bodies = run.scene.bodies;
    for (const Collision& c : run.timeline.collisions())
        if (c.first == 0 && !c.isWall()) // the ball
            return pinNumber(bodies[std::size_t(c.second)]);
    return std::nullopt;
}

} // namespace

double quantityOf(const Throw& t, ThrowQuantity quantity) {
    return memberOf(t, quantity);
}

Throw withQuantity(Throw t, ThrowQuantity quantity, double value) {
    memberOf(t, quantity) = value;
    return t;
}

std::vector<double> variedValues(double from, double to, int count, double present) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k)
        values.push_back(k == count - 1 ? to : from + (to - from) * k / (count - 1));
    const double asGoodAsEqual = 1e-6 * (to - from) / (count - 1);
    const auto near = std::find_if(values.begin(), values.end(),
                                   [=](double v) { return std::abs(v - present) <= asGoodAsEqual; });
    if (near != values.end())
        *near = present;
    else
        values.insert(std::upper_bound(values.begin(), values.end(), present), present);
    return values;
}

VariedThrow outcomeOf(const Throw& t, const PinSet& standing, const LaneConditions& lane) {
    VariedThrow outcome;
    outcome.ballThrow = t;
    const Scene scene = bowlingScene(t, lane.restitution, lane.friction, standing);
    constexpr double fastest = 100; // m/s, as the window takes it
    const bool allowed = t.mass <= regulation::maxBallMass && t.speed > 0 && t.speed <= fastest;
    if (!allowed || !validate(scene).empty())
        return outcome;
    outcome.possible = true;
    const Run run = std::get<Run>(simulate(scene, {}));
    outcome.left = standing & ~fallenPins(run.scene, run.timeline);
    outcome.pinsDown = int(standing.count() - outcome.left.count());
    outcome.firstPin = firstPinOf(run);
    outcome.entry = entryOf(t, lane.friction);
    return outcome;
}

std::vector<VariedThrow> varyThrow(const VarySettings& s,
                                   const std::function<void(const VariedThrow&)>& found,
                                   const std::stop_token& stop) {
    std::vector<VariedThrow> all;
    for (const double value : s.values) {
        if (stop.stop_requested())
            break;
        all.push_back(outcomeOf(withQuantity(s.base, s.quantity, value), s.standing, s.lane));
        all.back().value = value;
        if (found)
            found(all.back());
    }
    return all;
}

} // namespace thetalane

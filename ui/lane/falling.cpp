#include "ui/lane/falling.h"

#include "core/bowling/pinfall.h"

#include <algorithm>

namespace thetalane {
namespace {

constexpr double tippingTime = 0.3; // s

} // namespace

std::vector<std::optional<Fall>> fallsOf(const Run& run) {
    std::vector<std::optional<Fall>> falls(run.scene.bodies.size());
    const double tipping = pinTippingSpeed();
    const auto fell = [&](int body, double time, const Vec2d& v) {
        if (body < 0 || run.scene.bodies[std::size_t(body)].kind != BodyKind::Pin)
            return;
        auto& fall = falls[std::size_t(body)];
        const double speed = norm(v);
        if (speed > 0 && (!fall || time < fall->time))
            fall = Fall{time, v * (1 / speed)};
    };
    for (const Collision& c : run.timeline.collisions()) {
        if (norm(c.steps.after.first) > tipping)
            fell(c.first, c.time, c.steps.after.first);
        if (norm(c.steps.after.second) > tipping)
            fell(c.second, c.time, c.steps.after.second);
    }
    for (const Departure& d : run.timeline.departures())
        fell(d.body, d.time, run.timeline.bodyAt(std::size_t(d.body), d.time).velocity);
    return falls;
}

double tipped(const Fall& fall, double time) {
    return std::clamp((time - fall.time) / tippingTime, 0.0, 1.0);
}

} // namespace thetalane

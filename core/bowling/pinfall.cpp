#include "core/bowling/pinfall.h"

#include "core/scene/bowling_scene.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

bool isPin(const Scene& scene, std::size_t i) {
    return scene.bodies[i].kind == BodyKind::Pin;
}

std::vector<int> indicesOf(const std::vector<bool>& flags) {
    std::vector<int> out;
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i])
            out.push_back(int(i));
    return out;
}

} // namespace

double pinTippingSpeed() {
    constexpr double g = 9.80665;
    constexpr double h = regulation::pinCentreOfGravity;
    constexpr double r = regulation::pinBaseRadius;
    return std::sqrt(2 * g * (std::sqrt(h * h + r * r) - h));
}

std::vector<int> pinsTouched(const Scene& scene, const Timeline& timeline, double t) {
    std::vector<bool> touched(scene.bodies.size(), false);
    for (const Collision& c : timeline.collisions()) {
        if (c.time > t)
            break;
        touched[std::size_t(c.first)] = isPin(scene, std::size_t(c.first));
        if (!c.isWall())
            touched[std::size_t(c.second)] = isPin(scene, std::size_t(c.second));
    }
    return indicesOf(touched);
}

std::vector<int> pinsDown(const Scene& scene, const Timeline& timeline, double t) {
    const double tipping = pinTippingSpeed();
    std::vector<bool> down(scene.bodies.size(), false);
    for (std::size_t i = 0; i < down.size(); ++i) {
        if (!isPin(scene, i))
            continue;
        const auto segments = timeline.segments(i);
        down[i] = std::any_of(segments.begin(), segments.end(), [&](const Segment& s) {
            return s.start <= t && (norm(s.velocity) > tipping || s.place != Place::Play);
        });
    }
    return indicesOf(down);
}

} // namespace thetalane

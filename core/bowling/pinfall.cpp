#include "core/bowling/pinfall.h"

#include <algorithm>
#include <charconv>
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

// Of a pin of the rack: "1" to "10". Of any other, the first, so that none is lost.
int numberOf(const Body& pin) {
    int number = 0;
    std::from_chars(pin.id.data(), pin.id.data() + pin.id.size(), number);
    return std::clamp(number, 1, 10);
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
    const auto struck = [&](int body, Vec2d after) {
        if (body >= 0 && isPin(scene, std::size_t(body)) && std::sqrt(dot(after, after)) > tipping)
            down[std::size_t(body)] = true;
    };
    for (const Collision& c : timeline.collisions()) {
        if (c.time > t)
            break;
        struck(c.first, c.steps.after.first);
        struck(c.second, c.steps.after.second);
    }
    for (const Departure& d : timeline.departures())
        if (d.time <= t && isPin(scene, std::size_t(d.body)))
            down[std::size_t(d.body)] = true;
    return indicesOf(down);
}

PinSet fallenPins(const Scene& scene, const Timeline& timeline) {
    static const double tipping = pinTippingSpeed();
    PinSet fallen;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!isPin(scene, i))
            continue;
        const bool gone = timeline.segments(i).back().place != Place::Play;
        if (gone || timeline.struckSpeed(i) > tipping)
            fallen.set(std::size_t(numberOf(scene.bodies[i]) - 1));
    }
    return fallen;
}

} // namespace thetalane

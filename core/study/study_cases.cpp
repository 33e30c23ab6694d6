#include "core/study/study_cases.h"

#include "core/engine/engine.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double widest = 0.16; // of a throw's path from the head pin [m]

// The standard's distributions differ from library to library; its generators do not.
class Dice {
public:
    explicit Dice(std::uint64_t seed)
        : m_bits(seed) {}
    double in(double low, double high) { return low + (high - low) * (double(m_bits() >> 11) * 0x1p-53); }

private:
    std::mt19937_64 m_bits;
};

Throw drawnThrow(Dice& dice) {
    Throw t;
    t.position = dice.in(-0.4, 0.4);
    t.direction = dice.in(-2.5, 2.5) * degree;
    t.speed = dice.in(7, 9);
    t.spin = dice.in(0, 35);
    t.axis = dice.in(-30, 30) * degree;
    return t;
}

// Whether the ball alone would come to the head pin's row near the head pin.
bool reachesThePins(const Throw& t) {
    constexpr double longest = 6; // s
    Scene scene = bowlingScene(t);
    scene.bodies.resize(1);
    EngineSettings settings;
    settings.until = longest;
    const auto outcome = simulate(std::move(scene), settings);
    const Timeline& timeline = std::get<Run>(outcome).timeline;
    double before = 0, after = timeline.endTime();
    if (timeline.bodyAt(0, after).position.y < 0)
        return false;
    for (int k = 0; k < 60; ++k) {
        const double middle = (before + after) / 2;
        (timeline.bodyAt(0, middle).position.y < 0 ? before : after) = middle;
    }
    const BodyState there = timeline.bodyAt(0, before);
    return there.place == Place::Play && std::abs(there.position.x) <= widest;
}

} // namespace

StudyCases rackThrows(int count, std::uint64_t seed, double restitution) {
    constexpr double speed = 6.8;
    Dice dice(seed);
    StudyCases cases;
    cases.until = 2;
    for (int k = 0; k < count; ++k) {
        const double offset = dice.in(-widest, widest);
        const double angle = dice.in(0, 6) * degree;
        cases.scenes.push_back(rackScene(offset, angle, speed, restitution));
    }
    return cases;
}

StudyCases laneThrows(int count, std::uint64_t seed, double restitution) {
    Dice dice(seed);
    StudyCases cases;
    cases.until = 6;
    while (int(cases.scenes.size()) < count) {
        const Throw t = drawnThrow(dice);
        if (reachesThePins(t))
            cases.scenes.push_back(bowlingScene(t, restitution));
    }
    return cases;
}

StudyCases oneScene(Scene scene, double until) {
    StudyCases cases;
    cases.until = until;
    cases.scenes.push_back(std::move(scene));
    return cases;
}

} // namespace thetalane

#include "ui/game/release_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;

// SplitMix64: a few lines, and the same numbers with every compiler, which <random> does not promise.
class Chance {
public:
    explicit Chance(std::uint64_t seed)
        : m_state(seed) {}

    // Normally distributed, by Box and Muller.
    double normal() {
        const double radius = std::sqrt(-2 * std::log(uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

private:
    std::uint64_t next() {
        std::uint64_t z = (m_state += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    double uniform() { return (double(next() >> 11) + 0.5) * 0x1p-53; } // never 0

    std::uint64_t m_state;
};

} // namespace

ReleaseSpread spreadOf(Release release) {
    switch (release) {
    case Release::Steady:
        return {0.03, 0.05 * degree, 0.003, 0.02};
    case Release::League:
        return {0.10, 0.15 * degree, 0.008, 0.05};
    case Release::Beginner:
        return {0.40, 0.80 * degree, 0.030, 0.15};
    case Release::None:
        break;
    }
    return {};
}

Throw released(Throw aim, Release release, std::uint32_t seed, std::size_t player, std::size_t delivery) {
    if (release == Release::None)
        return aim;
    constexpr double halfLane = regulation::laneWidth / 2, slowest = 0.5, sideways = 89 * degree;
    const ReleaseSpread spread = spreadOf(release);
    Chance chance((std::uint64_t(seed) << 16) + player * 256 + delivery);
    aim.speed = std::max(aim.speed + spread.speed * chance.normal(), std::min(aim.speed, slowest));
    aim.direction = std::clamp(aim.direction + spread.direction * chance.normal(), -sideways, sideways);
    aim.position = std::clamp(aim.position + spread.position * chance.normal(), -halfLane, halfLane);
    aim.spin = aim.spin * std::max(0.0, 1 + spread.spin * chance.normal());
    return aim;
}

} // namespace thetalane

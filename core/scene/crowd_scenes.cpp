#include "core/scene/crowd_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace thetalane {
namespace {

// Knuth's MMIX generator, its upper bits. The standard's distributions differ from library to library.
class Dice {
public:
    double unit() {
        m_state = m_state * 6364136223846793005u + 1442695040888963407u;
        return double(m_state >> 11) * 0x1p-53;
    }
    double around(double spread) { return (2 * unit() - 1) * spread; }
    double normal() {
        double sum = -6;
        for (int k = 0; k < 12; ++k)
            sum += unit();
        return sum;
    }

private:
    std::uint64_t m_state = 2026;
};

// At rest as a whole, 1 m/s (rms) each.
void thermalise(std::vector<Body>& bodies) {
    Vec2d mean;
    for (const Body& b : bodies)
        mean = mean + b.velocity * (1.0 / double(bodies.size()));
    double square = 0;
    for (Body& b : bodies) {
        b.velocity = b.velocity - mean;
        square += dot(b.velocity, b.velocity) / double(bodies.size());
    }
    for (Body& b : bodies)
        b.velocity = b.velocity * (1 / std::sqrt(square));
}

} // namespace

Scene gasScene(int count, double packing) {
    constexpr double half = 1;
    const double radius = std::sqrt(packing * 4 * half * half / (count * std::numbers::pi));
    const int columns = int(std::ceil(std::sqrt(count)));
    const double spacing = 2 * half / columns;
    const double freedom = 0.45 * std::max(0.0, spacing - 2 * radius);
    Dice dice;
    Scene scene;
    scene.title = {"A gas of " + std::to_string(count) + " discs",
                   "원판 " + std::to_string(count) + "개로 이루어진 기체"};
    scene.frame = Frame{-half, half, -half, half, 1};
    scene.bodies.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i) {
        Body b{std::to_string(i + 1), BodyKind::Ball, 1, radius, {}, {}};
        b.position.x = -half + (i % columns + 0.5) * spacing + dice.around(freedom);
        b.position.y = -half + (i / columns + 0.5) * spacing + dice.around(freedom);
        b.velocity.x = dice.normal();
        b.velocity.y = dice.normal();
        scene.bodies.push_back(std::move(b));
    }
    thermalise(scene.bodies);
    return scene;
}

// A nine-foot pool table (2.54 m by 1.27 m), its balls of 57.15 mm and 170 g, as if its pockets were shut. A
// micrometre between neighbours, and the cue ball a hair beside the axis, so that no two collisions fall on
// the same instant.
Scene breakScene() {
    constexpr double radius = 0.028575, mass = 0.17, gap = 1e-6;
    Scene scene;
    scene.title = {"The break: a triangle of fifteen", "브레이크 샷: 삼각형으로 모은 공 열다섯 개"};
    scene.restitution = 0.95;
    scene.frame = Frame{-0.635, 0.635, -1.27, 1.27, 0.8};
    scene.bodies.push_back({"cue", BodyKind::Ball, mass, radius, {0.0012, -0.75}, {0, 8}});
    const double pitch = 2 * radius + gap;
    const double rowPitch = pitch * std::sqrt(3.0) / 2;
    for (int row = 0; row < 5; ++row)
        for (int k = 0; k <= row; ++k)
            scene.bodies.push_back({std::to_string(scene.bodies.size()), BodyKind::Ball, mass, radius,
                                    Vec2d{(k - row / 2.0) * pitch, 0.635 + row * rowPitch}, Vec2d{}});
    return scene;
}

// Galperin's billiard: 1 kg between a wall and 10⁴ kg that comes; ⌈π/atan √(1/10⁴)⌉ - 1 = 314 collisions.
Scene countingScene() {
    Scene scene;
    scene.title = {"Collisions that count π: 314", "π를 세는 충돌: 314번"};
    scene.bodies = {{"A", BodyKind::Ball, 1, 0.05, {0.5, 0}, {}},
                    {"B", BodyKind::Ball, 1e4, 0.15, {1.0, 0}, {-1, 0}}};
    scene.frame = Frame{0.0, {}, {}, {}, 1};
    return scene;
}

} // namespace thetalane

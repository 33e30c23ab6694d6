#include "core/scene/builtin.h"

#include "core/scene/bowling_scene.h"
#include "core/scene/crowd_scenes.h"

namespace thetalane {
namespace {

Body ball(const char* id, double mass, double radius, Vec2d position, Vec2d velocity) {
    return {id, BodyKind::Ball, mass, radius, position, velocity};
}

Scene scene(Title title, double restitution, std::vector<Body> bodies) {
    Scene s;
    s.title = std::move(title);
    s.restitution = restitution;
    s.bodies = std::move(bodies);
    return s;
}

// The paper's two balls in a closed frame (figs 10, 11).
Scene twoBalls() {
    Scene s =
        scene({"Two balls in a frame", "틀 안의 두 공"}, 1.0,
              {ball("A", 2.0, 0.10, {-0.5, 0.0}, {1.0, 0.2}), ball("B", 1.0, 0.08, {0.4, 0.05}, {0.0, 0.0})});
    s.frame = Frame{-1.0, 1.0, -0.6, 0.6, 1.0};
    return s;
}

Scene headOn() {
    return scene(
        {"Head-on", "정면충돌"}, 1.0,
        {ball("A", 1.0, 0.10, {-0.6, 0.0}, {1.0, 0.0}), ball("B", 1.0, 0.10, {0.6, 0.0}, {-0.5, 0.0})});
}

// Equal masses, one at rest, e = 1: they part at 90°.
Scene rightAngle() {
    return scene(
        {"Equal masses part at 90°", "질량이 같으면 90°로 갈라진다"}, 1.0,
        {ball("A", 1.0, 0.10, {-0.6, 0.0}, {1.0, 0.0}), ball("B", 1.0, 0.10, {0.2, -0.10}, {0.0, 0.0})});
}

Scene heavyLight() {
    return scene(
        {"Heavy strikes light", "무거운 공이 가벼운 공을 칠 때"}, 1.0,
        {ball("A", 4.0, 0.14, {-0.7, 0.0}, {1.0, 0.0}), ball("B", 0.5, 0.07, {0.2, -0.06}, {0.0, 0.0})});
}

Scene lightHeavy() {
    return scene(
        {"Light strikes heavy", "가벼운 공이 무거운 공을 칠 때"}, 1.0,
        {ball("A", 0.5, 0.07, {-0.7, 0.0}, {1.0, 0.0}), ball("B", 4.0, 0.14, {0.2, -0.06}, {0.0, 0.0})});
}

Scene glancing() {
    return scene(
        {"Glancing", "비스듬히 스치는 충돌"}, 0.9,
        {ball("A", 1.0, 0.10, {-0.6, 0.0}, {1.0, 0.0}), ball("B", 1.0, 0.10, {0.2, -0.18}, {0.0, 0.0})});
}

Scene inelastic() {
    return scene(
        {"Perfectly inelastic (e = 0)", "완전 비탄성 충돌 (e = 0)"}, 0.0,
        {ball("A", 1.0, 0.10, {-0.6, 0.0}, {1.0, 0.0}), ball("B", 1.0, 0.10, {0.2, -0.08}, {-0.3, 0.0})});
}

// Newton's cradle of five, with gaps, so that the impulses pass one at a time.
Scene cradle() {
    std::vector<Body> balls{ball("A", 1.0, 0.08, {-0.8, 0.0}, {1.0, 0.0})};
    const char* ids[] = {"B", "C", "D", "E"};
    for (int i = 0; i < 4; ++i)
        balls.push_back(ball(ids[i], 1.0, 0.08, {-0.2 + 0.18 * i, 0.0}, {0.0, 0.0}));
    return scene({"Newton's cradle", "뉴턴의 요람"}, 1.0, std::move(balls));
}

Scene rack() {
    // The ball's path lies 0.0676 m right of the head pin: the 17.5 board, the pocket.
    return rackScene(0.0676, 0.0, 6.8);
}

Scene bowling() {
    return bowlingScene(Throw{});
}

template <int Count> Scene gas() {
    return gasScene(Count);
}

constexpr BuiltinScene catalogue[] = {
    {"two-balls", twoBalls},     {"head-on", headOn},         {"right-angle", rightAngle},
    {"heavy-light", heavyLight}, {"light-heavy", lightHeavy}, {"glancing", glancing},
    {"inelastic", inelastic},    {"cradle", cradle},          {"rack", rack},
    {"bowling", bowling},        {"break", breakScene},       {"pi-4", countingScene},
    {"gas-100", gas<100>},       {"gas-1000", gas<1000>},     {"gas-10000", gas<10000>},
};

} // namespace

std::span<const BuiltinScene> builtinScenes() {
    return catalogue;
}

std::optional<Scene> builtinScene(std::string_view id) {
    for (const BuiltinScene& entry : catalogue)
        if (entry.id == id)
            return entry.make();
    return std::nullopt;
}

} // namespace thetalane

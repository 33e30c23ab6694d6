#include "core/scene/bowling_scene.h"

#include <cmath>

namespace thetalane {

using namespace regulation;

std::array<Vec2d, 10> pinPositions() {
    std::array<Vec2d, 10> pins;
    std::size_t next = 0;
    for (int row = 0; row < 4; ++row)
        for (int k = 0; k <= row; ++k)
            pins[next++] = {(k - row / 2.0) * pinSpacing, row * pinRowSpacing};
    return pins;
}

std::vector<Body> fullRack() {
    std::vector<Body> rack;
    rack.reserve(11); // room for the ball in front
    for (const Vec2d position : pinPositions())
        rack.push_back({std::to_string(rack.size() + 1), BodyKind::Pin, pinMass, pinRadius, position, {}});
    return rack;
}

Lane regulationLane() {
    return {-laneWidth / 2, laneWidth / 2, -foulLineToHeadPin, headPinToEnd, gutterWidth, pitDepth};
}

Scene bowlingScene(const Throw& t, double restitution) {
    Scene scene;
    scene.title = {"Bowling: the whole lane", "볼링: 레인 전체"};
    scene.restitution = restitution;
    scene.bodies = fullRack();
    scene.bodies.insert(scene.bodies.begin(),
                        Body{"ball",
                             BodyKind::Ball,
                             t.mass,
                             ballRadius,
                             {t.position, -foulLineToHeadPin},
                             {t.speed * std::sin(t.direction), t.speed * std::cos(t.direction)}});
    scene.lane = regulationLane();
    return scene;
}

Scene rackScene(double offset, double entryAngle, double speed, double restitution) {
    constexpr double start = 0.5; // before the head pin
    Scene scene;
    scene.title = {"The rack: a ball and ten pins", "핀 열 개와 볼링공"};
    scene.restitution = restitution;
    scene.bodies = fullRack();
    scene.bodies.insert(scene.bodies.begin(),
                        Body{"ball",
                             BodyKind::Ball,
                             6.8,
                             ballRadius,
                             {offset - start * std::tan(entryAngle), -start},
                             {speed * std::sin(entryAngle), speed * std::cos(entryAngle)}});
    return scene;
}

} // namespace thetalane

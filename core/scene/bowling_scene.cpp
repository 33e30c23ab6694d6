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

std::vector<Body> rackOf(const PinSet& standing) {
    std::vector<Body> rack;
    rack.reserve(standing.count() + 1); // room for the ball in front
    const auto positions = pinPositions();
    for (std::size_t k = 0; k < positions.size(); ++k)
        if (standing[k])
            rack.push_back({std::to_string(k + 1), BodyKind::Pin, pinMass, pinRadius, positions[k], {}});
    return rack;
}

std::vector<Body> fullRack() {
    return rackOf(allPins);
}

// Where the plates begin and how they throw back is a guess: no drawing and no measurement of either could be
// found. They are hard, padded wood or plastic, and pins come off them clearly slower.
Lane regulationLane() {
    constexpr Kickbacks plates{-0.1, 0.5};
    return {-laneWidth / 2, laneWidth / 2, -foulLineToHeadPin, headPinToEnd, gutterWidth, pitDepth, plates};
}

Friction houseFriction() {
    Friction friction;
    friction.ball = 0.20;    // dry; several published figures agree on about this much
    friction.rolling = 0.01; // a guess: it slows a ball by 0.1 m/s², hardly to be seen over a lane
    friction.pin = 0.4;      // nobody measured pins on a deck; games use 0.3 to 0.56
    // As sure as the dry figure. A real pattern thins out towards its end and its edges; this one is even.
    friction.oil = {{-foulLineToHeadPin, -foulLineToHeadPin + houseOilLength, 0.04}};
    return friction;
}

// Rolling along d, a ball turns about ẑ × d = (-d.y, d.x). A spin slips by u = R ẑ × ω, so friction pulls
// along -u: for the forward roll along d itself, and along d turned by the same angle as the axis is. Left of
// d is counterclockwise, seen from above: the axis turns by +axis.
Spin<double> throwSpin(const Throw& t) {
    const Vec2d pull{std::sin(t.direction - t.axis), std::cos(t.direction - t.axis)};
    return {-t.spin * pull.y, t.spin * pull.x, 0};
}

Body thrownBall(const Throw& t) {
    const Vec2d velocity{t.speed * std::sin(t.direction), t.speed * std::cos(t.direction)};
    return {"ball",   BodyKind::Ball, t.mass, ballRadius, {t.position, -foulLineToHeadPin},
            velocity, throwSpin(t)};
}

Body rackBall(double offset, double entryAngle, double speed, double mass) {
    constexpr double start = 0.5; // before the head pin
    return {"ball",
            BodyKind::Ball,
            mass,
            ballRadius,
            {offset - start * std::tan(entryAngle), -start},
            {speed * std::sin(entryAngle), speed * std::cos(entryAngle)}};
}

Scene bowlingScene(const Throw& t, double restitution, const std::optional<Friction>& friction,
                   const PinSet& standing) {
    Scene scene;
    scene.title = {"Bowling: the whole lane", "볼링: 레인 전체"};
    scene.restitution = restitution;
    scene.bodies = rackOf(standing);
    scene.bodies.insert(scene.bodies.begin(), thrownBall(t));
    scene.lane = regulationLane();
    scene.friction = friction;
    return scene;
}

Scene rackScene(double offset, double entryAngle, double speed, double restitution) {
    Scene scene;
    scene.title = {"The rack: a ball and ten pins", "핀 열 개와 볼링공"};
    scene.restitution = restitution;
    scene.bodies = fullRack();
    scene.bodies.insert(scene.bodies.begin(), rackBall(offset, entryAngle, speed));
    return scene;
}

} // namespace thetalane

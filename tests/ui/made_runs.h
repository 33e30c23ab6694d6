// Runs made by hand, number by number: contacts of the same instant, and a lane with friction. A session is
// handed them as if an engine had made them.
#pragma once

#include "core/scene/bowling_scene.h"
#include "ui/session.h"

#include <cmath>

namespace thetalane {

// The session's own way in, which no one else may use.
void adoptRun(Session& session, Run run);
template <auto Adopt> struct WayIn {
    friend void adoptRun(Session& session, Run run) { (session.*Adopt)(std::move(run)); }
};
template struct WayIn<&Session::adopt>;

inline Disc<double> discOf(const Body& b) {
    return {b.mass, b.radius, b.position, b.velocity};
}

// One contact of several: the impulse is its own, the velocities after are those of the whole pass.
inline PairCollision<double> oneOfSeveral(const Body& first, const Body& second, double e, double impulse,
                                          const VelocityPair<double>& after) {
    PairCollision<double> r = collide(discOf(first), discOf(second), e);
    r.impulse = impulse;
    r.after = after;
    r.exchanged = {rotateIn(after.first, r.contact), rotateIn(after.second, r.contact)};
    const double approach = r.rotated.second.x - r.rotated.first.x;
    r.energyLoss = impulse * (1 - e) * approach / 2;
    r.restitutionResidual = r.exchanged.first.x - r.exchanged.second.x - e * approach;
    r.momentumResidual = {};
    return r;
}

// A meets B and C at once, each 30° off its way, at 0.5 s; B then meets D, which it touches already. All of 1
// kg and 0.1 m. By symmetry the impulse of the first two is λ = (√3/2)(1 + e)/2.5: at e = 1 A goes back with
// v/5.
inline Run oneOnTwo(double e) {
    const double s = 0.5, c = std::sqrt(3) / 2;
    const double lambda = c * (1 + e) / 2.5;
    Run run;
    Scene& scene = run.scene;
    scene.restitution = e;
    const Vec2d b = Vec2d{-s, c} * 0.2, d = Vec2d{s, c} * 0.2;
    scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {0, -0.5}, {0, 1}},
                    {"B", BodyKind::Ball, 1, 0.1, b, {}},
                    {"C", BodyKind::Ball, 1, 0.1, d, {}},
                    {"D", BodyKind::Ball, 1, 0.1, b * 2.0, {}}};
    std::vector<Body> now = scene.bodies;
    now[0].position = {};
    const Vec2d aAfter{0, 1 - 2 * lambda * c}, bPushed = Vec2d{-s, c} * lambda, cAfter = Vec2d{s, c} * lambda;
    TimelineRecord record;
    const auto add = [&](int first, int second, int pass, const PairCollision<double>& steps) {
        record.collisions.push_back({0.5, first, second, Side::Left, 0, pass, 1, steps});
    };
    add(0, 1, 1, oneOfSeveral(now[0], now[1], e, lambda, {aAfter, bPushed}));
    add(0, 2, 1, oneOfSeveral(now[0], now[2], e, lambda, {aAfter, cAfter}));
    now[1].velocity = bPushed;
    add(1, 3, 2, collide(discOf(now[1]), discOf(now[3]), e));
    const VelocityPair<double> last = record.collisions.back().steps.after;
    for (int i = 0; i < 4; ++i)
        record.segments.push_back(
            {i, {0, scene.bodies[std::size_t(i)].position, scene.bodies[std::size_t(i)].velocity, {}}});
    const Vec2d after[] = {aAfter, last.first, cAfter, last.second};
    for (int i = 0; i < 4; ++i)
        record.segments.push_back({i, {0.5, now[std::size_t(i)].position, after[i], {}}});
    record.collisionCount = 3;
    record.endTime = 2;
    run.timeline = Timeline(4, std::move(record));
    return run;
}

// A ball that hooks down the oiled lane, is pressed against pin 1 from 0.6 s to 0.8 s, and rolls on.
inline Run hookingBall() {
    Run run;
    run.scene = bowlingScene(Throw{});
    run.scene.lane->kickbacks = Kickbacks{-0.3, 0.4};
    run.scene.friction = Friction{.ball = 0.2, .rolling = 0.01, .pin = 0.3, .oil = {{-18.288, -6.1, 0.04}}};
    TimelineRecord record;
    const auto add = [&](int body, const Segment& segment, const Rotation& rotation) {
        record.segments.push_back({body, segment});
        record.rotations.push_back(rotation);
    };
    const Vec2d from{0.45, -1.6}, v{0.4, 3}, a{-2, 0.5};
    const double slides = 0.6;
    run.scene.bodies[0].position = from;
    run.scene.bodies[0].velocity = v;
    run.scene.bodies[0].spin = {-20, -15, 4};
    const Vec2d there = from + v * slides + a * (slides * slides / 2);
    const Vec2d then = v + a * slides;
    add(0, {0, from, v, a}, {{-20, -15, 4}, {-9, 12, 0}, FloorPhase::Sliding});
    add(0, {slides, there, then, then * -0.1}, {{-25.4, -7.8, 4}, {2.54, 0.78, 0}, FloorPhase::Rolling});
    for (int i = 1; i < int(run.scene.bodies.size()); ++i)
        add(i, {0, run.scene.bodies[std::size_t(i)].position, {}, {}}, {});
    record.lasting.push_back({0.6, 0.8, 0, 1, Side::Left});
    record.endTime = 2;
    run.timeline = Timeline(run.scene.bodies.size(), std::move(record));
    return run;
}

} // namespace thetalane

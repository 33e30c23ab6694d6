// The next-event engine on a floor with friction: against closed forms, and through contacts that last.
#include "core/engine/engine.h"
#include "core/scene/builtin.h"
#include "tests/core/floor_scenes.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

constexpr double g = standardGravity;
constexpr double degree = std::numbers::pi / 180;

Body pin(int number, double mass, double radius, Vec2d position, Vec2d velocity) {
    return {"p" + std::to_string(number), BodyKind::Pin, mass, radius, position, velocity};
}

Scene onFloor(Friction friction, double e, std::vector<Body> bodies) {
    Scene scene;
    scene.restitution = e;
    scene.bodies = std::move(bodies);
    scene.friction = std::move(friction);
    return scene;
}

} // namespace

class TestFloorEngine : public QObject {
    Q_OBJECT

private slots:
    // v = 8, pure side spin 30 rad/s, R = .1085: the final direction is that of v₀ - β/(1 + β) u₀, whatever
    // μ; at μ = .12 it slides for β|u₀|/((1 + β) μ g) = 2.0969 s.
    void skidHookRoll() {
        const double R = 0.1085, u = std::hypot(8.0, 30 * R);
        for (const double mu : {0.04, 0.12, 0.2}) {
            Scene scene = onFloor({mu, 0, 0, g, {}}, 0.75, {{"ball", BodyKind::Ball, 7, R, {0, 0}, {0, 8}}});
            scene.bodies[0].spin = {0, -30, 0}; // slip to the right: the floor pushes to the left
            const Timeline timeline = runOf(scene, eventSettings(20));
            QCOMPARE(timeline.segments(0).size(), 2);
            const Segment& rolls = timeline.segments(0)[1];
            const double slide = u * (2.0 / 7) / (mu * g);
            QVERIFY(std::abs(rolls.start / slide - 1) < 1e-14);
            const double angle = std::atan2(-rolls.velocity.x, rolls.velocity.y) / degree;
            QVERIFY2(std::abs(angle - 9.2438) < 5e-5, qPrintable(QString::number(angle, 'g', 12)));
            QCOMPARE(timeline.rotations(0)[0].phase, FloorPhase::Sliding);
            QCOMPARE(timeline.rotations(0)[1].phase, FloorPhase::Rolling);
            const BodyState end = timeline.bodyAt(0, 20);
            QVERIFY(std::abs(end.velocity.x - R * end.spin.y) < 1e-13);
            QVERIFY(std::abs(end.velocity.y + R * end.spin.x) < 1e-13);
            if (mu == 0.12) {
                QVERIFY(std::abs(rolls.start - 2.0969) < 5e-5);
                QVERIFY(std::abs(rolls.position.y - 14.379) < 5e-4);
            }
        }
    }

    void aPinSlidesToRest() {
        for (const double mu : {0.05, 0.4}) {
            const Scene scene = onFloor({0, 0, mu, g, {}}, 1, {pin(0, 1.59, 0.06, {0, 0}, {3, 4})});
            const Timeline timeline = runOf(scene, eventSettings(100));
            QCOMPARE(timeline.endReason(), EndReason::AtRest);
            QVERIFY(std::abs(timeline.endTime() / (5 / (mu * g)) - 1) < 1e-14);
            const BodyState end = timeline.bodyAt(0, 100);
            QCOMPARE(end.velocity, (Vec2d{0, 0}));
            QVERIFY(std::abs(norm(end.position) / (25 / (2 * mu * g)) - 1) < 1e-14);
        }
    }

    // A ball that slides over the end of the oil and on: the closed forms, zone by zone.
    void oilThenDry() {
        Friction f{0.2, 0, 0, g, {{-1, 5, 0.04}}};
        Scene scene = onFloor(f, 1, {{"ball", BodyKind::Ball, 7, 0.1, {0, 0}, {0, 8}}});
        const Timeline timeline = runOf(scene, eventSettings(10));
        QCOMPARE(timeline.segments(0).size(), 3);
        const Segment& dry = timeline.segments(0)[1];
        QCOMPARE(dry.position.y, 5.0);
        QVERIFY(std::abs(dry.velocity.y - std::sqrt(64 - 2 * 0.04 * g * 5)) < 1e-14);
        QVERIFY(std::abs(dry.acceleration.y + 0.2 * g) < 1e-14);
        QVERIFY(std::abs(timeline.segments(0)[2].velocity.y - 40.0 / 7) < 1e-13); // 5/7 of v₀
    }

    // e = 0: ball and pin go on as one, slowed by both frictions, and stop together.
    void aBallPushesAPin() {
        const double M = 6.8, m = 1.59, muBall = 0.1, muPin = 0.4, v = 2;
        for (const double e : {0.0, 0.3, 0.75}) {
            Scene scene =
                onFloor({muBall, muBall, muPin, g, {}}, e,
                        {{"ball", BodyKind::Ball, M, 0.1, {0, 0}, {0, v}}, pin(0, m, 0.06, {0, 0.5}, {})});
            scene.bodies[0].spin = {-v / 0.1, 0, 0}; // it rolls
            const Timeline timeline = runOf(scene, eventSettings(20));
            const Health h = healthOf(scene, timeline, 2000);
            qInfo("e %.2f: %lld collisions, %zu segments, %zu lasting, deepest %.1e m, energy gained %.1e", e,
                  static_cast<long long>(timeline.collisionCount()), h.events,
                  timeline.lastingContacts().size(), h.deepest, h.gained);
            QVERIFY(h.ended && timeline.endReason() == EndReason::AtRest);
            QVERIFY(timeline.collisionCount() < 200);
            QVERIFY(h.deepest < 1e-13 && h.gained < 1e-13);
            QVERIFY(!timeline.lastingContacts().empty() || e > 0);
        }
    }

    // Two sliding discs pressed together head-on, in closed form: they stop together after v/a with
    // a = (μ₁ m₁ + μ₂ m₂) g/(m₁ + m₂) common to both.
    void pressedInALineIsExact() {
        // Pins share one μ; a ball without spin slides with its own until it would roll: a heavy β keeps it
        // sliding.
        Scene scene =
            onFloor({0.1, 0.1, 0.4, g, {}}, 0,
                    {{"ball", BodyKind::Ball, 3, 0.1, {0, 0}, {1, 0}}, pin(0, 1, 0.1, {0.2, 0}, {1, 0})});
        scene.bodies[0].spin = {0, 10, 0}; // rolling: slowed by μr g
        const Timeline timeline = runOf(scene, eventSettings(20));
        // Rolling, it is 1 + β times as hard to push.
        const double M = 3 * 1.4, a = (0.1 * M + 0.4 * 1) * g / (M + 1);
        QCOMPARE(timeline.endReason(), EndReason::AtRest);
        QVERIFY2(std::abs(timeline.endTime() - 1 / a) < 1e-9,
                 qPrintable(QString::number(timeline.endTime() * a - 1)));
        QVERIFY(std::abs(timeline.bodyAt(1, 20).position.x - 0.2 - 1 / (2 * a)) < 1e-9);
        QCOMPARE(timeline.collisionCount(), 0);
        QCOMPARE(timeline.lastingContacts().size(), std::size_t(1));
    }

    // A pin struck by a ball while it leans on two others; a ball driven by its spin into a wall, into a
    // corner.
    void wedged() {
        std::vector<Scene> scenes;
        scenes.push_back(onFloor({0.2, 0.01, 0.4, g, {}}, 0.1,
                                 {{"ball", BodyKind::Ball, 6.8, 0.1, {0.01, -0.4}, {0, 2}},
                                  pin(0, 1.5, 0.06, {0, 0}, {}),
                                  pin(1, 1.5, 0.06, {-0.07, std::sqrt(0.0144 - 0.0049)}, {}),
                                  pin(2, 1.5, 0.06, {0.07, std::sqrt(0.0144 - 0.0049)}, {})}));
        Scene wall =
            onFloor({0.2, 0.01, 0.4, g, {}}, 0.5, {{"ball", BodyKind::Ball, 6.8, 0.1, {0, 0}, {1, 0.3}}});
        wall.bodies[0].spin = {-20, 60, 3};
        wall.frame = Frame{-2.0, 0.5, -0.4, 0.4, 0.5};
        scenes.push_back(wall);
        Scene between = wall;
        between.bodies.push_back(pin(0, 1.5, 0.06, {0.44, 0.05}, {}));
        scenes.push_back(between);
        for (const double e : {0.0, 0.1, 0.5, 0.9, 1.0})
            for (Scene scene : scenes) {
                scene.restitution = e;
                if (scene.frame)
                    scene.frame->restitution = e;
                const Timeline timeline = runOf(scene, eventSettings(10));
                const Health h = healthOf(scene, timeline, 1000);
                qInfo("e %.1f: %lld collisions, %zu segments, deepest %.1e, gained %.1e, end %g (%d)", e,
                      static_cast<long long>(timeline.collisionCount()), h.events, h.deepest, h.gained,
                      timeline.endTime(), int(timeline.endReason()));
                QVERIFY(h.ended);
                QVERIFY(h.deepest < 1e-12);
                QVERIFY(h.gained < 1e-12);
            }
    }

    void randomScenesKeepTheLaws() {
        Random random(83);
        Health worst;
        std::int64_t met = 0;
        std::size_t mostEvents = 0;
        for (int k = 0; k < 150; ++k) {
            const double picks[] = {0, 1, random.unit(), random.unit() * 0.1};
            const Scene scene = randomFloorScene(random, 2 + random.below(11), picks[random.below(4)], k % 2,
                                                 random.logUniform(0.1, 10));
            EngineSettings settings = eventSettings(20);
            settings.maxCollisions = 200'000;
            const Timeline timeline = runOf(scene, settings);
            const Health h = healthOf(scene, timeline, 60);
            QVERIFY2(h.ended, qPrintable(QString("scene %1, e %2, %3 collisions by %4 s")
                                             .arg(k)
                                             .arg(scene.restitution)
                                             .arg(timeline.collisionCount())
                                             .arg(timeline.endTime())));
            QVERIFY2(h.gained < 1e-12, qPrintable(QString("scene %1: %2").arg(k).arg(h.gained)));
            QVERIFY2(h.deepest < 1e-12, qPrintable(QString("scene %1: %2").arg(k).arg(h.deepest)));
            for (const Collision& c : timeline.collisions())
                QVERIFY(c.steps.impulse > 0 && c.steps.energyLoss >= 0);
            worst.deepest = std::max(worst.deepest, h.deepest);
            worst.gained = std::max(worst.gained, h.gained);
            mostEvents = std::max(mostEvents, h.events);
            met += timeline.collisionCount();
        }
        qInfo("150 scenes, %lld collisions, at most %zu segments; deepest overlap %.1e m, energy gained %.1e",
              static_cast<long long>(met), mostEvents, worst.deepest, worst.gained);
    }
};

QTEST_GUILESS_MAIN(TestFloorEngine)
#include "test_floor_engine.moc"

// Scenes and their validation: every built-in scene is sound, every fault is named with its place.
#include "core/motion/friction.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "core/scene/validation.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace thetalane;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// Sound, with everything that a scene can have.
Scene wholeLane() {
    Throw hook;
    hook.spin = 30;
    hook.axis = 0.5;
    Scene s = bowlingScene(hook);
    s.friction->oil.push_back({-5.0, -4.0, 0.1});
    return s;
}

// The ball's path to its roll, alone on a floor as long as it takes.
FloorState<double> rolled(const Scene& scene) {
    const Body& ball = scene.bodies[0];
    const Friction& f = *scene.friction;
    Floor<double> floor{f.gravity, {{}, {f.ball}}};
    for (const OilZone& zone : f.oil) {
        floor.zones.edges.insert(floor.zones.edges.end(), {zone.from, zone.to});
        floor.zones.friction.insert(floor.zones.friction.end(), {zone.friction, f.ball});
    }
    const FloorBody<double> body{ball.radius, 1 / ball.inertia, f.rolling};
    auto state = onFloor(ball.position, ball.velocity, ball.spin, body, floor);
    while (state.phase == FloorPhase::Sliding)
        state = stateAfter(state, nextStretch(state, body, floor), body, floor);
    return state;
}

} // namespace

class TestScene : public QObject {
    Q_OBJECT

private slots:
    void builtinScenesAreSound() {
        const QStringList expected{"two-balls", "head-on",   "right-angle", "heavy-light", "light-heavy",
                                   "glancing",  "inelastic", "cradle",      "rack",        "bowling",
                                   "break",     "pi-4",      "gas-100",     "gas-1000",    "gas-10000"};
        for (const QString& id : expected) {
            const auto scene = builtinScene(id.toStdString());
            QVERIFY2(scene, qPrintable(id));
            QVERIFY2(validate(*scene).empty(), qPrintable(id));
            QVERIFY(!scene->title.en.empty() && !scene->title.ko.empty());
        }
        QVERIFY(!builtinScene("nowhere"));
    }

    void pinsStandAsTheRulesSay() {
        // Pin centres, head pin at the origin: USBC lane specifications.
        const double x[] = {0, -.1524, .1524, -.3048, 0, .3048, -.4572, -.1524, .1524, .4572};
        const double y[] = {0, .2640, .2640, .5279, .5279, .5279, .7919, .7919, .7919, .7919};
        const auto pins = pinPositions();
        for (std::size_t i = 0; i < 10; ++i) {
            QVERIFY(std::abs(pins[i].x - x[i]) < 1e-12);
            QVERIFY(std::abs(pins[i].y - y[i]) < 5e-5);
        }
    }

    void faults_data() {
        QTest::addColumn<int>("change");
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, int change, const char* path, SceneErrorCode code) {
            QTest::newRow(name) << change << path << int(code);
        };
        row("mass zero", 0, "bodies[1].mass", SceneErrorCode::NotPositive);
        row("mass negative", 1, "bodies[1].mass", SceneErrorCode::NotPositive);
        row("radius not a number", 2, "bodies[0].radius", SceneErrorCode::NotFinite);
        row("velocity infinite", 3, "bodies[0].velocity[1]", SceneErrorCode::NotFinite);
        row("same id twice", 4, "bodies[1].id", SceneErrorCode::DuplicateId);
        row("no id", 5, "bodies[0].id", SceneErrorCode::EmptyId);
        row("restitution above one", 6, "restitution", SceneErrorCode::OutOfRange);
        row("restitution not a number", 7, "restitution", SceneErrorCode::NotFinite);
        row("no bodies", 8, "bodies", SceneErrorCode::NoBodies);
        row("overlap", 9, "bodies[1].position", SceneErrorCode::Overlap);
        row("same centre", 10, "bodies[1].position", SceneErrorCode::Overlap);
        row("through a wall", 11, "bodies[0].position", SceneErrorCode::OverlapsWall);
        row("outside the frame", 12, "bodies[0].position", SceneErrorCode::OverlapsWall);
        row("walls crossed", 13, "frame.right", SceneErrorCode::WallsCrossed);
        row("wall restitution", 14, "frame.restitution", SceneErrorCode::OutOfRange);
        row("off the lane", 15, "bodies[0].position", SceneErrorCode::OffTheLane);
        row("too many bodies", 16, "bodies", SceneErrorCode::TooManyBodies);
        row("named as a wall", 17, "bodies[1].id", SceneErrorCode::ReservedId);
    }

    void faults() {
        QFETCH(int, change);
        QFETCH(QString, path);
        QFETCH(int, code);
        Scene s = *builtinScene("two-balls");
        switch (change) {
        case 0:
            s.bodies[1].mass = 0;
            break;
        case 1:
            s.bodies[1].mass = -3;
            break;
        case 2:
            s.bodies[0].radius = notANumber;
            break;
        case 3:
            s.bodies[0].velocity.y = HUGE_VAL;
            break;
        case 4:
            s.bodies[1].id = "A";
            break;
        case 5:
            s.bodies[0].id = "";
            break;
        case 6:
            s.restitution = 1.5;
            break;
        case 7:
            s.restitution = notANumber;
            break;
        case 8:
            s.bodies.clear();
            break;
        case 9:
            s.bodies[1].position = {-0.4, 0};
            break;
        case 10:
            s.bodies[1].position = s.bodies[0].position;
            break;
        case 11:
            s.bodies[0].position.x = -0.95;
            break;
        case 12:
            s.bodies[0].position.x = -3;
            break;
        case 13:
            s.frame->right = -2;
            break;
        case 14:
            s.frame->restitution = -0.1;
            break;
        case 15:
            s = bowlingScene(Throw{.position = 0.6});
            break;
        case 16:
            s.bodies.resize(maxBodies + 1);
            break;
        case 17:
            s.bodies[1].id = "wall:left";
            break;
        }
        const auto errors = validate(s);
        QCOMPARE(errors.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(errors[0].path), path);
        QCOMPARE(int(errors[0].code), code);
    }

    void laneFaults_data() {
        using Change = std::function<void(Scene&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const Change& change, const char* path, SceneErrorCode code) {
            QTest::newRow(name) << change << path << int(code);
        };
        using enum SceneErrorCode;
        const auto fault = [&row](const char* path, SceneErrorCode code, double value, auto&& part) {
            const QByteArray name = QByteArray(path) + ' ' + QByteArray::number(value);
            row(
                name, [part, value](Scene& s) { part(s) = value; }, path, code);
        };
        const auto coefficient = [&fault](const char* path, auto&& part) {
            fault(path, NotFinite, notANumber, part);
            fault(path, NotFinite, HUGE_VAL, part);
            fault(path, OutOfRange, -1e-9, part);
            fault(path, OutOfRange, 10.5, part);
        };
        coefficient("friction.ball", [](Scene& s) -> double& { return s.friction->ball; });
        coefficient("friction.rolling", [](Scene& s) -> double& { return s.friction->rolling; });
        coefficient("friction.pin", [](Scene& s) -> double& { return s.friction->pin; });
        coefficient("friction.oil[1].friction",
                    [](Scene& s) -> double& { return s.friction->oil[1].friction; });
        const auto gravity = [](Scene& s) -> double& { return s.friction->gravity; };
        fault("friction.gravity", NotPositive, 0, gravity);
        fault("friction.gravity", NotPositive, -9.8, gravity);
        fault("friction.gravity", NotFinite, HUGE_VAL, gravity);
        const auto inertia = [](Scene& s) -> double& { return s.bodies[0].inertia; };
        fault("bodies[0].inertia", OutOfOpenRange, 0, inertia);
        fault("bodies[0].inertia", OutOfOpenRange, -0.4, inertia);
        fault("bodies[0].inertia", OutOfOpenRange, 1.0000001, inertia);
        fault("bodies[0].inertia", NotFinite, notANumber, inertia);
        fault("bodies[0].spin[0]", NotFinite, notANumber,
              [](Scene& s) -> double& { return s.bodies[0].spin.x; });
        fault("bodies[3].spin[1]", NotFinite, HUGE_VAL,
              [](Scene& s) -> double& { return s.bodies[3].spin.y; });
        fault("bodies[0].spin[2]", NotFinite, notANumber,
              [](Scene& s) -> double& { return s.bodies[0].spin.z; });
        const auto from = [](Scene& s) -> double& { return s.friction->oil[1].from; };
        const auto to = [](Scene& s) -> double& { return s.friction->oil[1].to; };
        fault("friction.oil[1].from", NotFinite, notANumber, from);
        fault("friction.oil[1].to", NotFinite, HUGE_VAL, to);
        fault("friction.oil[1].to", OilReversed, -5, to); // of no length
        fault("friction.oil[1].to", OilReversed, -6, to);
        fault("friction.oil[1].from", OilOverlap, -10, from);
        fault("friction.oil[1].from", OilOverlap, -30, from); // before the first
        const auto plates = [](Scene& s) -> double& { return s.lane->kickbacks->from; };
        fault("lane.kickbacks.from", KickbacksOffTheLane, -18.3, plates);
        fault("lane.kickbacks.from", KickbacksOffTheLane, 0.869, plates);
        fault("lane.kickbacks.from", NotFinite, notANumber, plates);
        const auto bounce = [](Scene& s) -> double& { return s.lane->kickbacks->restitution; };
        fault("lane.kickbacks.restitution", OutOfRange, -0.1, bounce);
        fault("lane.kickbacks.restitution", OutOfRange, 1.1, bounce);
        fault("lane.kickbacks.restitution", NotFinite, notANumber, bounce);
    }

    void laneFaults() {
        QFETCH(std::function<void(Scene&)>, change);
        QFETCH(QString, path);
        QFETCH(int, code);
        Scene s = wholeLane();
        QVERIFY(validate(s).empty());
        change(s);
        const auto errors = validate(s);
        QCOMPARE(errors.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(errors[0].path), path);
        QCOMPARE(int(errors[0].code), code);
    }

    void oilNamesBothZones() {
        Scene s = wholeLane();
        s.friction->oil[1].from = -10;
        const auto errors = validate(s);
        QCOMPARE(errors[0].other, std::string("friction.oil[0]"));
        QCOMPARE(errors[0].value, -10.0);
        QCOMPARE(errors[0].low, s.friction->oil[0].to);
    }

    void zonesMayTouchAndLimitsAreAllowed() {
        Scene s = wholeLane();
        s.friction->oil[1].from = s.friction->oil[0].to;
        s.friction->ball = maxFriction;
        s.friction->pin = s.friction->rolling = 0;
        s.bodies[0].inertia = 1;
        s.lane->kickbacks = Kickbacks{s.lane->end, 1};
        QVERIFY(validate(s).empty());
        s.friction.reset(); // the spin stays, and has no effect
        QVERIFY(s.bodies[0].spin != Spin<double>{});
        QVERIFY(validate(s).empty());
    }

    void houseFigures() {
        const Friction f = houseFriction();
        QCOMPARE(f.ball, 0.20);
        QCOMPARE(f.rolling, 0.01);
        QCOMPARE(f.pin, 0.4);
        QCOMPARE(f.gravity, 9.80665);
        QCOMPARE(f.oil.size(), std::size_t(1));
        QCOMPARE(f.oil[0].from, -18.288);
        QVERIFY(std::abs(f.oil[0].to - (-18.288 + 40 * 0.3048)) < 1e-12);
        QCOMPARE(f.oil[0].friction, 0.04);
        QVERIFY(!bowlingScene(Throw{}, 0.5, std::nullopt).friction);
        QVERIFY(bowlingScene(Throw{}).friction == f);
    }

    void aForwardRollRolls() {
        Throw t;
        t.direction = 0.3;
        t.spin = t.speed / regulation::ballRadius;
        const Scene s = bowlingScene(t);
        const Body& b = s.bodies[0];
        const FloorBody<double> body{b.radius, 2.5, 0};
        QVERIFY(norm(body.slip(b.velocity, b.spin)) < 1e-14);
        QCOMPARE(b.spin.z, 0.0);
    }

    // v = v₀ - β/(1 + β) u₀ whatever the friction: with pure side spin the angle is atan(β R ω/v) to the
    // side.
    void aPositiveAxisHooksToTheLeft() {
        const double angle = std::atan(0.4 * regulation::ballRadius * 30 / 8);
        for (const double direction : {0.0, 0.02, -0.03}) {
            for (const double side : {+1.0, -1.0}) {
                Throw t;
                t.direction = direction;
                t.spin = 30;
                t.axis = side * std::numbers::pi / 2;
                const FloorState<double> end = rolled(bowlingScene(t));
                const double heading = std::atan2(end.velocity.x, end.velocity.y); // positive to the right
                QVERIFY(std::abs(heading - (direction - side * angle)) < 1e-12);
                QVERIFY(side *
                            (end.position.x - t.position - std::tan(direction) * (end.position.y + 18.288)) <
                        -0.05);
            }
        }
        QVERIFY(std::abs(angle * 180 / std::numbers::pi - 9.24) < 0.01);
    }

    // Axis α off the forward roll: u₀ = v d - R ω d turned by α to the left.
    void anyAxisFollowsTheClosedForm() {
        for (const double axis : {0.2, 22 * std::numbers::pi / 180, 1.3, 2.5, -0.7}) {
            Throw t;
            t.direction = 0;
            t.spin = 30;
            t.axis = axis;
            const double turning = 2.0 / 7 * regulation::ballRadius * t.spin;
            const Vec2d expected{-turning * std::sin(axis), 5.0 / 7 * t.speed + turning * std::cos(axis)};
            QVERIFY(norm(rolled(bowlingScene(t)).velocity - expected) < 1e-12);
        }
    }

    void overlapNamesPairAndDepth() {
        Scene s = *builtinScene("two-balls"); // radii 0.10 and 0.08
        s.bodies[1].position = {-0.35, 0};    // 0.15 apart
        const auto errors = validate(s);
        QCOMPARE(errors.size(), std::size_t(1));
        QCOMPARE(errors[0].first, std::string("A"));
        QCOMPARE(errors[0].other, std::string("B"));
        QVERIFY(std::abs(errors[0].value - 0.03) < 1e-15);
    }

    void touchingWithinRoundingIsAllowed() {
        Scene s;
        for (int i = 0; i < 200; ++i)
            s.bodies.push_back({std::to_string(i), BodyKind::Ball, 1, 0.05, {0.1 * i, 0.3}, {}});
        QVERIFY(validate(s).empty());
        s.bodies[100].position.x += 1e-9;
        QCOMPARE(validate(s).size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(TestScene)
#include "test_scene.moc"

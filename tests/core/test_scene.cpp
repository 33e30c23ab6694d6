// Scenes and their validation: every built-in scene is sound, every fault is named with its place.
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "core/scene/validation.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace thetalane;

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
    }

    void faults() {
        QFETCH(int, change);
        QFETCH(QString, path);
        QFETCH(int, code);
        Scene s = *builtinScene("two-balls");
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        switch (change) {
        case 0:
            s.bodies[1].mass = 0;
            break;
        case 1:
            s.bodies[1].mass = -3;
            break;
        case 2:
            s.bodies[0].radius = nan;
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
            s.restitution = nan;
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
        }
        const auto errors = validate(s);
        QCOMPARE(errors.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(errors[0].path), path);
        QCOMPARE(int(errors[0].code), code);
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

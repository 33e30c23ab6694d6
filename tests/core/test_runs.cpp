// How runs begin and end: refusals, end reasons and end times, and what leaves the lane when.
#include "core/engine/engine.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

Scene alone(Vec2d position, Vec2d velocity) {
    Scene scene;
    scene.bodies = {disc(0, 1, 0.1, position, velocity)};
    return scene;
}

// One ball on the regulation lane, no pins.
Scene ballOnLane(Vec2d position, Vec2d velocity) {
    Scene scene = alone(position, velocity);
    scene.bodies[0].radius = regulation::ballRadius;
    scene.lane = regulationLane();
    return scene;
}

} // namespace

class TestRuns : public QObject {
    Q_OBJECT

private slots:
    void refusals_data() {
        QTest::addColumn<double>("until");
        QTest::addColumn<double>("step");
        QTest::addColumn<int>("most");
        QTest::addColumn<int>("reason"); // -1: runs
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double inf = std::numeric_limits<double>::infinity();
        const int until = int(RefusalReason::UntilNotPositive), step = int(RefusalReason::StepNotPositive);
        const int many = int(RefusalReason::TooManySteps),
                  most = int(RefusalReason::MaxCollisionsNotPositive);
        QTest::newRow("sound") << 1.0 << 0.1 << 1 << -1;
        QTest::newRow("until zero") << 0.0 << 0.1 << 1 << until;
        QTest::newRow("until negative") << -1.0 << 0.1 << 1 << until;
        QTest::newRow("until NaN") << nan << 0.1 << 1 << until;
        QTest::newRow("until infinite") << inf << 0.1 << 1 << until;
        QTest::newRow("step zero") << 1.0 << 0.0 << 1 << step;
        QTest::newRow("step negative") << 1.0 << -0.1 << 1 << step;
        QTest::newRow("step NaN") << 1.0 << nan << 1 << step;
        QTest::newRow("step infinite") << 1.0 << inf << 1 << step;
        QTest::newRow("too many steps") << 1.0 << 0.99e-8 << 1 << many;
        QTest::newRow("step denormal") << 1.0 << 5e-324 << 1 << many;
        QTest::newRow("no collision allowed") << 1.0 << 0.1 << 0 << most;
        QTest::newRow("fewer than none") << 1.0 << 0.1 << -5 << most;
    }
    void refusals() {
        QFETCH(double, until);
        QFETCH(double, step);
        QFETCH(int, most);
        QFETCH(int, reason);
        for (const EngineKind kind : {EngineKind::Event, EngineKind::Stepped, EngineKind::Swept}) {
            EngineSettings settings = steppedSettings(until, step);
            settings.kind = kind;
            settings.maxCollisions = most;
            const auto result = simulate(alone({0, 0}, {1, 0}), settings);
            const bool aboutSteps =
                reason == int(RefusalReason::StepNotPositive) || reason == int(RefusalReason::TooManySteps);
            if (reason < 0 || (aboutSteps && kind == EngineKind::Event)) {
                QVERIFY(std::holds_alternative<Run>(result)); // the event engine has no step
                continue;
            }
            QVERIFY(std::holds_alternative<Refusal>(result));
            QCOMPARE(int(std::get<Refusal>(result).reason), reason);
        }
    }

    void refusalsOfOneEngine_data() {
        QTest::addColumn<EngineSettings>("settings");
        QTest::addColumn<int>("reason"); // -1: runs
        const auto row = [](const char* name, const EngineSettings& s, int reason) {
            QTest::newRow(name) << s << reason;
        };
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double inf = std::numeric_limits<double>::infinity();
        const int passes = int(RefusalReason::PassesNotPositive);
        const int contact = int(RefusalReason::ContactTimeNotPositive);
        row("no pass", {.kind = EngineKind::Swept, .passes = 0}, passes);
        row("fewer than none", {.kind = EngineKind::Swept, .passes = -1}, passes);
        row("the fewest", {.kind = EngineKind::Swept, .passes = std::numeric_limits<int>::min()}, passes);
        row("the most", {.kind = EngineKind::Swept, .passes = std::numeric_limits<int>::max()}, -1);
        row("the event engine makes no passes", {.passes = 0}, -1);
        row("contact time zero", {.contactTime = 0}, contact);
        row("contact time negative", {.contactTime = -1e-4}, contact);
        row("contact time NaN", {.contactTime = nan}, contact);
        row("contact time infinite", {.contactTime = inf}, contact);
        row("contact time denormal", {.contactTime = 5e-324}, -1);
        row("swept has no contact time", {.kind = EngineKind::Swept, .contactTime = 0}, -1);
        row("stepped has no contact time", {.kind = EngineKind::Stepped, .contactTime = nan}, -1);
    }
    void refusalsOfOneEngine() {
        QFETCH(EngineSettings, settings);
        QFETCH(int, reason);
        const auto result = simulate(alone({0, 0}, {1, 0}), settings);
        const auto* refusal = std::get_if<Refusal>(&result);
        QCOMPARE(refusal ? int(refusal->reason) : -1, reason);
        if (!refusal)
            return;
        const bool aboutPasses = refusal->reason == RefusalReason::PassesNotPositive;
        const double value = aboutPasses ? settings.passes : settings.contactTime;
        QVERIFY(std::isnan(value) ? std::isnan(refusal->value) : refusal->value == value);
    }

    void endReasons() {
        const Scene moving = alone({0, 0}, {1, 0}), resting = alone({0, 0}, {0, 0});
        Scene boxed = moving;
        boxed.frame = Frame{-1.0, 1.0, -1.0, 1.0, 1.0};
        for (const Precision precision : {Precision::Float, Precision::Double, Precision::Quad}) {
            const auto end = [precision](const Scene& scene, std::int64_t most) {
                EngineSettings settings = eventSettings(10, precision);
                settings.maxCollisions = most;
                return runOf(scene, settings);
            };
            const Timeline free = end(moving, 5);
            QCOMPARE(free.endReason(), EndReason::NoMoreCollisions);
            QCOMPARE(free.endTime(), 10.0);
            QCOMPARE(free.bodyAt(0, 10).position.x, 10.0);
            QCOMPARE(end(resting, 5).endReason(), EndReason::AtRest);
            QCOMPARE(end(resting, 5).endTime(), 0.0);
            const Timeline box = end(boxed, 100); // walls at 0.9, then every 1.8 s
            QCOMPARE(box.endReason(), EndReason::Until);
            QCOMPARE(box.collisionCount(), 6);
            QCOMPARE(box.endTime(), 10.0);
            const Timeline cut = end(boxed, 3);
            QCOMPARE(cut.endReason(), EndReason::MaxCollisions);
            QCOMPARE(cut.collisionCount(), 3);
            QVERIFY(std::abs(cut.endTime() - 4.5) < 1e-5);
        }
    }

    // A wall that takes everything (e = 0), met head-on: at rest from then on.
    void restsAtAWall() {
        Scene scene = alone({0, 0}, {1, 0});
        scene.frame = Frame{{}, 1.0, {}, {}, 0.0};
        const Timeline timeline = runOf(scene, eventSettings(10));
        QCOMPARE(timeline.endReason(), EndReason::AtRest);
        QCOMPARE(timeline.endTime(), 0.9);
        QCOMPARE(timeline.collisionCount(), 1);
        const Timeline stepped = runOf(scene, steppedSettings(10, 0.25));
        QCOMPARE(stepped.endReason(), EndReason::AtRest);
        QCOMPARE(stepped.endTime(), 1.0);
    }

    void steppedEndReasons() {
        Scene boxed = alone({0, 0}, {1, 0});
        boxed.frame = Frame{-1.0, 1.0, -1.0, 1.0, 1.0};
        EngineSettings settings = steppedSettings(10, 0.25);
        QCOMPARE(runOf(boxed, settings).endReason(), EndReason::Until);
        QCOMPARE(runOf(boxed, settings).endTime(), 10.0);
        settings.maxCollisions = 2;
        const Timeline cut = runOf(boxed, settings);
        QCOMPARE(cut.endReason(), EndReason::MaxCollisions);
        QCOMPARE(cut.collisionCount(), 2);
        // 0.1 is not a binary fraction: ten steps of it still make one second.
        settings = steppedSettings(1, 0.1);
        QVERIFY(std::abs(runOf(alone({0, 0}, {1, 0}), settings).bodyAt(0, 1).position.x - 1) < 1e-15);
    }

    // Over the right side, caught by the middle of the gutter, into the pit, stopped at its back: by hand.
    void leavesOverTheSide() {
        const Scene scene = ballOnLane({0.3, -18.288}, {0.5, 8});
        for (const Precision precision : {Precision::Float, Precision::Double, Precision::Quad}) {
            const double tolerance = precision == Precision::Float ? 2e-5 : 1e-14;
            const Timeline timeline = runOf(scene, eventSettings(10, precision));
            QCOMPARE(int(timeline.departures().size()), 2);
            const Departure side = timeline.departures()[0], pit = timeline.departures()[1];
            QCOMPARE(side.place, Place::Gutter);
            QVERIFY(std::abs(side.time - (1.0541 / 2 - 0.3) / 0.5) < tolerance);
            QCOMPARE(pit.place, Place::Pit);
            QVERIFY(std::abs(pit.time - (18.288 + 0.868) / 8) < tolerance);
            const double caught = (1.0541 / 2 + 0.235 / 2 - 0.3) / 0.5;
            QCOMPARE(timeline.bodyAt(0, caught + 1e-4).velocity, (Vec2d{0, 8}));
            QCOMPARE(timeline.bodyAt(0, caught - 1e-4).velocity, (Vec2d{0.5, 8}));
            QVERIFY(std::abs(timeline.bodyAt(0, 2).position.x - (1.0541 / 2 + 0.235 / 2)) < tolerance);
            QCOMPARE(timeline.endReason(), EndReason::AtRest);
            QVERIFY(std::abs(timeline.endTime() - (18.288 + 0.868 + 0.762 - 0.10845) / 8) < tolerance);
        }
    }

    void leavesOverTheEnd() {
        const Timeline timeline = runOf(ballOnLane({-0.2, -18.288}, {0.02, 7}), eventSettings(10));
        QCOMPARE(int(timeline.departures().size()), 1);
        QCOMPARE(timeline.departures()[0].place, Place::Pit);
        QVERIFY(std::abs(timeline.departures()[0].time - 19.156 / 7) < 1e-14);
        QVERIFY(std::abs(timeline.bodyAt(0, 10).position.x - (-0.2 + 0.02 * 19.156 / 7)) < 1e-14);
        QCOMPARE(timeline.endReason(), EndReason::AtRest);
    }

    // What is in the gutter meets nobody, and a straight gutter ball leaves all ten pins standing.
    void aGutterBallTouchesNothing() {
        Throw t;
        t.position = 0.4;
        t.direction = 2 * std::numbers::pi / 180;
        const Timeline timeline = runOf(bowlingScene(t), eventSettings(10));
        QCOMPARE(timeline.collisionCount(), 0);
        QCOMPARE(timeline.departures()[0].place, Place::Gutter);
        QCOMPARE(timeline.endReason(), EndReason::AtRest);
    }

    // The stepped loop finds the same departures, late by less than a step.
    void steppedDepartures() {
        const Timeline timeline =
            runOf(ballOnLane({0.3, -18.288}, {0.5, 8}), steppedSettings(10, 1.0 / 1000));
        QCOMPARE(int(timeline.departures().size()), 2);
        const double side = timeline.departures()[0].time - (1.0541 / 2 - 0.3) / 0.5;
        const double pit = timeline.departures()[1].time - (18.288 + 0.868) / 8;
        QVERIFY(side >= 0 && side < 1.001e-3 && pit >= 0 && pit < 1.001e-3);
        QCOMPARE(timeline.endReason(), EndReason::AtRest);
    }
};

QTEST_GUILESS_MAIN(TestRuns)
#include "test_runs.moc"

// Without ties: contacts of one instant one at a time, as most programs take them, and what that costs.
#include "core/engine/engine.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "tests/core/floor_scenes.h"
#include "tests/core/support.h"
#include "tests/core/timeline_hash.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

EngineSettings withTies(bool ties, double until, Precision precision = Precision::Double) {
    EngineSettings s = eventSettings(until, precision);
    s.ties = ties;
    return s;
}

// A cue along x onto two at rest at ±30°, touching both at once.
Scene cueOnTwo(double e) {
    Scene scene;
    scene.restitution = e;
    const double c = 0.2 * std::sqrt(0.75);
    scene.bodies = {disc(0, 1, 0.1, {-0.5, 0}, {1, 0}), disc(1, 1, 0.1, {c, 0.1}, {}),
                    disc(2, 1, 0.1, {c, -0.1}, {})};
    return scene;
}

} // namespace

class TestOneAtATime : public QObject {
    Q_OBJECT

private slots:
    // By hand, e = 1 and unit speed: the first in the list takes what is along its line, cos 30°, so the cue
    // keeps (1/4, -√3/4); of that it has (√3/8 + √3/8) = √3/4 along the other line, and gives it away.
    void symmetryIsLost() {
        const Timeline together = runOf(cueOnTwo(1), withTies(true, 2));
        const Timeline single = runOf(cueOnTwo(1), withTies(false, 2));
        QCOMPARE(together.collisionCount(), 2);
        QCOMPARE(single.collisionCount(), 2);
        QCOMPARE(single.collisions()[0].second, 1);
        QCOMPARE(single.collisions()[1].second, 2);
        QVERIFY(std::abs(norm(single.bodyAt(1, 2).velocity) - std::sqrt(3.0) / 2) < 1e-14);
        QVERIFY(std::abs(norm(single.bodyAt(2, 2).velocity) - std::sqrt(3.0) / 4) < 1e-14);
        QVERIFY(std::abs(norm(together.bodyAt(1, 2).velocity) - norm(together.bodyAt(2, 2).velocity)) <
                1e-15);
        QVERIFY(std::abs(single.bodyAt(0, 2).velocity.x + 1.0 / 8) < 1e-14);
    }

    // A chain passes its impulse on one contact at a time anyway.
    void aCradleIsTheSame() {
        const Scene scene = *builtinScene("cradle");
        QCOMPARE(hashOf(runOf(scene, withTies(false, 5))), hashOf(runOf(scene, withTies(true, 5))));
    }

    // Alone at its instant, a contact is the same with and without.
    void withoutTiesNothingChanges() {
        Random random(91);
        for (int k = 0; k < 50; ++k) {
            const Scene scene = rackScene(0.32 * k / 50 - 0.16, random.in(0, 0.1), 6.8);
            QCOMPARE(hashOf(runOf(scene, withTies(false, 2))), hashOf(runOf(scene, withTies(true, 2))));
        }
    }

    // It ends, at every e, in crowds that touch; momentum stays, and energy goes where e says.
    void laws() {
        for (const double e : {0.0, 0.02, 0.3, 0.95, 1.0}) {
            for (const Precision precision : {Precision::Float, Precision::Double, Precision::Quad}) {
                Scene scene = *builtinScene("break");
                scene.frame.reset();
                scene.restitution = e;
                const Timeline timeline = runOf(scene, withTies(false, 3, precision));
                const double rounding = precision == Precision::Float ? 1e-4 : 1e-11;
                double lost = 0;
                for (const Collision& c : timeline.collisions())
                    lost += c.steps.energyLoss;
                const Totals start = totals(scene, timeline.stateAt(0)),
                             end = totals(scene, timeline.stateAt(3));
                QVERIFY(norm(start.momentum - end.momentum) < rounding * norm(start.momentum));
                QVERIFY(end.energy < start.energy * (1 + rounding));
                if (e > 0.1) // else cascades are closed, by bodies, too, that did not collide
                    QVERIFY(std::abs(start.energy - end.energy - lost) < rounding * start.energy);
                QVERIFY(deepestOverlap(scene, timeline.stateAt(3)) < rounding);
            }
        }
    }

    void onAFloorToo() {
        Random random(92);
        int differ = 0;
        for (int k = 0; k < 40; ++k) {
            const int count = 2 + random.below(7);
            Scene scene = randomFloorScene(random, count, k % 5 / 4.0, k % 2, 3);
            EngineSettings settings = withTies(false, 3);
            settings.maxCollisions = 100'000;
            const Timeline timeline = runOf(scene, settings);
            const Health health = healthOf(scene, timeline, 100);
            QVERIFY(health.ended && health.gained < 1e-9 && health.deepest < 1e-6);
        }
        for (const double e : {0.0, 0.5, 1.0}) {
            Scene scene = cueOnTwo(e);
            scene.friction = Friction{0.1, 0.01, 0.3, standardGravity, {}};
            const Timeline together = runOf(scene, withTies(true, 5)),
                           single = runOf(scene, withTies(false, 5));
            const double up = norm(single.bodyAt(1, 5).position), down = norm(single.bodyAt(2, 5).position);
            QVERIFY(std::abs(norm(together.bodyAt(1, 5).position) - norm(together.bodyAt(2, 5).position)) <
                    1e-12);
            differ += std::abs(up - down) > 1e-3;
        }
        QVERIFY2(differ >= 2, qPrintable(QString::number(differ)));
    }
};

QTEST_GUILESS_MAIN(TestOneAtATime)
#include "test_one_at_a_time.moc"

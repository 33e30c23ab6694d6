// What must hold of every run of the next-event engine, and runs whose outcome is known by hand.
#include "core/engine/engine.h"
#include "core/motion/impact.h"
#include "core/scene/builtin.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

constexpr double degree = std::numbers::pi / 180;

Scene line(double restitution, std::initializer_list<Body> bodies) {
    Scene scene;
    scene.restitution = restitution;
    scene.bodies = bodies;
    return scene;
}

// A light disc at rest between a wall on the left and a heavy one that comes in: all collisions are counted.
std::int64_t countPi(double ratio, Precision precision) {
    Scene scene = line(1, {disc(0, 1, 0.1, {1, 0}, {0, 0}), disc(1, ratio, 0.1, {2, 0}, {-1, 0})});
    scene.frame = Frame{0.0, {}, {}, {}, 1.0};
    const Timeline timeline = runOf(scene, eventSettings(1e6, precision));
    return timeline.endReason() == EndReason::NoMoreCollisions ? timeline.collisionCount() : -1;
}

} // namespace

class TestEventLaws : public QObject {
    Q_OBJECT

private slots:
    // No NaN, nothing through anything, no energy from nowhere, no pull, no endless run: at any e.
    void randomScenesKeepTheLaws() {
        Random random(41);
        std::int64_t met = 0;
        int cutShort = 0;
        double deepest = 0, gained = 0, drifted = 0;
        for (int k = 0; k < 2000; ++k) {
            const double picks[] = {0, 1, random.unit(), random.unit() * 0.1, 1 - random.unit() * 1e-3};
            const bool walls = k % 2;
            const Scene scene = randomScene(random, 2 + random.below(11), picks[random.below(5)], walls,
                                            random.logUniform(1e-3, 1e3));
            const double speed = norm(scene.bodies[0].velocity) + norm(scene.bodies[1].velocity);
            const double until = 3 / speed;
            EngineSettings settings = eventSettings(until);
            settings.maxCollisions = 2'000;
            const Timeline timeline = runOf(scene, settings);
            met += timeline.collisionCount();
            if (timeline.endReason() == EndReason::MaxCollisions) {
                ++cutShort;
                QVERIFY2(scene.restitution < 0.4,
                         qPrintable(QString("scene %1, e %2").arg(k).arg(scene.restitution)));
            }
            const Totals start = totals(scene, timeline.stateAt(0));
            double last = start.energy, scale = 0;
            for (const Body& b : scene.bodies)
                scale += b.mass * norm(b.velocity);
            for (const Collision& c : timeline.collisions()) {
                QVERIFY2(c.steps.impulse > 0,
                         qPrintable(QString("scene %1: a pull of %2 N·s").arg(k).arg(c.steps.impulse)));
                QVERIFY(c.steps.energyLoss >= 0);
            }
            for (int s = 1; s <= 40; ++s) {
                const auto states = timeline.stateAt(until * s / 40);
                const Totals now = totals(scene, states);
                QVERIFY(std::isfinite(now.energy) && std::isfinite(now.momentum.x));
                deepest = std::max(deepest, deepestOverlap(scene, states));
                gained = std::max(gained, (now.energy - last) / start.energy);
                last = now.energy;
                if (!walls)
                    drifted = std::max(drifted, norm(now.momentum - start.momentum) / scale);
            }
        }
        qInfo("%lld collisions; deepest overlap %.1e m, energy gained %.1e, momentum drifted %.1e (of all)",
              static_cast<long long>(met), deepest, gained, drifted);
        // Inelastic collapse at small e: endless collisions in finite time, cut short by the bound.
        qInfo("%d scenes cut short by inelastic collapse", cutShort);
        QVERIFY(cutShort < 200);
        QVERIFY(deepest < 1e-13);
        QVERIFY(gained < 1e-13);
        QVERIFY(drifted < 1e-12);
    }

    // Pairs that miss, graze, or meet by a hair: each impulse is a push, and none gets through.
    void grazingPairs() {
        Random random(43);
        int met = 0;
        for (int k = 0; k < 50'000; ++k) {
            const double e = k % 3 / 2.0, reach = 0.2;
            const double miss = reach * (1 + (random.below(2) ? 1 : -1) * random.logUniform(1e-17, 1e-6));
            const double turn = random.in(-4, 4), c = std::cos(turn), s = std::sin(turn);
            const Vec2d p{-0.5 * c - miss * s, -0.5 * s + miss * c};
            const Scene scene = line(e, {disc(0, random.logUniform(0.1, 10), 0.1, p, {c, s}),
                                         disc(1, random.logUniform(0.1, 10), 0.1, {0, 0}, {0, 0})});
            const Timeline timeline = runOf(scene, eventSettings(1));
            QVERIFY2(timeline.collisionCount() <= 1, qPrintable(QString("scene %1, e %2").arg(k).arg(e)));
            met += int(timeline.collisionCount());
            for (const Collision& hit : timeline.collisions())
                QVERIFY2(hit.steps.impulse > 0, qPrintable(QString::number(hit.steps.impulse)));
            for (int t = 1; t < 20; ++t)
                QVERIFY(deepestOverlap(scene, timeline.stateAt(t / 20.0)) < 1e-15);
        }
        QVERIFY(met > 10'000 && met < 40'000);
    }

    // After e = 0 the two keep their sideways speeds and have no more to do with each other.
    void inelasticPairsMeetOnce() {
        Random random(47);
        for (int k = 0; k < 50'000; ++k) {
            const double miss = random.in(-0.19, 0.19), turn = random.in(-4, 4);
            const double c = std::cos(turn), s = std::sin(turn), drift = random.in(-3, 3);
            const Vec2d p{-0.5 * c - miss * s, -0.5 * s + miss * c};
            const Scene scene =
                line(0, {disc(0, random.logUniform(0.01, 100), 0.1, p, Vec2d{c, s} + Vec2d{drift, -drift}),
                         disc(1, random.logUniform(0.01, 100), 0.1, {0, 0}, {drift, -drift})});
            const Timeline timeline = runOf(scene, eventSettings(5));
            QCOMPARE(timeline.collisionCount(), 1);
            const Collision& hit = timeline.collisions()[0];
            QVERIFY(std::abs(hit.steps.exchanged.first.x - hit.steps.exchanged.second.x) < 1e-14);
            QVERIFY(deepestOverlap(scene, timeline.stateAt(5)) < 1e-13);
        }
    }

    // The case that first showed it: the second "collision" of this pair was a pull, 2.6 ns after the first.
    void whatRoundingLeavesOfAnApproachIsNoApproach() {
        const double reach = 0.2;
        const Vec2d apart{reach * (1 + 1e-15), 0}; // parted by rounding
        const Vec2d across{-1e-16, 1};             // and approaching by rounding
        QVERIFY(std::isinf(timeToImpact<double>(apart, across, reach, 1.0)));
        QVERIFY(std::isinf(timeToImpact<double>({reach, 0}, across, reach, 1.0)));
        QVERIFY(std::isinf(timeToImpact<double>({reach * (1 - 1e-15), 0}, across, reach, 1.0)));
        // One that is more than rounding counts, from either side of touching.
        QVERIFY(timeToImpact<double>({reach * (1 + 1e-15), 0}, {-1e-3, 0}, reach, 1.0) < 1e-12);
        QCOMPARE(timeToImpact<double>({reach * (1 - 1e-15), 0}, {-1e-3, 0}, reach, 1.0), 0.0);
    }

    // An impulse too small or too large for the type must not stop the clock.
    void extremeMassesEnd() {
        for (const double mass : {1e-200, 1e200}) {
            const double v = mass < 1 ? 1e-120 : 1;
            const Scene scene =
                line(1, {disc(0, mass, 0.1, {0, 0}, {v, 0}), disc(1, mass, 0.1, {1, 0}, {0, 0})});
            const Timeline timeline = runOf(scene, eventSettings(2 / v));
            QCOMPARE(timeline.collisionCount(), 1);
            QVERIFY(timeline.endReason() != EndReason::MaxCollisions);
        }
        const Scene beyondFloat =
            line(1, {disc(0, 1e40, 0.1, {0, 0}, {1, 0}), disc(1, 1, 0.1, {1, 0}, {0, 0})});
        QVERIFY(runOf(beyondFloat, eventSettings(2, Precision::Float)).collisionCount() <= 1);
    }

    void touchingAndApproachingCollidesAtOnce() {
        Random random(53);
        for (int k = 0; k < 2000; ++k) {
            const double e = k % 5 / 4.0, turn = random.in(-4, 4);
            // from parted by rounding to overlapping by rounding
            const double apart = 0.2 * (1 + (k % 9 - 4) * 1.1e-16);
            const Vec2d p{apart * std::cos(turn), apart * std::sin(turn)};
            const double way = turn + std::numbers::pi + random.in(-1.4, 1.4);
            const Scene scene = line(e, {disc(0, 1, 0.1, p, {std::cos(way), std::sin(way)}),
                                         disc(1, random.logUniform(0.1, 10), 0.1, {0, 0}, {0, 0})});
            const Timeline timeline = runOf(scene, eventSettings(2));
            QCOMPARE(timeline.collisionCount(), 1);
            QVERIFY(timeline.collisions()[0].time < 1e-14);
            for (const double t : {1e-9, 1e-3, 0.1, 2.0})
                QVERIFY(deepestOverlap(scene, timeline.stateAt(t)) < 1e-15);
        }
    }

    // The last of N equal discs, with gaps between, leaves first with v [(1 + e)/2]^(N - 1): for an e at
    // which no follower catches up before.
    void gappedCradle() {
        for (const double e : {1.0, 0.9, 0.75, 0.5}) {
            for (int n = 2; n <= 8; ++n) {
                Scene scene = line(e, {disc(0, 1.3, 0.08, {-0.5, 0}, {1.7, 0})});
                for (int i = 1; i < n; ++i)
                    scene.bodies.push_back(disc(i, 1.3, 0.08, {0.2 * i, 0}, {0, 0}));
                const Timeline timeline = runOf(scene, eventSettings(1e4));
                const auto segments = timeline.segments(std::size_t(n) - 1);
                QVERIFY(segments.size() >= 2);
                const double expected = 1.7 * std::pow((1 + e) / 2, n - 1);
                QVERIFY(std::abs(segments[1].velocity.x / expected - 1) < 1e-13);
                QCOMPARE(segments[1].velocity.y, 0.0);
            }
        }
    }

    void countingPi_data() {
        QTest::addColumn<double>("ratio");
        QTest::addColumn<int>("count");
        QTest::newRow("1") << 1.0 << 3;
        QTest::newRow("4") << 4.0 << 6;
        QTest::newRow("16") << 16.0 << 12;
        QTest::newRow("100") << 100.0 << 31;
        QTest::newRow("10^4") << 1e4 << 314;
        QTest::newRow("10^6") << 1e6 << 3141;
        QTest::newRow("10^8") << 1e8 << 31415;
    }
    void countingPi() {
        QFETCH(double, ratio);
        QFETCH(int, count);
        QCOMPARE(countPi(ratio, Precision::Double), count);
        if (ratio < 1e5)
            QCOMPARE(countPi(ratio, Precision::Quad), count);
        if (ratio < 1e3)
            QCOMPARE(countPi(ratio, Precision::Float), count);
    }

    // A squeeze with no end in exact arithmetic (inelastic collapse) ends in this one: bounded, and sound.
    void inelasticCollapseIsBounded() {
        for (const double e : {0.0, 0.01, 0.05}) {
            Scene scene = line(e, {disc(0, 1, 0.1, {0.1, 0}, {-1, 0}), disc(1, 1, 0.1, {0.35, 0}, {-1, 0}),
                                   disc(2, 1, 0.1, {0.6, 0}, {-1, 0}), disc(3, 50, 0.1, {0.9, 0}, {-1, 0})});
            scene.frame = Frame{0.0, {}, {}, {}, e};
            const Timeline timeline = runOf(scene, eventSettings(100));
            qInfo("e %.2f: %lld collisions, end reason %d", e,
                  static_cast<long long>(timeline.collisionCount()), int(timeline.endReason()));
            QVERIFY(timeline.endReason() != EndReason::MaxCollisions);
            QVERIFY(deepestOverlap(scene, timeline.stateAt(100)) < 1e-13);
            const Totals end = totals(scene, timeline.stateAt(100));
            QVERIFY(std::isfinite(end.energy) && end.energy <= 26.5);
        }
    }

    // Pins leave, left of the lane's axis: 1 at 23.58°, 2 at 39.93°, 4 at 14.20°, 7 at 57.48°, whatever e,
    // speed and mass (each along the line of centres with the one that struck it at rest).
    void anglesOfTheRackChain() {
        const std::pair<std::size_t, double> pins[] = {{1, 23.58}, {2, 39.93}, {4, 14.20}, {7, 57.48}};
        for (const double e : {0.5, 0.75, 0.9, 1.0}) {
            for (const double speed : {1.0, 6.8, 9.4}) {
                for (const double mass : {4.5, 6.8, 7.26}) {
                    Scene scene = *builtinScene("rack");
                    scene.restitution = e;
                    scene.bodies[0].mass = mass;
                    scene.bodies[0].velocity = {0, speed};
                    const Timeline timeline = runOf(scene, eventSettings(3 / speed));
                    for (const auto& [pin, angle] : pins) {
                        QVERIFY(timeline.segments(pin).size() > 1);
                        const Vec2d v = timeline.segments(pin)[1].velocity;
                        const double left = std::atan2(-v.x, v.y) / degree;
                        QVERIFY2(std::abs(left - angle) < 0.01,
                                 qPrintable(QString("pin %1 at %2°, e %3").arg(pin).arg(left).arg(e)));
                    }
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestEventLaws)
#include "test_event_laws.moc"

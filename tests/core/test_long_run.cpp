// A run in chapters shows the very bits of a run kept whole: every collision, every stretch of motion, every
// state; from whichever snapshot it is computed again.
#include "core/engine/long_run.h"
#include "core/scene/builtin.h"
#include "core/scene/crowd_scenes.h"
#include "tests/core/support.h"

#include <QTest>

#include <cstring>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

bool same(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0; // also tells -0 from 0, and knows a NaN again
}
bool same(Vec2d a, Vec2d b) {
    return same(a.x, b.x) && same(a.y, b.y);
}
bool same(const VelocityPair<double>& a, const VelocityPair<double>& b) {
    return same(a.first, b.first) && same(a.second, b.second);
}
bool same(const Spin<double>& a, const Spin<double>& b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
bool same(const PairCollision<double>& a, const PairCollision<double>& b) {
    return same(a.first.position, b.first.position) && same(a.second.position, b.second.position) &&
           same(a.contact.cosTheta, b.contact.cosTheta) && same(a.contact.sinTheta, b.contact.sinTheta) &&
           same(a.contact.Z, b.contact.Z) && same(a.before, b.before) && same(a.rotated, b.rotated) &&
           same(a.exchanged, b.exchanged) && same(a.after, b.after) && same(a.impulse, b.impulse) &&
           same(a.energyLoss, b.energyLoss) && same(a.momentumResidual, b.momentumResidual);
}
// But for the number of its group, which counts from the start of a chapter.
bool same(const Collision& a, const Collision& b) {
    return same(a.time, b.time) && a.first == b.first && a.second == b.second && a.side == b.side &&
           (a.group == 0) == (b.group == 0) && a.pass == b.pass && a.together == b.together &&
           same(a.steps, b.steps);
}
bool same(const Segment& a, const Segment& b) {
    return same(a.start, b.start) && same(a.position, b.position) && same(a.velocity, b.velocity) &&
           same(a.acceleration, b.acceleration) && a.place == b.place;
}
bool same(const Rotation& a, const Rotation& b) {
    return same(a.spin, b.spin) && same(a.rate, b.rate) && a.phase == b.phase;
}
bool same(const BodyState& a, const BodyState& b) {
    return same(a.position, b.position) && same(a.velocity, b.velocity) && a.place == b.place &&
           same(a.spin, b.spin) && a.phase == b.phase;
}

// Of `whole`, the chapter's own collisions.
bool sameCollisions(const Chapter& chapter, const Timeline& whole) {
    const auto own = chapter.timeline.collisions();
    const auto all = whole.collisions();
    if (chapter.collisionsBefore + std::int64_t(own.size()) > std::int64_t(all.size()))
        return false;
    for (std::size_t k = 0; k < own.size(); ++k)
        if (!same(own[k], all[std::size_t(chapter.collisionsBefore) + k]))
            return false;
    return true;
}

// The chapter's stretches are, one after another, those of the whole run from the one it begins in.
bool sameSegments(const Chapter& chapter, const Timeline& whole) {
    for (std::size_t body = 0; body < whole.bodyCount(); ++body) {
        const auto own = chapter.timeline.segments(body), all = whole.segments(body);
        const auto turns = chapter.timeline.rotations(body), allTurns = whole.rotations(body);
        std::size_t k = 0;
        while (k < all.size() && !same(all[k], own[0]))
            ++k;
        if (k + own.size() > all.size())
            return false;
        for (std::size_t j = 0; j < own.size(); ++j)
            if (!same(own[j], all[k + j]) || (!turns.empty() && !same(turns[j], allTurns[k + j])))
                return false;
    }
    return true;
}

bool sameStates(const Chapter& chapter, const Timeline& whole, double t) {
    for (std::size_t body = 0; body < whole.bodyCount(); ++body)
        if (!same(chapter.timeline.bodyAt(body, t), whole.bodyAt(body, t)))
            return false;
    return true;
}

// Pins and balls in a box with friction and oil.
Scene frictionScene() {
    Random random(11);
    Scene scene = randomScene(random, 8, 0.8, true, 8);
    scene.friction = Friction{0.12, 0.01, 0.2, standardGravity, {{-0.3, 0.2, 0.04}}};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        scene.bodies[i].kind = i % 2 == 0 ? BodyKind::Ball : BodyKind::Pin;
        scene.bodies[i].inertia = 0.4;
        if (i % 2 == 0)
            scene.bodies[i].spin = {random.in(-40, 40), random.in(-40, 40), random.in(-40, 40)};
    }
    return scene;
}

Scene laneWithoutFriction() {
    Scene scene = *builtinScene("bowling");
    scene.friction.reset();
    return scene;
}

// Fast discs between a wall and a heavy one, and far from them some that fly alone for long: their stretches
// outlast the shifts of the engine's time, which cost their starts some bits.
Scene fastAndAlone() {
    Scene scene;
    scene.frame = Frame{0.0, 200.0, 0.0, 20.0, 1.0};
    for (int i = 0; i < 12; ++i) {
        const double y = 0.5 + 1.5 * i;
        scene.bodies.push_back(disc(3 * i, 1, 0.2, {0.5, y}, {9 + 0.37 * i, 0}));
        scene.bodies.push_back(disc(3 * i + 1, 1e9, 0.4, {1.5 + 0.01 * i, y}, {0, 0}));
        scene.bodies.push_back(disc(3 * i + 2, 1, 0.2, {199.7, y}, {0.29 + 0.013 * i, 0}));
    }
    return scene;
}

Scene crowdOnALattice() {
    Scene scene; // equal speeds along the axes: ties without end
    scene.frame = Frame{-1.0, 1.0, -1.0, 1.0, 1.0};
    for (int i = 0; i < 36; ++i)
        scene.bodies.push_back(disc(i, 1, 0.125, {-0.875 + 0.3125 * (i % 6), -0.875 + 0.3125 * (i / 6)},
                                    {i % 2 ? 1.0 : -1.0, i % 3 ? 0.5 : -0.5}));
    return scene;
}

} // namespace

class TestLongRun : public QObject {
    Q_OBJECT

    static void addScenes() {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<double>("until");
        QTest::addColumn<int>("chapter");
        QTest::newRow("cradle") << *builtinScene("cradle") << 10.0 << 1;
        QTest::newRow("eleven") << [] {
            Random random(3);
            return randomScene(random, 11, 1, true, 3);
        }() << 40.0 << 100;
        QTest::newRow("friction") << frictionScene() << 20.0 << 5;
        QTest::newRow("gas-100") << gasScene(100) << 8.0 << 1000;
        QTest::newRow("fast and alone") << fastAndAlone() << 40.0 << 150;
        QTest::newRow("lattice of ties") << crowdOnALattice() << 4.0 << 60;
        QTest::newRow("break") << *builtinScene("break") << 10.0 << 7;
        QTest::newRow("pi-4") << *builtinScene("pi-4") << 10.0 << 20;
        QTest::newRow("lane, no friction") << laneWithoutFriction() << 5.0 << 3;
    }

private slots:
    void chaptersAreTheWholeRun_data() { addScenes(); }
    void chaptersAreTheWholeRun() {
        QFETCH(Scene, scene);
        QFETCH(double, until);
        QFETCH(int, chapter);
        const EngineSettings settings = eventSettings(until);
        const Timeline whole = runOf(scene, settings);
        // Few snapshots, so that most chapters are computed from further back.
        LongRun run(scene, settings, {.chapter = chapter, .snapshotBytes = 0, .chaptersKept = 2});
        double t = 0;
        std::int64_t collisions = 0;
        std::size_t chapters = 0;
        for (;; ++chapters) {
            const auto c = run.chapterAt(t);
            QCOMPARE(c->index, chapters);
            QVERIFY(same(c->from, t));
            QCOMPARE(c->collisionsBefore, collisions);
            QVERIFY(sameCollisions(*c, whole));
            QVERIFY(sameSegments(*c, whole));
            for (int k = 0; k < 20; ++k)
                QVERIFY(sameStates(*c, whole, c->from + (c->to - c->from) * k / 20));
            if (c->collisionsBefore > 0)
                QVERIFY(same(c->timeline.collisions()[0].time, c->from));
            collisions += std::int64_t(c->timeline.collisions().size());
            t = c->to;
            if (c->last)
                break;
        }
        QVERIFY2(chapters >= 2, "the test is of no use");
        QVERIFY(run.ended());
        QCOMPARE(collisions, whole.collisionCount());
        QCOMPARE(run.collisionCount(), whole.collisionCount());
        QVERIFY(same(run.computedTo(), whole.endTime()));
        QCOMPARE(*run.endReason(), whole.endReason());
        QVERIFY(run.snapshotCount() <= 8);
    }

    // Any moment and any collision, back and forth.
    void anyOrder_data() { addScenes(); }
    void anyOrder() {
        QFETCH(Scene, scene);
        QFETCH(double, until);
        QFETCH(int, chapter);
        const Timeline whole = runOf(scene, eventSettings(until));
        LongRun run(scene, eventSettings(until), {.chapter = chapter, .snapshotBytes = 0});
        Random random(5);
        for (int k = 0; k < 60; ++k) {
            const double t = random.in(0, 1.05 * whole.endTime());
            const auto c = run.chapterAt(t);
            QVERIFY(c->from <= t && (t < c->to || c->last));
            QVERIFY(sameStates(*c, whole, t));
            QVERIFY(sameCollisions(*c, whole));
            const auto number = 1 + std::int64_t(random.below(int(whole.collisionCount())));
            const auto d = run.chapterOfCollision(number);
            QVERIFY(d->collisionsBefore < number);
            const auto own = d->timeline.collisions();
            QVERIFY(number - d->collisionsBefore <= std::int64_t(own.size()));
            QVERIFY(same(own[std::size_t(number - d->collisionsBefore - 1)],
                         whole.collisions()[std::size_t(number - 1)]));
        }
    }

    void otherPrecisions_data() {
        QTest::addColumn<Precision>("precision");
        QTest::newRow("float") << Precision::Float;
        QTest::newRow("quad") << Precision::Quad;
    }
    void otherPrecisions() {
        QFETCH(Precision, precision);
        for (const Scene& scene : {gasScene(25), *builtinScene("rack")}) {
            const EngineSettings settings = eventSettings(1, precision);
            const Timeline whole = runOf(scene, settings);
            LongRun run(scene, settings, {.chapter = 4, .snapshotBytes = 0});
            run.computeTo(2);
            QCOMPARE(run.collisionCount(), whole.collisionCount());
            for (int k = 19; k >= 0; --k) {
                const auto c = run.chapterAt(k * whole.endTime() / 20);
                QVERIFY(sameCollisions(*c, whole));
                QVERIFY(sameStates(*c, whole, k * whole.endTime() / 20));
            }
        }
    }

    // The last chapter ends where the most collisions allowed have happened.
    void endsAtTheMost() {
        EngineSettings settings = eventSettings(1e6);
        for (const std::int64_t most : {1, 999, 1000, 1001, 2500}) {
            settings.maxCollisions = most;
            const Timeline whole = runOf(gasScene(100), settings);
            LongRun run(gasScene(100), settings, {.chapter = 1000});
            const auto last = run.chapterAt(1e9);
            QVERIFY(last->last);
            QCOMPARE(run.collisionCount(), whole.collisionCount());
            QVERIFY(same(last->to, whole.endTime()));
            QCOMPARE(*run.endReason(), EndReason::MaxCollisions);
            QCOMPARE(last->timeline.endReason(), EndReason::MaxCollisions);
            QVERIFY(sameCollisions(*last, whole));
            QVERIFY(sameStates(*last, whole, last->to));
        }
    }

    // Nothing happens, and nothing is computed twice.
    void oneChapter() {
        Scene scene;
        scene.bodies = {disc(0, 1, 0.1, {0, 0}, {1, 0})};
        LongRun run(scene, eventSettings(10));
        const auto c = run.chapterAt(3);
        QVERIFY(c->last && c->from == 0 && c->to == 10);
        QCOMPARE(run.chapterAt(7).get(), c.get());
        QCOMPARE(run.chapterOfCollision(1).get(), c.get());
        QVERIFY(!run.goOn());
    }

    void fewSnapshotsAreKept() {
        LongRun run(gasScene(25), eventSettings(1e6), {.chapter = 10, .snapshotBytes = 0});
        for (int k = 0; k < 1000; ++k) {
            QVERIFY(run.goOn());
            QVERIFY(run.snapshotCount() <= 8);
            QVERIFY(k < 10 || run.snapshotCount() >= 4); // or it would take too long from one to the next
        }
    }
};

QTEST_GUILESS_MAIN(TestLongRun)
#include "test_long_run.moc"

// The search by cells against the search by all pairs: the same collisions, in the same order, at the same
// instants, until chaos has made the rounding visible. What the cells are for is in test_crowds.
#include "core/engine/engines.h"
#include "core/scene/builtin.h"
#include "core/scene/crowd_scenes.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Kind {
    int fewest, most;
    double restitution;
    double radiusRatio;
    bool frame, lane;
};

// Discs of mixed radii thrown into a square that is about 30 % full, or 1 %, none overlapping.
Scene mixedScene(Random& random, const Kind& kind) {
    const int count = kind.fewest + random.below(kind.most - kind.fewest + 1);
    const double packing = random.below(3) ? 0.25 : 0.01;
    std::vector<double> radii;
    double area = 0;
    for (int i = 0; i < count; ++i) {
        radii.push_back(0.1 * random.logUniform(1 / kind.radiusRatio, 1));
        area += std::numbers::pi * radii.back() * radii.back();
    }
    std::sort(radii.rbegin(), radii.rend()); // the large ones find room first
    const double half = std::sqrt(area / packing) / 2 + radii[0];
    Scene scene;
    scene.restitution = kind.restitution;
    if (kind.frame)
        scene.frame = Frame{-half, half, -half, half, random.in(0.5, 1)};
    if (kind.frame && random.below(3) == 0)
        scene.frame->right.reset(); // an open side
    if (kind.lane)
        scene.lane = Lane{-half, half, -half, half, half / 4, half};
    for (const double r : radii) {
        for (bool free = false; !free;) {
            const Vec2d p{random.in(-half + r, half - r), random.in(-half + r, half - r)};
            free = true;
            for (const Body& b : scene.bodies)
                free = free && norm(b.position - p) > (b.radius + r) * (1 + 1e-9);
            const double angle = random.in(-std::numbers::pi, std::numbers::pi);
            const double speed = random.below(4) ? random.in(0, 1) : 0;
            if (free)
                scene.bodies.push_back(disc(int(scene.bodies.size()), random.logUniform(0.1, 10), r, p,
                                            Vec2d{std::cos(angle), std::sin(angle)} * speed));
        }
    }
    return scene;
}

bool sameMeeting(const Collision& a, const Collision& b) {
    return a.first == b.first && a.second == b.second && (a.second >= 0 || a.side == b.side);
}

struct Comparison {
    std::int64_t same = 0;    // collisions in the same order, at instants equal within 1e-12
    bool untilTheEnd = false; // all of them, and how it ended
    bool onlyRounding = true; // what differs first is the same meeting with its rounding grown
    double difference = 0;    // of the instants that are the same, relative [s]
};

double apart(const Collision& a, const Collision& b) {
    return std::abs(a.time - b.time) / std::max(1.0, a.time);
}

// Grown rounding lets two meetings elsewhere change places; it does not make one of them vanish.
bool happensToo(const Collision& meeting, std::span<const Collision> others, std::size_t about) {
    for (std::size_t k = about < 3 ? 0 : about - 3; k < std::min(about + 4, others.size()); ++k)
        if (sameMeeting(others[k], meeting) && apart(others[k], meeting) < 1e-7)
            return true;
    return false;
}

Comparison compare(const Timeline& all, const Timeline& cells) {
    Comparison c;
    const auto a = all.collisions(), b = cells.collisions();
    const std::size_t count = std::min(a.size(), b.size());
    for (std::size_t k = 0; k < count; ++k, ++c.same) {
        if (!sameMeeting(a[k], b[k]) || apart(a[k], b[k]) > 1e-12) {
            // the last one may have changed places with one that was not run
            c.onlyRounding = k + 1 == count || (happensToo(a[k], b, k) && happensToo(b[k], a, k));
            return c;
        }
        c.difference = std::max(c.difference, apart(a[k], b[k]));
    }
    c.untilTheEnd = a.size() == b.size() && all.endReason() == cells.endReason();
    c.onlyRounding = c.untilTheEnd;
    return c;
}

} // namespace

class TestCells : public QObject {
    Q_OBJECT

private slots:
    void agreesWithAllPairs_data() {
        QTest::addColumn<Kind>("kind");
        QTest::addColumn<int>("scenes");
        QTest::newRow("two to five, frame") << Kind{2, 5, 1, 3, true, false} << 400;
        QTest::newRow("two to five, open") << Kind{2, 5, 0.8, 3, false, false} << 400;
        QTest::newRow("dozens, frame") << Kind{6, 60, 1, 2, true, false} << 120;
        QTest::newRow("dozens, frame, e = 0.5") << Kind{6, 60, 0.5, 10, true, false} << 120;
        QTest::newRow("dozens, open") << Kind{6, 60, 0.9, 1.5, false, false} << 120;
        QTest::newRow("dozens, radii 1 : 1000") << Kind{6, 60, 1, 1000, true, false} << 120;
        QTest::newRow("dozens, open, radii 1 : 1000") << Kind{6, 60, 0.7, 1000, false, false} << 120;
        QTest::newRow("dozens, lane") << Kind{6, 60, 0.75, 2, false, true} << 120;
        QTest::newRow("dozens, frame and lane") << Kind{6, 60, 0.75, 2, true, true} << 120;
        QTest::newRow("to 200, frame") << Kind{100, 200, 1, 4, true, false} << 20;
        QTest::newRow("to 200, open") << Kind{100, 200, 0.95, 4, false, false} << 20;
    }
    void agreesWithAllPairs() {
        QFETCH(Kind, kind);
        QFETCH(int, scenes);
        Random random(std::uint64_t(kind.most * 1000 + scenes) + std::uint64_t(kind.radiusRatio * 7));
        std::int64_t same = 0, all = 0;
        int ended = 0;
        double worst = 0;
        for (int k = 0; k < scenes; ++k) {
            const Scene scene = mixedScene(random, kind);
            EngineSettings settings = eventSettings(kind.frame ? 20 : 1e4);
            // Each disc meets about four others before rounding has grown from 1e-16 to 1e-12.
            settings.maxCollisions = std::int64_t(2 * scene.bodies.size());
            const Timeline pairs = runNextEvent(scene, settings, SearchKind::AllPairs);
            const Timeline cells = runNextEvent(scene, settings, SearchKind::Cells);
            const Comparison c = compare(pairs, cells);
            same += c.same;
            all += pairs.collisionCount();
            ended += c.untilTheEnd;
            worst = std::max(worst, c.difference);
            QVERIFY2(c.onlyRounding, qPrintable(QString("scene %1: %2 discs, %3 of %4 collisions")
                                                    .arg(k)
                                                    .arg(scene.bodies.size())
                                                    .arg(c.same)
                                                    .arg(pairs.collisionCount())));
            QVERIFY(deepestOverlap(scene, cells.stateAt(cells.endTime())) < 1e-12);
        }
        qInfo("%lld of %lld collisions the same, %d of %d scenes to the end; instants within %.1e",
              static_cast<long long>(same), static_cast<long long>(all), ended, scenes, worst);
        QVERIFY(2 * same > all);
    }

    // Nothing has been rounded differently yet but the time of looking.
    void firstMeetingsAreTheSame() {
        Random random(41);
        int met = 0;
        for (int k = 0; k < 300; ++k) {
            const Scene scene = mixedScene(random, {2, 40, 1, 2, true, false});
            EngineSettings settings = eventSettings(20);
            settings.maxCollisions = 1;
            const Timeline pairs = runNextEvent(scene, settings, SearchKind::AllPairs);
            const Timeline cells = runNextEvent(scene, settings, SearchKind::Cells);
            QCOMPARE(cells.collisionCount(), pairs.collisionCount());
            if (pairs.collisionCount() == 0)
                continue;
            ++met;
            QVERIFY(sameMeeting(pairs.collisions()[0], cells.collisions()[0]));
            QVERIFY(apart(pairs.collisions()[0], cells.collisions()[0]) <= 1e-14);
        }
        QVERIFY(met > 200);
    }

    // Two swarms far apart, one flies through the other 1e6 m away: few cells for much space, and meetings
    // outside of them.
    void swarmsMeetFarOutside() {
        Random random(43);
        Scene scene = mixedScene(random, {80, 80, 1, 2, false, false});
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            if (i % 2)
                continue;
            scene.bodies[i].position.x -= 1e6;
            scene.bodies[i].velocity.x += 1e4;
        }
        EngineSettings settings = eventSettings(1e4);
        settings.maxCollisions = 30;
        const Timeline pairs = runNextEvent(scene, settings, SearchKind::AllPairs);
        const Timeline cells = runNextEvent(scene, settings, SearchKind::Cells);
        QCOMPARE(cells.collisionCount(), pairs.collisionCount());
        for (int k = 0; k < 12; ++k) // rounding at 1e6 m is 1e-10
            QVERIFY(sameMeeting(pairs.collisions()[std::size_t(k)], cells.collisions()[std::size_t(k)]));
    }

    // All fly apart from the middle and return from mirrors far out, open to one side: cells laid anew.
    void anExplosionIsFollowed() {
        Scene scene = gasScene(400, 0.3);
        scene.frame.reset();
        scene.restitution = 0.9;
        const EngineSettings settings = eventSettings(1e6);
        const Timeline pairs = runNextEvent(scene, settings, SearchKind::AllPairs);
        const Timeline cells = runNextEvent(scene, settings, SearchKind::Cells);
        QCOMPARE(int(cells.endReason()), int(EndReason::NoMoreCollisions));
        QCOMPARE(int(pairs.endReason()), int(EndReason::NoMoreCollisions));
        qInfo("%lld and %lld collisions", static_cast<long long>(pairs.collisionCount()),
              static_cast<long long>(cells.collisionCount()));
        // chaos has changed the two, but not what they are alike in
        QVERIFY(std::abs(double(cells.collisionCount() - pairs.collisionCount())) <
                0.1 * double(pairs.collisionCount()));
        QVERIFY(deepestOverlap(scene, cells.stateAt(20)) < 1e-12);
    }

    void builtinScenesAgree() {
        for (const BuiltinScene& b : builtinScenes()) {
            const Scene scene = b.make();
            if (scene.bodies.size() > 100)
                continue;
            EngineSettings settings = eventSettings(5);
            settings.maxCollisions = std::int64_t(std::max<std::size_t>(2 * scene.bodies.size(), 314));
            const Timeline pairs = runNextEvent(scene, settings, SearchKind::AllPairs);
            const Timeline cells = runNextEvent(scene, settings, SearchKind::Cells);
            const Comparison c = compare(pairs, cells);
            qInfo("%s: %lld of %lld", b.id.data(), static_cast<long long>(c.same),
                  static_cast<long long>(pairs.collisionCount()));
            QVERIFY2(c.same >= std::min<std::int64_t>(pairs.collisionCount(), 20), b.id.data());
        }
    }

    void floatRunsToo() {
        const Scene scene = gasScene(80);
        EngineSettings settings = eventSettings(0.05);
        const Timeline exact = runNextEvent(scene, settings, SearchKind::AllPairs);
        settings.precision = Precision::Float;
        const Timeline cells = runNextEvent(scene, settings, SearchKind::Cells);
        QVERIFY(largestDifference(cells.stateAt(0.05), exact.stateAt(0.05)) < 1e-3);
    }
};

QTEST_GUILESS_MAIN(TestCells)
#include "test_cells.moc"

// The search by cells against the search by all pairs: the same collisions, in the same order, at the same
// instants, until chaos has made the rounding visible. What the cells are for is in test_crowds.
#include "core/engine/cells.h"
#include "core/engine/engines.h"
#include "core/engine/few_pairs.h"
#include "core/scene/builtin.h"
#include "core/scene/crowd_scenes.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

constexpr std::size_t mostFew = FewPairs<double, false>::most;

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

using Around = Surroundings<double, Models<true, false, false>>;
constexpr int nobody = -1;

// A contact to come: of two bodies, or of one with a wall.
struct ToCome {
    double time;
    int first, second;
    Side side;

    bool isThat(const ToCome& c) const {
        if (second == nobody || c.second == nobody)
            return first == c.first && second == c.second && side == c.side;
        return std::minmax(first, second) == std::minmax(c.first, c.second);
    }
};

std::vector<ToCome> allToCome(const PackedDiscs<double>& discs, const Around& around, double now) {
    std::vector<ToCome> all;
    for (int i = 0; i < int(discs.count()); ++i) {
        const auto& a = discs[std::size_t(i)];
        const Vec2d p = a.positionAt(now);
        for (int j = 0; j < i; ++j) {
            const auto& b = discs[std::size_t(j)];
            const double in =
                timeToImpact(p - b.positionAt(now), a.velocity - b.velocity, a.radius + b.radius,
                             dot(a.velocity, a.velocity) + dot(b.velocity, b.velocity));
            if (in < std::numeric_limits<double>::infinity())
                all.push_back({now + in, i, j, Side::Left});
        }
        for (const Side side : sides) {
            const auto w = approachTo(side, around.walls().at[int(side)], p, a.velocity, a.radius);
            if (w.speed > 0 && w.gap < std::numeric_limits<double>::infinity())
                all.push_back({now + std::max(0.0, w.gap / w.speed), i, nobody, side});
        }
    }
    return all;
}

// Discs about a point, each with its images under what leaves the cross of x and y as it is, and a copy of
// all at another place, where the same times are rounded otherwise.
Scene symmetricScene(Random& random, int count, Vec2d copyAt) {
    Scene scene;
    std::vector<Vec2d> points, velocities;
    while (int(points.size()) < count) {
        const Vec2d p{random.in(0.15, 1.8), random.in(0, 1.7)};
        bool free = p.x - p.y > 0.15 && p.y > 0.11;
        for (const Vec2d q : points)
            free = free && norm(p - q) > 0.21;
        if (!free)
            continue;
        points.push_back(p);
        const double slow = random.below(3) ? 1 : 0;
        velocities.push_back({slow * random.in(-1, 1), slow * random.in(-1, 1)});
    }
    const auto image = [](Vec2d v, int k) {
        v = {k & 1 ? -v.x : v.x, k & 2 ? -v.y : v.y};
        return k & 4 ? Vec2d{v.y, v.x} : v;
    };
    for (const Vec2d at : {Vec2d{}, copyAt})
        for (int k = 0; k < 8; ++k)
            for (std::size_t i = 0; i < points.size(); ++i)
                scene.bodies.push_back(disc(int(scene.bodies.size()), 1, 0.1, at + image(points[i], k),
                                            image(velocities[i], k)));
    scene.frame = Frame{-2.0, 2.0 + copyAt.x, -2.0, 2.0 + copyAt.y, 1};
    return scene;
}

struct TieCount {
    int events = 0, ties = 0, missed = 0, needless = 0;
};

// Runs a scene a contact at a time and looks at every other contact to come.
TieCount countTies(const Scene& scene, int events) {
    const Around around(scene);
    Cells<double, false> cells(scene);
    auto& discs = cells.discs();
    cells.start(around);
    double now = 0;
    TieCount count;
    for (; count.events < events; ++count.events) {
        const auto [body, event, tied] = cells.earliest(around);
        if (event.kind == EventKind::None)
            break;
        const bool pair = event.kind == EventKind::Pair;
        const ToCome first{event.time, int(body), pair ? int(event.partner) : nobody,
                           pair ? Side::Left : Side(event.detail)};
        const double window = 65536 * std::numeric_limits<double>::epsilon() * event.time;
        bool surely = false, perhaps = false;
        for (const ToCome& c : allToCome(discs, around, now)) {
            surely = surely || (!c.isThat(first) && c.time <= event.time + window / 2);
            perhaps = perhaps || (!c.isThat(first) && c.time <= event.time + 2 * window + 1e-15);
        }
        count.ties += surely;
        count.missed += surely && !tied;
        count.needless += tied && !perhaps;
        now = event.time;
        std::vector<std::size_t> changed{body};
        discs.moveTo(body, now);
        if (pair) {
            changed.push_back(event.partner);
            discs.moveTo(event.partner, now);
            const auto steps = collide(discs.disc(body), discs.disc(event.partner), scene.restitution);
            discs.setVelocity(body, steps.after.first);
            discs.setVelocity(event.partner, steps.after.second);
        } else {
            const auto steps = collideWithSide(discs.disc(body), first.side, around.walls().restitution);
            discs.setVelocity(body, steps.after.first);
        }
        cells.changedCourse(around, changed, now);
    }
    return count;
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
            for (const SearchKind search : {SearchKind::Cells, SearchKind::Few}) {
                if (search == SearchKind::Few && scene.bodies.size() > mostFew)
                    continue;
                const Timeline found = runNextEvent(scene, settings, search);
                const Comparison c = compare(pairs, found);
                same += c.same;
                all += pairs.collisionCount();
                ended += c.untilTheEnd;
                worst = std::max(worst, c.difference);
                QVERIFY2(c.onlyRounding, qPrintable(QString("scene %1: %2 discs, %3 of %4 collisions")
                                                        .arg(k)
                                                        .arg(scene.bodies.size())
                                                        .arg(c.same)
                                                        .arg(pairs.collisionCount())));
                QVERIFY(deepestOverlap(scene, found.stateAt(found.endTime())) < 1e-12);
            }
        }
        qInfo("%lld of %lld collisions the same, %d of %d runs to the end; instants within %.1e",
              static_cast<long long>(same), static_cast<long long>(all), ended, 2 * scenes, worst);
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
            if (pairs.collisionCount() == 0)
                continue;
            ++met;
            for (const SearchKind search : {SearchKind::Cells, SearchKind::Few}) {
                if (search == SearchKind::Few && scene.bodies.size() > mostFew)
                    continue;
                const Timeline found = runNextEvent(scene, settings, search);
                QCOMPARE(found.collisionCount(), pairs.collisionCount());
                QVERIFY(sameMeeting(pairs.collisions()[0], found.collisions()[0]));
                QVERIFY(apart(pairs.collisions()[0], found.collisions()[0]) <= 1e-14);
            }
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

    // Contacts at the same instant are said to be, also those far from each other.
    void tiesAreReported_data() {
        QTest::addColumn<int>("discs");
        QTest::addColumn<double>("copyAt");
        QTest::newRow("eight images, and a copy near by") << 4 << 4.0;
        QTest::newRow("a copy at a place that is rounded otherwise") << 3 << 7.1;
        QTest::newRow("a copy far away") << 2 << 1234.567;
    }
    void tiesAreReported() {
        QFETCH(int, discs);
        QFETCH(double, copyAt);
        Random random(std::uint64_t(discs) + 71);
        TieCount all;
        for (int k = 0; k < 30; ++k) {
            const TieCount c = countTies(symmetricScene(random, discs, {copyAt, 0.3 * copyAt}), 120);
            all.events += c.events;
            all.ties += c.ties;
            all.missed += c.missed;
            all.needless += c.needless;
        }
        qInfo("%d events, %d ties, %d missed, %d reported needlessly", all.events, all.ties, all.missed,
              all.needless);
        QCOMPARE(all.missed, 0);
        QVERIFY(all.ties > all.events / 3);
        QVERIFY(all.needless <= all.events / 100);
    }

    void tiesAreRareByChance() {
        Random random(73);
        TieCount all;
        for (int k = 0; k < 40; ++k) {
            const TieCount c = countTies(mixedScene(random, {6, 60, 1, 2, true, false}), 200);
            all.events += c.events;
            all.ties += c.ties;
            all.missed += c.missed;
            all.needless += c.needless;
        }
        qInfo("%d events, %d ties, %d missed, %d reported needlessly", all.events, all.ties, all.missed,
              all.needless);
        QVERIFY(all.events > 4000);
        QCOMPARE(all.missed, 0);
        QVERIFY(all.ties + all.needless < all.events / 500);
    }

    // A lattice that rests touching itself and is struck; a disc in a corner; all that is touched at once.
    void latticesAndCornersTie() {
        Scene corner;
        corner.frame = Frame{-1.0, 1.0, -1.0, 1.0, 1};
        corner.bodies = {disc(1, 1, 0.1, {0.2, 0.2}, {1, 1})};
        TieCount c = countTies(corner, 8);
        QCOMPARE(c.missed, 0);
        QVERIFY(c.ties >= 4); // each time the first of the two walls
        Scene lattice;
        lattice.frame = Frame{-4.0, 4.0, -4.0, 4.0, 1};
        for (int k = 0; k < 100; ++k)
            lattice.bodies.push_back(disc(k, 1, 0.125, {-1.0 + 0.25 * (k % 10), -1.0 + 0.25 * (k / 10)}, {}));
        lattice.bodies.push_back(disc(100, 1, 0.125, {-0.625, -2}, {0, 1})); // between two of them
        lattice.bodies.push_back(disc(101, 1, 0.125, {2, 0.25}, {-1, 0}));
        c = countTies(lattice, 200);
        qInfo("lattice: %d events, %d ties, %d missed, %d needless", c.events, c.ties, c.missed, c.needless);
        QCOMPARE(c.missed, 0);
        QVERIFY(c.ties > 20);
    }

    void everyoneNearIsFound() {
        Random random(79);
        for (int k = 0; k < 40; ++k) {
            const Scene scene = mixedScene(random, {6, 60, 1, 5, true, false});
            const Around around(scene);
            Cells<double, false> cells(scene);
            cells.start(around);
            for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
                std::vector<std::size_t> near;
                cells.forEachNear(i, 0.0, [&near](std::size_t j) { near.push_back(j); });
                std::sort(near.begin(), near.end());
                QVERIFY(std::adjacent_find(near.begin(), near.end()) == near.end());
                QVERIFY(!std::binary_search(near.begin(), near.end(), i));
                for (std::size_t j = 0; j < scene.bodies.size(); ++j) {
                    const Body &a = scene.bodies[i], &b = scene.bodies[j];
                    if (j != i && norm(a.position - b.position) <= 1.000001 * (a.radius + b.radius))
                        QVERIFY(std::binary_search(near.begin(), near.end(), j));
                }
            }
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

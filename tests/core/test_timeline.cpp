// Looking up what happened: the same bits at any time, in any order.
#include "core/engine/engine.h"
#include "core/scene/builtin.h"
#include "tests/core/support.h"

#include <QTest>

#include <cstring>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

// Eleven discs in a small box: many collisions in a short time.
Scene busyScene(double restitution) {
    Random random(71);
    Scene scene = randomScene(random, 11, 1, true, 5);
    scene.restitution = restitution;
    return scene;
}

bool sameBits(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::memcmp(&a[i].position, &b[i].position, sizeof(Vec2d)) != 0 ||
            std::memcmp(&a[i].velocity, &b[i].velocity, sizeof(Vec2d)) != 0 || a[i].place != b[i].place)
            return false;
    return a.size() == b.size();
}

std::vector<double> someTimes(const Timeline& timeline, Random& random) {
    std::vector<double> times{0, timeline.endTime()};
    for (int k = 0; k < 500; ++k)
        times.push_back(random.in(0, timeline.endTime()));
    for (const Collision& c :
         timeline.collisions().first(std::min<std::size_t>(300, timeline.collisions().size())))
        times.push_back(c.time);
    std::sort(times.begin(), times.end());
    return times;
}

} // namespace

class TestTimeline : public QObject {
    Q_OBJECT

private slots:
    void anyOrderGivesTheSameBits_data() {
        QTest::addColumn<double>("e");
        QTest::addColumn<bool>("stepped");
        for (const double e : {1.0, 0.9, 0.5})
            QTest::addRow("event, e %g", e) << e << false;
        for (const double e : {1.0, 0.0})
            QTest::addRow("stepped, e %g", e) << e << true;
        QTest::addRow("event, e 0") << 0.0 << false;
    }
    void anyOrderGivesTheSameBits() {
        QFETCH(double, e);
        QFETCH(bool, stepped);
        Random random(73);
        const Scene scene = e == 0 && !stepped ? *builtinScene("inelastic") : busyScene(e);
        const Timeline timeline = runOf(scene, stepped ? steppedSettings(2, 0.01) : eventSettings(2));
        QVERIFY(timeline.collisionCount() > 0);
        const std::vector<double> times = someTimes(timeline, random);
        std::vector<std::vector<BodyState>> forth;
        for (const double t : times)
            forth.push_back(timeline.stateAt(t));
        std::vector<BodyState> kept; // one vector for all, as a view does
        for (std::size_t k = times.size(); k-- > 0;) {
            timeline.stateAt(times[k], kept);
            QVERIFY(sameBits(kept, forth[k]));
        }
        for (int k = 0; k < 2000; ++k) {
            const std::size_t pick = std::size_t(random.below(int(times.size())));
            QVERIFY(sameBits(timeline.stateAt(times[pick]), forth[pick]));
        }
        // A second run of the same scene is the same to the bit.
        const Timeline again = runOf(scene, stepped ? steppedSettings(2, 0.01) : eventSettings(2));
        for (std::size_t k = 0; k < times.size(); k += 7)
            QVERIFY(sameBits(again.stateAt(times[k]), forth[k]));
    }

    // At the very time of a collision: after it, unless another at the same time follows.
    void atAnEventIsAfterIt() {
        for (const char* id : {"two-balls", "inelastic", "rack", "cradle"}) {
            const Timeline timeline = runOf(*builtinScene(id), eventSettings(5));
            for (const Collision& c : timeline.collisions()) {
                if (c.group)
                    continue;
                const BodyState a = timeline.bodyAt(std::size_t(c.first), c.time);
                QVERIFY(a.velocity == c.steps.after.first);
                QVERIFY(a.position == c.steps.first.position);
                const double justBefore = std::nextafter(c.time, 0.0);
                QVERIFY(timeline.bodyAt(std::size_t(c.first), justBefore).velocity == c.steps.before.first);
            }
        }
    }

    void beforeAndAfter() {
        const Timeline timeline = runOf(busyScene(1), eventSettings(2));
        const auto all = timeline.collisions();
        Random random(79);
        for (int k = 0; k < 2000; ++k) {
            const double t =
                k % 3 ? random.in(-0.1, 2.1) : all[std::size_t(random.below(int(all.size())))].time;
            std::optional<std::size_t> before, after;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (all[i].time < t)
                    before = i;
                if (all[i].time > t && !after)
                    after = i;
            }
            QVERIFY(timeline.collisionBefore(t) == before);
            QVERIFY(timeline.collisionAfter(t) == after);
        }
        const Timeline none = runOf(busyScene(1), eventSettings(1e-9));
        QVERIFY(!none.collisionBefore(5) && !none.collisionAfter(-5));
    }

    void timesAreClamped() {
        const Timeline timeline = runOf(busyScene(1), eventSettings(2));
        const double far = std::numeric_limits<double>::infinity();
        QVERIFY(sameBits(timeline.stateAt(-1), timeline.stateAt(0)));
        QVERIFY(sameBits(timeline.stateAt(-far), timeline.stateAt(0)));
        QVERIFY(sameBits(timeline.stateAt(2.5), timeline.stateAt(2)));
        QVERIFY(sameBits(timeline.stateAt(far), timeline.stateAt(2)));
    }

    void segmentsAreInOrderAndMeet() {
        const struct {
            EngineSettings settings;
            double tolerance;
        } runs[] = {{eventSettings(2), 1e-14},
                    {eventSettings(2, Precision::Quad), 1e-14},
                    {eventSettings(2, Precision::Float), 1e-5},
                    {steppedSettings(2, 0.001), 1e-12}}; // the loop adds v·h hundreds of times
        for (const auto& run : runs) {
            const Timeline timeline = runOf(busyScene(0.9), run.settings);
            for (std::size_t i = 0; i < timeline.bodyCount(); ++i) {
                const auto own = timeline.segments(i);
                QCOMPARE(own.front().start, 0.0);
                for (std::size_t k = 1; k < own.size(); ++k) {
                    QVERIFY(own[k].start >= own[k - 1].start);
                    const Vec2d reached =
                        own[k - 1].position + own[k - 1].velocity * (own[k].start - own[k - 1].start);
                    QVERIFY(norm(reached - own[k].position) < run.tolerance);
                }
            }
        }
    }

    void groupsAreThoseOfOneInstant() {
        // Two pairs meet at the same instant, then one of them a wall, alone.
        Scene scene;
        scene.bodies = {disc(0, 1, 0.1, {0, 0}, {1, 0}), disc(1, 1, 0.1, {0.7, 0}, {0, 0}),
                        disc(2, 1, 0.1, {0, 1}, {1, 0}), disc(3, 1, 0.1, {0.7, 1}, {0, 0})};
        scene.frame = Frame{{}, 1.4, {}, {}, 1.0};
        scene.bodies[3].mass = 2;
        const Timeline timeline = runOf(scene, eventSettings(1.2));
        QCOMPARE(int(timeline.collisions().size()), 3);
        QCOMPARE(timeline.collisions()[0].group, 1);
        QCOMPARE(timeline.collisions()[1].group, 1);
        QCOMPARE(timeline.collisions()[2].group, 0);
        QVERIFY(timeline.collisions()[2].isWall());
        int last = 0;
        const Timeline stepped = runOf(busyScene(1), steppedSettings(2, 0.02));
        const auto all = stepped.collisions();
        for (std::size_t k = 1; k < all.size(); ++k) {
            QVERIFY(all[k].time >= all[k - 1].time);
            QCOMPARE(all[k].group != 0 && all[k].group == all[k - 1].group, all[k].time == all[k - 1].time);
            QVERIFY(all[k].group == 0 || all[k].group == last || all[k].group == last + 1);
            last = std::max(last, all[k].group);
        }
    }

    void tenThousandCollisions() {
        const double until = 200;
        const Scene scene = busyScene(1);
        const Timeline timeline = runOf(scene, eventSettings(until));
        QVERIFY(timeline.collisionCount() >= 10'000);
        QCOMPARE(std::int64_t(timeline.collisions().size()), timeline.collisionCount());
        Random random(83);
        const double energy = totals(scene, timeline.stateAt(0)).energy;
        for (int k = 0; k < 2000; ++k) {
            const double t = random.in(0, until);
            const auto states = timeline.stateAt(t);
            QVERIFY(std::abs(totals(scene, states).energy / energy - 1) < 1e-11);
            QVERIFY(deepestOverlap(scene, states) < 1e-12);
            QVERIFY(sameBits(states, timeline.stateAt(t)));
        }
    }

    void anEmptyTimelineIsHarmless() {
        const Timeline none;
        QCOMPARE(none.bodyCount(), std::size_t(0));
        QVERIFY(none.stateAt(1).empty());
        QVERIFY(!none.collisionBefore(1) && !none.collisionAfter(-1));
    }
};

QTEST_GUILESS_MAIN(TestTimeline)
#include "test_timeline.moc"

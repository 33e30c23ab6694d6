// Who hit whom: the tree against a slow walk through the collisions, and the perfect strike recognised.
#include "core/bowling/hit_tree.h"
#include "core/engine/engine.h"
#include "core/scene/builtin.h"

#include <QTest>

#include <numbers>
#include <random>
#include <set>

using namespace thetalane;

namespace {

constexpr double degree = std::numbers::pi / 180;

Run runOf(Scene scene, double until = 10) {
    EngineSettings settings;
    settings.until = until;
    return std::get<Run>(simulate(std::move(scene), settings));
}

Body named(const char* id, BodyKind kind) {
    Body body;
    body.id = id;
    body.kind = kind;
    return body;
}

double speed2(Vec2d v) {
    return v.x * v.x + v.y * v.y;
}

// Of a body that lies at rest: the first contact it has at all, and who came. Looked for body by body, by the
// velocities that the contact itself found.
struct Struck {
    std::size_t collision;
    int by;
};
std::optional<Struck> firstStrike(const Run& run, int body) {
    const auto all = run.timeline.collisions();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Collision& c = all[k];
        if (c.isWall() || !c.involves(body))
            continue;
        return Struck{k, c.first == body ? c.second : c.first};
    }
    return std::nullopt;
}

void compareWithSlowWalk(const Run& run) {
    const HitTree tree = hitTree(run.scene, run.timeline);
    const auto all = run.timeline.collisions();
    std::size_t hits = 0;
    for (const Collision& c : all)
        hits += !c.isWall();
    QCOMPARE(tree.edges.size() + tree.later.size(), hits);
    QCOMPARE(tree.leftOut, std::size_t(0));
    std::set<std::size_t> seen;
    for (const auto* list : {&tree.edges, &tree.later})
        for (const Hit& hit : *list) {
            QVERIFY(seen.insert(hit.collision).second);
            const Collision& c = all[hit.collision];
            QVERIFY(c.involves(hit.from) && c.involves(hit.to) && hit.from != hit.to);
            QCOMPARE(hit.time, c.time);
            QCOMPARE(hit.impulse, c.steps.impulse);
        }
    for (std::size_t body = 1; body < run.scene.bodies.size(); ++body) {
        const auto struck = firstStrike(run, int(body));
        const Hit* edge = tree.hitOn(int(body));
        QCOMPARE(edge != nullptr, struck.has_value());
        const bool untouched =
            std::find(tree.untouched.begin(), tree.untouched.end(), int(body)) != tree.untouched.end();
        QCOMPARE(untouched, !struck);
        if (!struck)
            continue;
        QCOMPARE(edge->from, struck->by);
        QCOMPARE(edge->collision, struck->collision);
        QVERIFY(edge->setMoving);
        const Collision& c = all[edge->collision];
        QVERIFY(speed2(c.first == edge->from ? c.steps.before.first : c.steps.before.second) > 0);
        QCOMPARE(speed2(c.first == edge->to ? c.steps.before.first : c.steps.before.second), 0.0);
    }
    for (std::size_t k = 1; k < tree.edges.size(); ++k)
        QVERIFY(tree.edges[k - 1].time <= tree.edges[k].time);
}

} // namespace

class TestHitTree : public QObject {
    Q_OBJECT

private slots:
    void racksAgreeWithASlowWalk() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> offset(-0.16, 0.16), angle(-6, 6);
        for (int k = 0; k < 300; ++k)
            compareWithSlowWalk(runOf(rackScene(offset(random), angle(random) * degree, 6.8), 2));
    }

    void lanesAgreeWithASlowWalk() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> at(-0.3, 0.3), way(-1, 1);
        std::uniform_int_distribution<unsigned long> pins(0, 1023);
        for (int k = 0; k < 100; ++k) {
            Throw t;
            t.position = at(random);
            t.direction = -t.position / 18.3 + way(random) * degree / 2;
            t.spin = 30;
            t.axis = way(random);
            compareWithSlowWalk(runOf(bowlingScene(t, 0.75, houseFriction(), PinSet(pins(random)))));
        }
    }

    // The chains of the books at the pocket of the books, and their mirror image.
    void thePerfectStrike() {
        const auto at = [](double side) {
            const Run run = runOf(rackScene(side * 0.0676, -side * 6 * degree, 6.8), 2);
            return perfectLinks(run.scene, hitTree(run.scene, run.timeline));
        };
        const auto right = at(1), left = at(-1);
        QVERIFY(right && left);
        QCOMPARE(*right, (PerfectLinks{Hand::Right, 10, true}));
        QCOMPARE(*left, (PerfectLinks{Hand::Left, 10, true}));
        const Run run = runOf(rackScene(0.0676, -6 * degree, 6.8), 2);
        const HitTree tree = hitTree(run.scene, run.timeline);
        QCOMPARE(tree.roots, std::vector<int>{0});
        // Ball is body 0, pin k body k: 1→2→4→7, 3→6→10, 5→8, and the ball on 1, 3, 5, 9 and no other.
        const std::pair<int, int> chains[] = {{1, 2}, {2, 4}, {4, 7}, {3, 6}, {6, 10}, {5, 8}};
        for (const auto& [by, pin] : chains) {
            QCOMPARE(tree.hitOn(pin)->from, by);
            QVERIFY(isPerfectLink(run.scene, *tree.hitOn(pin), Hand::Right));
        }
        std::set<int> byBall;
        for (const Collision& c : run.timeline.collisions())
            if (c.first == 0)
                byBall.insert(c.second);
        QCOMPARE(byBall, (std::set<int>{1, 3, 5, 9}));
        QVERIFY(!isPerfectLink(run.scene, *tree.hitOn(2), Hand::Left));
    }

    void mirrorImagesOfEachOther() {
        const int mirrored[] = {0, 1, 3, 2, 6, 5, 4, 10, 9, 8, 7};
        const auto right = perfectStrikers(Hand::Right), left = perfectStrikers(Hand::Left);
        for (int pin = 1; pin <= 10; ++pin)
            QCOMPARE(left[std::size_t(mirrored[pin] - 1)], mirrored[right[std::size_t(pin - 1)]]);
    }

    // A head-on hit is no perfect strike, and a rack with a pin missing cannot be one.
    void otherThrows() {
        const Run headOn = runOf(rackScene(0, 0, 6.8), 2);
        const auto links = perfectLinks(headOn.scene, hitTree(headOn.scene, headOn.timeline));
        QVERIFY(links && !links->perfect && links->links < 10);
        const Run spare = runOf(bowlingScene({}, 0.75, houseFriction(), PinSet(0b1000000001)));
        QVERIFY(!perfectLinks(spare.scene, hitTree(spare.scene, spare.timeline)));
    }

    // Both move: they meet, neither set the other moving.
    void twoBalls() {
        const Run run = runOf(*builtinScene("two-balls"), 3);
        const HitTree tree = hitTree(run.scene, run.timeline);
        QCOMPARE(tree.edges.size(), std::size_t(1));
        QCOMPARE(tree.roots, std::vector<int>{0});
        QVERIFY(tree.untouched.empty());
        QCOMPARE(tree.edges[0].setMoving,
                 speed2(run.scene.bodies[1].velocity) == 0 || speed2(run.scene.bodies[0].velocity) == 0);
        for (const Hit& hit : tree.later)
            QVERIFY(hit.time > tree.edges[0].time);
    }

    // e = 0: a row that touches is closed in one pass, whatever the order in which its contacts stand.
    void aRowInOnePass() {
        for (const bool reversed : {false, true}) {
            Scene scene;
            scene.restitution = 0;
            for (int k = 0; k < 4; ++k)
                scene.bodies.push_back({std::string(1, char('a' + k)),
                                        BodyKind::Ball,
                                        1,
                                        0.1,
                                        {k == 0 ? -1.0 : 0.2 * k, 0},
                                        {k == 0 ? 1.0 : 0.0, 0}});
            if (reversed)
                std::reverse(scene.bodies.begin(), scene.bodies.end());
            const Run run = runOf(scene, 3);
            const HitTree tree = hitTree(run.scene, run.timeline);
            QCOMPARE(tree.edges.size(), std::size_t(3));
            const auto body = [&](int k) { return reversed ? 3 - k : k; };
            for (int k = 1; k < 4; ++k)
                QCOMPARE(tree.hitOn(body(k))->from, body(k - 1));
        }
    }

    void longRunsAreCutOff() {
        const Run run = runOf(*builtinScene("gas-100"), 2);
        const HitTree some = hitTree(run.scene, run.timeline, 50);
        const std::size_t hits = some.edges.size() + some.later.size();
        QVERIFY(hits > 0 && hits <= 60);
        QVERIFY(some.leftOut > 0);
        QVERIFY(some.leftOut + 50 >= std::size_t(run.timeline.collisionCount()) - 10);
        QVERIFY(hitTree(run.scene, run.timeline).leftOut == 0);
    }

    void pinNumbers() {
        QCOMPARE(pinNumber(named("10", BodyKind::Pin)), std::optional(10));
        for (const char* id : {"11", "0", "1a", "", "-1", "a"})
            QVERIFY(!pinNumber(named(id, BodyKind::Pin)));
        QVERIFY(!pinNumber(named("3", BodyKind::Ball)));
    }
};

QTEST_GUILESS_MAIN(TestHitTree)
#include "test_hit_tree.moc"

// The next-event engine against an independent solver with 50 digits, and against itself in other precisions.
#include "core/engine/engine.h"
#include "core/scene/builtin.h"
#include "tests/core/reference_solver.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

constexpr int collisionsCompared = 8;
// How much a disturbance of 10⁻¹⁶ may have grown by the end for a scene to count as well conditioned: the
// engine rounds a few dozen times where the disturbance strikes once.
constexpr double roundings = 100;
constexpr double demanded = 1e-10;

// One scene compared: the engine's end state and the order of its collisions with the solver's.
struct Comparison {
    int collisions = 0;
    double difference = 0; // engine to solver [m, m/s]
    double growth = 0;     // of a start disturbed by 1e-16, the worst of three patterns
    bool settled = true;   // the disturbed runs met the same bodies in the same order, no two at one instant
    bool sameOrder = true;
};

std::vector<ReferenceSolver::Met> orderOf(const Timeline& timeline) {
    std::vector<ReferenceSolver::Met> order;
    for (const Collision& c : timeline.collisions())
        order.push_back({c.first, c.isWall() ? -1 - int(c.side) : c.second});
    return order;
}

double distanceTo(const ReferenceSolver& solver, const std::vector<BodyState>& states) {
    Wide worst = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        worst = std::max(worst, Wide(abs(solver.x(i) - states[i].position.x)));
        worst = std::max(worst, Wide(abs(solver.y(i) - states[i].position.y)));
        worst = std::max(worst, Wide(abs(solver.vx(i) - states[i].velocity.x)));
        worst = std::max(worst, Wide(abs(solver.vy(i) - states[i].velocity.y)));
    }
    return worst.convert_to<double>();
}

Comparison compare(const Scene& scene, int collisions, Precision precision = Precision::Double) {
    Comparison result;
    ReferenceSolver solver(scene);
    result.collisions = solver.runTo(collisions);
    // To an instant, the same double for all, shortly after the last collision and before the next.
    const Wide later = std::min(Wide(1e-3), Wide(solver.untilNext() / 2));
    // e = 0 in a corner or against a wall: the next ones follow at once (inelastic collapse), no state to
    // compare.
    result.settled = later > Wide(1e-9);
    const double end = Wide(solver.now() + later).convert_to<double>();
    solver.drift(Wide(end) - solver.now());
    for (std::size_t k = 1; k < solver.times().size(); ++k)
        result.settled = result.settled && solver.times()[k] - solver.times()[k - 1] > Wide(1e-9);

    for (unsigned pattern = 1; pattern <= 3; ++pattern) {
        ReferenceSolver disturbed(scene);
        disturbed.disturb(Wide("1e-16"), pattern);
        disturbed.runTo(result.collisions);
        disturbed.drift(Wide(end) - disturbed.now());
        result.settled = result.settled && disturbed.met() == solver.met();
        result.growth = std::max(result.growth, solver.distanceTo(disturbed).convert_to<double>());
    }
    const Timeline timeline = runOf(scene, eventSettings(end, precision));
    result.sameOrder = orderOf(timeline) == solver.met();
    result.difference = distanceTo(solver, timeline.stateAt(end));
    return result;
}

// Random scenes; which ones are chaotic is decided by the solver alone.
void compareMany(int scenes, bool walls, std::uint64_t seed) {
    constexpr double restitutions[] = {1, 1, 0.9, 0.75, 0.5, 0.2, 0};
    Random random(seed);
    int well = 0, met = 0, full = 0;
    double worst = 0, worstOfGrowth = 0;
    for (int k = 0; k < scenes; ++k) {
        const double e = restitutions[random.below(7)];
        const Scene scene = randomScene(random, 2 + random.below(4), e, walls);
        const Comparison c = compare(scene, collisionsCompared);
        met += c.collisions;
        full += c.collisions == collisionsCompared;
        if (!c.settled || c.growth * roundings > demanded)
            continue;
        ++well;
        worst = std::max(worst, c.difference);
        worstOfGrowth = std::max(worstOfGrowth, c.difference / (c.growth + 1e-16));
        QVERIFY2(c.sameOrder, qPrintable(QString("scene %1: another order of collisions").arg(k)));
        QVERIFY2(c.difference <= demanded,
                 qPrintable(QString("scene %1, e %2: %3 off").arg(k).arg(e).arg(c.difference)));
        QVERIFY2(c.difference <= roundings * (c.growth + 1e-16),
                 qPrintable(QString("scene %1, e %2: %3 off, a disturbed start only %4")
                                .arg(k)
                                .arg(e)
                                .arg(c.difference)
                                .arg(c.growth)));
    }
    qInfo("%d scenes, %d collisions, %d scenes with all %d; %d well conditioned; worst %.1e, %.1f times the "
          "growth "
          "of a disturbance",
          scenes, met, full, collisionsCompared, well, worst, worstOfGrowth);
    QVERIFY(well > scenes * 3 / 4);
    QVERIFY(met > 2 * scenes);
}

} // namespace

class TestNextEvent : public QObject {
    Q_OBJECT

private slots:
    void closedScenesAgreeWithFiftyDigits() { compareMany(2000, true, 3); }
    void openScenesAgreeWithFiftyDigits() { compareMany(2000, false, 5); }

    // The engine's own Quad is the reference of the studies: 20 digits beyond double survive the same scenes,
    // and the end state is then right to the last place of the doubles it is handed out in.
    void quadIsRightToTheLastDouble() {
        Random random(23);
        int well = 0;
        for (int k = 0; k < 40; ++k) {
            const Scene scene = randomScene(random, 2 + random.below(3), k % 2 ? 1.0 : 0.8, true);
            const Comparison c = compare(scene, collisionsCompared, Precision::Quad);
            if (!c.settled || c.growth > 1e-6)
                continue;
            ++well;
            QVERIFY(c.sameOrder);
            // lookup in doubles since the last collision adds a rounding or two of numbers up to a few units
            QVERIFY2(c.difference < 2e-15, qPrintable(QString::number(c.difference)));
        }
        QVERIFY(well > 30);
    }

    void builtinScenesAgree_data() {
        QTest::addColumn<QString>("id");
        for (const BuiltinScene& b : builtinScenes())
            if (const Scene scene = b.make(); !scene.lane && scene.bodies.size() < 50)
                QTest::newRow(b.id.data()) << QString::fromUtf8(b.id.data());
    }
    void builtinScenesAgree() {
        QFETCH(QString, id);
        const Comparison c = compare(*builtinScene(id.toStdString()), collisionsCompared);
        QVERIFY(c.collisions > 0);
        QVERIFY(c.sameOrder);
        QVERIFY2(c.difference <= 1e-12, qPrintable(QString::number(c.difference)));
    }

    // The same collisions in the same order, their times and steps equal to the digits of the poorer type.
    void precisionsAgreeToTheirDigits() {
        for (const char* id : {"two-balls", "glancing", "inelastic", "cradle", "right-angle"}) {
            const Scene scene = *builtinScene(id);
            const Timeline quad = runOf(scene, eventSettings(4, Precision::Quad));
            const auto check = [&](Precision precision, double tolerance) {
                const Timeline other = runOf(scene, eventSettings(4, precision));
                QVERIFY(orderOf(other) == orderOf(quad));
                QCOMPARE(other.endReason(), quad.endReason());
                for (std::size_t k = 0; k < quad.collisions().size(); ++k) {
                    const Collision &a = other.collisions()[k], &b = quad.collisions()[k];
                    QVERIFY(std::abs(a.time - b.time) <= tolerance);
                    QVERIFY(norm(a.steps.after.first - b.steps.after.first) <= tolerance);
                    QVERIFY(norm(a.steps.first.position - b.steps.first.position) <= tolerance);
                }
                QVERIFY(largestDifference(other.stateAt(4), quad.stateAt(4)) <= tolerance);
            };
            check(Precision::Double, 1e-13);
            check(Precision::Float, 1e-4);
        }
    }

    // Run, reverse every velocity, run again: back to the start, but for what chaos made of the rounding.
    void timeReverses() {
        Random random(29);
        int back = 0;
        double worst = 0;
        for (int k = 0; k < 60; ++k) {
            Scene scene = randomScene(random, 4, 1.0, true);
            const Scene start = scene;
            const Timeline forth = runOf(scene, eventSettings(3));
            const auto turn = forth.stateAt(3);
            for (std::size_t i = 0; i < turn.size(); ++i) {
                scene.bodies[i].position = turn[i].position;
                scene.bodies[i].velocity = -turn[i].velocity;
            }
            const Timeline again = runOf(scene, eventSettings(3));
            double off = 0;
            const auto end = again.stateAt(3);
            for (std::size_t i = 0; i < end.size(); ++i)
                off = std::max(off, norm(end[i].position - start.bodies[i].position));
            if (off < 1e-9) {
                ++back;
                worst = std::max(worst, off);
                QCOMPARE(again.collisionCount(), forth.collisionCount());
            }
        }
        qInfo("%d of 60 scenes came back within 1e-9 m, the worst of them within %.1e m", back, worst);
        QVERIFY(back > 45);
    }

    void keepingNoDetailChangesNothing() {
        Random random(31);
        for (int k = 0; k < 100; ++k) {
            const double e = k % 4 / 3.0;
            const Scene scene = randomScene(random, 6, e, k % 2);
            EngineSettings settings = k % 3 ? eventSettings(2) : steppedSettings(2, 0.01);
            const Timeline whole = runOf(scene, settings);
            settings.keepDetail = false;
            const Timeline summary = runOf(scene, settings);
            QVERIFY(summary.stateAt(2) == whole.stateAt(2));
            QCOMPARE(summary.collisionCount(), whole.collisionCount());
            QCOMPARE(std::int64_t(whole.collisions().size()), whole.collisionCount());
            QCOMPARE(summary.endTime(), whole.endTime());
            QCOMPARE(summary.endReason(), whole.endReason());
            QVERIFY(summary.collisions().empty() && summary.departures().empty());
        }
    }
};

QTEST_GUILESS_MAIN(TestNextEvent)
#include "test_next_event.moc"

// Many bodies: what must be conserved over many collisions, and what is exactly known of a gas of discs.
#include "core/engine/engines.h"
#include "core/scene/builtin.h"
#include "core/scene/crowd_scenes.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

Timeline summaryOf(const Scene& scene, std::int64_t collisions, double until = 1e9) {
    EngineSettings settings = eventSettings(until);
    settings.maxCollisions = collisions;
    settings.keepDetail = false;
    return runOf(scene, settings);
}

} // namespace

class TestCrowds : public QObject {
    Q_OBJECT

private slots:
    void gasesAreWhatTheySay() {
        for (const int count : {100, 1000, 10000}) {
            const Scene scene = *builtinScene("gas-" + std::to_string(count));
            QCOMPARE(int(scene.bodies.size()), count);
            QVERIFY(validate(scene).empty());
            double area = 0, square = 0;
            Vec2d momentum;
            for (const Body& b : scene.bodies) {
                area += std::numbers::pi * b.radius * b.radius;
                square += dot(b.velocity, b.velocity);
                momentum = momentum + b.mass * b.velocity;
            }
            QVERIFY(std::abs(area / 4 - 0.4) < 1e-12);
            QVERIFY(std::abs(square / count - 1) < 1e-12);
            QVERIFY(norm(momentum) < 1e-10);
        }
    }

    void energyIsKeptOverAMillionCollisions() {
        const Scene scene = gasScene(100);
        const Timeline timeline = summaryOf(scene, 1'000'000);
        const auto end = timeline.stateAt(timeline.endTime());
        const double drift = totals(scene, end).energy / 50 - 1;
        const double depth = deepestOverlap(scene, end) / (2 * scene.bodies[0].radius);
        qInfo("energy drift %.1e, deepest overlap %.1e of a diameter after %.0f s", drift, depth,
              timeline.endTime());
        QCOMPARE(timeline.collisionCount(), std::int64_t(1'000'000));
        QVERIFY(std::abs(drift) < 1e-12);
        QVERIFY(depth < 1e-11);
    }

    // Open, so that no wall takes part: the total momentum stays zero.
    void momentumIsKept() {
        Scene scene = gasScene(1000);
        scene.frame.reset();
        for (Body& b : scene.bodies)
            b.velocity = b.velocity - 2.0 * b.position; // inwards first
        const Totals before = totals(scene, summaryOf(scene, 1, 1e-9).stateAt(0));
        const Timeline timeline = summaryOf(scene, 1'000'000, 1e3);
        const Totals after = totals(scene, timeline.stateAt(timeline.endTime()));
        double sum = 0;
        for (const BodyState& s : timeline.stateAt(timeline.endTime()))
            sum += norm(s.velocity);
        const double lost = norm(after.momentum - before.momentum) / sum;
        qInfo("%lld collisions, |ΔP|/Σ|p| %.1e", static_cast<long long>(timeline.collisionCount()), lost);
        QVERIFY(timeline.collisionCount() > 1000);
        QVERIFY(lost < 1e-13);
    }

    // Henderson's pressure of hard discs, Z = (1 + η²/8)/(1 - η)², from the momentum given in collisions (the
    // virial): Z = 1 + Σ σ |Δp| / (2 E t), E the kinetic energy; away from walls. And Maxwell's speeds.
    void aGasHasThePressureAndSpeedsOfHardDiscs() {
        constexpr int count = 1000;
        constexpr double eta = 0.3;
        const Scene scene = gasScene(count, eta);
        EngineSettings settings = eventSettings(1e3);
        settings.maxCollisions = 120'000;
        const Timeline timeline = runOf(scene, settings);
        const double diameter = 2 * scene.bodies[0].radius;
        const double middle = 0.6; // half the side of the region that counts
        const double from = timeline.endTime() / 6;
        double virial = 0;
        for (const Collision& c : timeline.collisions()) {
            const Vec2d p = (c.steps.first.position + c.steps.second.position) * 0.5;
            if (!c.isWall() && c.time > from && std::abs(p.x) < middle && std::abs(p.y) < middle)
                virial += diameter * c.steps.impulse;
        }
        // The kinetic energy in the region, and the packing there, over time.
        double energy = 0, inside = 0, speeds = 0, squares = 0, fourths = 0;
        constexpr int samples = 300;
        std::vector<BodyState> states;
        for (int k = 0; k < samples; ++k) {
            timeline.stateAt(from + (timeline.endTime() - from) * (k + 0.5) / samples, states);
            for (const BodyState& s : states) {
                const double v2 = dot(s.velocity, s.velocity);
                speeds += std::sqrt(v2) / (samples * count);
                squares += v2 / (samples * count);
                fourths += v2 * v2 / (samples * count);
                if (std::abs(s.position.x) < middle && std::abs(s.position.y) < middle) {
                    energy += v2 / 2 / samples;
                    inside += 1.0 / samples;
                }
            }
        }
        const double there = inside * std::numbers::pi * diameter * diameter / 4 / (4 * middle * middle);
        const double z = 1 + virial / (2 * energy * (timeline.endTime() - from));
        const double henderson = (1 + there * there / 8) / ((1 - there) * (1 - there));
        qInfo("packing %.4f in the middle; Z %.4f, Henderson %.4f; <v>/v_rms %.4f, <v^4>/<v^2>^2 %.3f", there,
              z, henderson, speeds / std::sqrt(squares), fourths / (squares * squares));
        QVERIFY(std::abs(z / henderson - 1) < 0.02);
        QVERIFY(std::abs(speeds / std::sqrt(squares) - std::sqrt(std::numbers::pi) / 2) < 0.005);
        QVERIFY(std::abs(fourths / (squares * squares) - 2) < 0.05);
    }

    void countingPi() {
        for (const SearchKind search : {SearchKind::AllPairs, SearchKind::Cells}) {
            const Timeline timeline = runNextEvent(*builtinScene("pi-4"), eventSettings(1e3), search);
            QCOMPARE(timeline.collisionCount(), std::int64_t(314));
            QCOMPARE(int(timeline.endReason()), int(EndReason::NoMoreCollisions));
        }
    }

    // The break reaches every ball, no two collisions at the same instant.
    void theBreakSpreads() {
        const Scene scene = *builtinScene("break");
        const Timeline timeline = runOf(scene, eventSettings(2));
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            QVERIFY(timeline.segments(i).size() > 1);
        for (const Collision& c : timeline.collisions())
            QCOMPARE(c.group, 0);
        QVERIFY(deepestOverlap(scene, timeline.stateAt(2)) < 1e-13);
    }

    // It used to take a minute and a half before the first collision.
    void aHundredThousandBodiesRun() {
        const Scene scene = gasScene(100'000);
        const Timeline timeline = summaryOf(scene, 100'000);
        QCOMPARE(timeline.collisionCount(), std::int64_t(100'000));
        QVERIFY(std::abs(totals(scene, timeline.stateAt(timeline.endTime())).energy / 50'000 - 1) < 1e-12);
    }

    // Two thousand pairs that meet at the same instant, over and over: no event has to look at all others.
    void aLatticeOfTiesRuns() {
        Scene scene;
        scene.frame = Frame{-0.02, 1.28, -0.02, 1.28, 1};
        for (int k = 0; k < 4096; ++k)
            scene.bodies.push_back(
                disc(k, 1, 0.005, {0.02 * (k % 64), 0.02 * (k / 64)}, {k % 2 ? -1.0 : 1.0, 0}));
        const Timeline timeline = summaryOf(scene, 100'000);
        const auto end = timeline.stateAt(timeline.endTime());
        QCOMPARE(timeline.collisionCount(), std::int64_t(100'000));
        QVERIFY(std::abs(totals(scene, end).energy / 2048 - 1) < 1e-12);
        QVERIFY(deepestOverlap(scene, end) < 1e-13);
    }

    // Times count anew now and then: long after the start, discs still touch as exactly as at first.
    void lateCollisionsAreAsExact() {
        const Scene scene = gasScene(64);
        EngineSettings settings = eventSettings(1e9);
        settings.maxCollisions = 300'000;
        const Timeline timeline = runOf(scene, settings);
        const double diameter = 2 * scene.bodies[0].radius;
        double early = 0, late = 0;
        for (std::size_t k = 0; k < timeline.collisions().size(); ++k) {
            const Collision& c = timeline.collisions()[k];
            if (!c.isWall() && (k < 1000 || k >= 290'000))
                (k < 1000 ? early : late) =
                    std::max(k < 1000 ? early : late, std::abs(c.steps.contact.Z / diameter - 1));
        }
        qInfo("distance at contact off by %.1e of a diameter at first, %.1e after %.0f s", early, late,
              timeline.endTime());
        QVERIFY(late < 20 * early);
    }
};

QTEST_GUILESS_MAIN(TestCrowds)
#include "test_crowds.moc"

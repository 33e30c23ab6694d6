// The stepped engine against a literal transcription of the paper's loop, bit for bit, and its faults shown.
#include "core/engine/engine.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

template <class Real> struct Exchange {
    int step, a, b; // b = -1 to -4: left, right, bottom, top
    Real vax, vay, vbx, vby;
    Real vaxNew, vayNew, vbxNew, vbyNew;
};

// The paper's loop with plain arrays, as one would type it in: step 0 to 4 for each pair that overlaps.
template <class Real> struct PaperLoop {
    static constexpr int most = 16;
    int n = 0;
    Real x[most], y[most], vx[most], vy[most], m[most], r[most];
    Real e = 1, wallE = 1, left = -1e30f, right = 1e30f, bottom = -1e30f, top = 1e30f;
    bool frame = false;
    std::vector<Exchange<Real>> exchanges;

    explicit PaperLoop(const Scene& scene)
        : n(int(scene.bodies.size()))
        , e(Real(scene.restitution)) {
        for (int i = 0; i < n; ++i) {
            const Body& body = scene.bodies[std::size_t(i)];
            x[i] = Real(body.position.x);
            y[i] = Real(body.position.y);
            vx[i] = Real(body.velocity.x);
            vy[i] = Real(body.velocity.y);
            m[i] = Real(body.mass);
            r[i] = Real(body.radius);
        }
        if (!scene.frame)
            return;
        frame = true;
        wallE = Real(scene.frame->restitution);
        left = scene.frame->left ? Real(*scene.frame->left) : left;
        right = scene.frame->right ? Real(*scene.frame->right) : right;
        bottom = scene.frame->bottom ? Real(*scene.frame->bottom) : bottom;
        top = scene.frame->top ? Real(*scene.frame->top) : top;
    }

    void run(int steps, double step, bool approachingOnly) {
        const Real h = Real(step);
        for (int k = 1; k <= steps; ++k) {
            for (int i = 0; i < n; ++i) {
                x[i] = x[i] + vx[i] * h;
                y[i] = y[i] + vy[i] * h;
            }
            for (int i = 0; i < n; ++i)
                for (int j = i + 1; j < n; ++j)
                    pair(k, i, j, approachingOnly);
            for (int i = 0; i < n && frame; ++i)
                walls(k, i, approachingOnly);
            if (atRest()) // sticking can take all there is
                return;
        }
    }

    bool atRest() const {
        for (int i = 0; i < n; ++i)
            if (vx[i] != 0 || vy[i] != 0)
                return false;
        return true;
    }

    void pair(int k, int i, int j, bool approachingOnly) {
        const Real a = x[i] - x[j], b = y[i] - y[j];
        const Real Z = std::sqrt(a * a + b * b);
        if (Z > r[i] + r[j])
            return;
        if (approachingOnly && a * (vx[i] - vx[j]) + b * (vy[i] - vy[j]) >= 0)
            return;
        const Real cosT = Z == 0 ? Real(1) : a / Z, sinT = Z == 0 ? Real(0) : b / Z;
        const Real va = vx[i] * cosT + vy[i] * sinT, ua = vy[i] * cosT - vx[i] * sinT;
        const Real vb = vx[j] * cosT + vy[j] * sinT, ub = vy[j] * cosT - vx[j] * sinT;
        const Real wa = ((m[i] - e * m[j]) * va + (1 + e) * m[j] * vb) / (m[i] + m[j]);
        const Real wb = ((1 + e) * m[i] * va + (m[j] - e * m[i]) * vb) / (m[i] + m[j]);
        Exchange<Real> x1{k, i, j, vx[i], vy[i], vx[j], vy[j], 0, 0, 0, 0};
        vx[i] = wa * cosT - ua * sinT;
        vy[i] = wa * sinT + ua * cosT;
        vx[j] = wb * cosT - ub * sinT;
        vy[j] = wb * sinT + ub * cosT;
        x1.vaxNew = vx[i], x1.vayNew = vy[i], x1.vbxNew = vx[j], x1.vbyNew = vy[j];
        exchanges.push_back(x1);
    }

    void walls(int k, int i, bool approachingOnly) {
        const auto bounce = [&](bool touches, bool towards, Real& v, int side) {
            if (!touches || (approachingOnly && !towards))
                return;
            Exchange<Real> x1{k, i, side, vx[i], vy[i], 0, 0, 0, 0, 0, 0};
            v = -wallE * v;
            x1.vaxNew = vx[i], x1.vayNew = vy[i];
            exchanges.push_back(x1);
        };
        bounce(x[i] - r[i] <= left, vx[i] < 0, vx[i], -1);
        bounce(x[i] + r[i] >= right, vx[i] > 0, vx[i], -2);
        bounce(y[i] - r[i] <= bottom, vy[i] < 0, vy[i], -3);
        bounce(y[i] + r[i] >= top, vy[i] > 0, vy[i], -4);
    }
};

template <class Real> bool sameBits(const Exchange<Real>& x, const Collision& c, double step) {
    const auto& s = c.steps;
    const int b = c.isWall() ? -1 - int(c.side) : c.second;
    return c.time == double(x.step) * step && c.first == x.a && b == x.b &&
           s.before.first == Vec2d{double(x.vax), double(x.vay)} &&
           s.before.second == Vec2d{double(x.vbx), double(x.vby)} &&
           s.after.first == Vec2d{double(x.vaxNew), double(x.vayNew)} &&
           s.after.second == Vec2d{double(x.vbxNew), double(x.vbyNew)};
}

// The number of exchanges compared, or -1 - the number of the first that differs.
template <class Real> int compareRuns(const Scene& scene, double step, double until, bool approachingOnly) {
    PaperLoop<Real> loop(scene);
    EngineSettings settings =
        steppedSettings(until, step, sizeof(Real) == 4 ? Precision::Float : Precision::Double);
    settings.approachingOnly = approachingOnly;
    const Timeline timeline = runOf(scene, settings);
    loop.run(int(std::lround(until / step)), step, approachingOnly);
    const auto collisions = timeline.collisions();
    for (std::size_t k = 0; k < loop.exchanges.size(); ++k)
        if (k >= collisions.size() || !sameBits(loop.exchanges[k], collisions[k], step))
            return -1 - int(k);
    return loop.exchanges.size() == collisions.size() ? int(collisions.size()) : -1 - int(collisions.size());
}

int compareAll(const Scene& scene) {
    int compared = 0;
    for (const double rate : {30.0, 60.0, 240.0, 1000.0}) {
        for (const bool approachingOnly : {false, true}) {
            const int wide = compareRuns<double>(scene, 1 / rate, 3, approachingOnly);
            const int narrow = compareRuns<float>(scene, 1 / rate, 3, approachingOnly);
            if (wide < 0 || narrow < 0)
                return std::min(wide, narrow);
            compared += wide + narrow;
        }
    }
    return compared;
}

Scene facing(double gap, double vA, double vB, double e) {
    Scene scene;
    scene.restitution = e;
    scene.bodies = {disc(0, 1, 0.1, {0, 0}, {vA, 0}), disc(1, 1, 0.1, {0.2 + gap, 0}, {vB, 0})};
    return scene;
}

} // namespace

class TestStepped : public QObject {
    Q_OBJECT

private slots:
    void builtinScenesMatchThePaper_data() {
        QTest::addColumn<QString>("id");
        for (const BuiltinScene& b : builtinScenes())
            if (const Scene scene = b.make(); !scene.lane && scene.bodies.size() < 50)
                QTest::newRow(b.id.data()) << QString::fromUtf8(b.id.data());
    }
    void builtinScenesMatchThePaper() {
        QFETCH(QString, id);
        const int compared = compareAll(*builtinScene(id.toStdString()));
        QVERIFY2(compared > 0, qPrintable(QString("differs at exchange %1").arg(-1 - compared)));
    }

    void randomScenesMatchThePaper() {
        Random random(61);
        int compared = 0;
        for (int k = 0; k < 100; ++k) {
            const double e = k % 4 / 3.0;
            const int same = compareAll(randomScene(random, 2 + random.below(9), e, k % 2, 3));
            QVERIFY2(same >= 0, qPrintable(QString("scene %1, exchange %2").arg(k).arg(-1 - same)));
            compared += same;
        }
        qInfo("%d exchanges equal bit for bit", compared);
        QVERIFY(compared > 100'000);
    }

    // Fault 1: a body faster than its width in a step is never seen to touch.
    void tunnelling() {
        const Scene scene = facing(0.3, 60, 0, 1);
        QCOMPARE(runOf(scene, steppedSettings(1, 1.0 / 30)).collisionCount(), 0);
        QCOMPARE(runOf(scene, eventSettings(1)).collisionCount(), 1);
    }

    // Fault 2: who still overlaps one step later is exchanged back, and the two end up inside each other.
    void doubleExchange() {
        // Apart by less than a step's way at e = 0.5: they part at half the speed that brought them in.
        const Scene scene = facing(0.001, 1, 0, 0.5);
        EngineSettings settings = steppedSettings(0.5, 1.0 / 60);
        const Timeline faulty = runOf(scene, settings);
        QVERIFY(faulty.collisionCount() > 1);
        const Collision& again = faulty.collisions()[1];
        QVERIFY(again.steps.impulse < 0); // a pull
        QCOMPARE(again.steps.contact.Z < 0.2, true);
        settings.approachingOnly = true;
        QCOMPARE(runOf(scene, settings).collisionCount(), 1);
        QCOMPARE(runOf(scene, eventSettings(0.5)).collisionCount(), 1);
    }

    // 3 · 0.1 is more than 0.3: the last step's exchange still belongs to the run.
    void theLastStepIsInTheEnd() {
        Scene scene = facing(0.25, 1, 0, 1);
        const EngineSettings settings = steppedSettings(0.3, 0.1);
        const Timeline t = runOf(scene, settings);
        QCOMPARE(t.collisionCount(), 1);
        QVERIFY(t.collisions()[0].time <= t.endTime());
        QCOMPARE(t.stateAt(t.endTime())[0].velocity, t.collisions()[0].steps.after.first);
        EngineSettings summary = settings;
        summary.keepDetail = false;
        QCOMPARE(runOf(scene, summary).stateAt(0.3), t.stateAt(0.3));
    }

    // Alone on a floor, skid, hook, roll, rest, oil and gutter are what the closed form says, at every step.
    void theFloorIsExact() {
        for (const double spin : {0.0, 35.0}) {
            Throw t;
            t.speed = 3;
            t.spin = spin;
            t.axis = 0.6;
            Scene scene = bowlingScene(t);
            scene.bodies.resize(1);
            scene.lane->left = -50; // no edge, or the step at which it is crossed would show
            scene.friction->rolling = 0.1;
            const Timeline exact = runOf(scene, eventSettings(20));
            QVERIFY(exact.segments(0).size() > 2 && exact.endReason() == EndReason::AtRest);
            for (const double step : {0.7, 1.0 / 60, 1e-3}) {
                const Timeline timeline = runOf(scene, steppedSettings(20, step));
                QCOMPARE(timeline.segments(0).size(), exact.segments(0).size());
                QCOMPARE(timeline.rotations(0).size(), timeline.segments(0).size());
                for (double at = 0; at < exact.endTime() + 1; at += 0.173) {
                    const BodyState a = exact.bodyAt(0, at), b = timeline.bodyAt(0, at);
                    QVERIFY(norm(a.position - b.position) < 1e-11 && norm(a.velocity - b.velocity) < 1e-11);
                    QVERIFY(std::abs(a.spin.x - b.spin.x) < 1e-9 && std::abs(a.spin.y - b.spin.y) < 1e-9);
                    QCOMPARE(b.phase, a.phase);
                }
            }
        }
    }

    // Who comes to rest after the last whole step does not turn back.
    void restsInTheLastPart() {
        Scene scene;
        scene.friction = Friction{0.2, 0.1, 0.4, 10, {}};
        scene.bodies = {{"pin", BodyKind::Pin, 1, 0.1, {0, 0}, {4.2, 0}}}; // at rest after 1.05 s
        const Timeline timeline = runOf(scene, steppedSettings(1.4, 0.5));
        QVERIFY(std::abs(timeline.bodyAt(0, 1.4).position.x - 4.2 * 1.05 / 2) < 1e-14);
        QCOMPARE(timeline.bodyAt(0, 1.4).velocity, (Vec2d{0, 0}));
    }

    // The loop stays the paper's: an overlap is exchanged at the step's end, with the velocities friction
    // left.
    void exchangesOnAFloor() {
        Scene scene;
        scene.friction = Friction{0.2, 0.1, 0.4, 10, {}};
        scene.bodies = {{"a", BodyKind::Pin, 1, 0.1, {0, 0}, {3, 0}},
                        {"b", BodyKind::Pin, 1, 0.1, {0.45, 0}, {0, 0}}};
        const Timeline timeline = runOf(scene, steppedSettings(2, 0.1));
        const Collision& first = timeline.collisions()[0];
        QCOMPARE(first.time, 0.1); // at 0.28 with 2.6 m/s
        QVERIFY(std::abs(first.steps.first.position.x - 0.28) < 1e-15);
        QVERIFY(std::abs(first.steps.before.first.x - 2.6) < 1e-15);
        QVERIFY(std::abs(first.steps.after.second.x - 2.6) < 1e-15);
        // 2.6 m/s in 0.65 s to nothing.
        QVERIFY(std::abs(timeline.bodyAt(1, 2).position.x - (0.45 + 2.6 * 0.65 / 2)) < 1e-14);
    }

    // A pin that flies over the gutter comes back from the plate, a step late at most.
    void kickbacks() {
        Scene scene = bowlingScene({}, 0.75, std::nullopt);
        Body pin = scene.bodies.back();
        pin.position = {0.3, 0.2};
        pin.velocity = {2, 0.3};
        scene.bodies = {pin};
        const Timeline exact = runOf(scene, eventSettings(1));
        const Timeline timeline = runOf(scene, steppedSettings(1, 1e-3));
        QCOMPARE(exact.collisionCount(), 1);
        QCOMPARE(timeline.collisionCount(), 1);
        const double late = timeline.collisions()[0].time - exact.collisions()[0].time;
        QVERIFY(late >= 0 && late < 1e-3);
        QVERIFY(timeline.bodyAt(0, 1).velocity.x == exact.bodyAt(0, 1).velocity.x);
    }

    // Fault 3: a pair in deep overlap stays together, exchanged at every step.
    void sticking() {
        Scene scene = facing(0.001, 1, 0, 0.2);
        const Timeline stuck = runOf(scene, steppedSettings(1, 1.0 / 60));
        QVERIFY(stuck.collisionCount() > 20);
        QVERIFY(deepestOverlap(scene, stuck.stateAt(1)) > 0.001);
        QVERIFY(deepestOverlap(scene, runOf(scene, eventSettings(1)).stateAt(1)) < 0);
    }

    // Where in a step two first overlap is chance, a share f of their way in it; with f > e they overlap
    // still after the next, and are exchanged again. So with short steps a contact is spoilt with the chance
    // 1 - e.
    void aContactIsSpoiltWithTheChanceOneMinusE() {
        constexpr int contacts = 4000;
        for (const double e : {0.25, 0.5, 0.75, 0.9, 1.0}) {
            Random random(27);
            int spoilt = 0;
            for (int k = 0; k < contacts; ++k) {
                Scene scene = facing(random.in(0.01, 0.02), 1, 0, e);
                scene.bodies[1].position.y += random.in(-0.9, 0.9) * 0.1;
                EngineSettings settings = steppedSettings(0.1, 1e-4);
                settings.keepDetail = false;
                settings.maxCollisions = 2;
                spoilt += runOf(scene, settings).collisionCount() > 1;
            }
            const double share = double(spoilt) / contacts, deviation = std::sqrt(e * (1 - e) / contacts);
            QVERIFY2(std::abs(share - (1 - e)) < 4 * deviation + 0.003,
                     qPrintable(QString("e %1: %2 spoilt").arg(e).arg(share)));
        }
    }
};

QTEST_GUILESS_MAIN(TestStepped)
#include "test_stepped.moc"

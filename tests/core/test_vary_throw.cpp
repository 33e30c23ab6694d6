// What changes if: every outcome is the run of that throw, and the present value stands among the values.
#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"
#include "core/study/vary_throw.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace thetalane;

class TestVaryThrow : public QObject {
    Q_OBJECT

private slots:
    void valuesHoldThePresentOne() {
        QCOMPARE(variedValues(0, 4, 5, 2), (std::vector<double>{0, 1, 2, 3, 4}));
        QCOMPARE(variedValues(0, 4, 5, 2.5), (std::vector<double>{0, 1, 2, 2.5, 3, 4}));
        QCOMPARE(variedValues(0, 4, 5, -1), (std::vector<double>{-1, 0, 1, 2, 3, 4}));
        QCOMPARE(variedValues(0, 4, 5, 9), (std::vector<double>{0, 1, 2, 3, 4, 9}));
        const double nearly = std::nextafter(3.0, 4.0);
        const auto values = variedValues(0, 4, 5, nearly);
        QCOMPARE(values.size(), std::size_t(5));
        QVERIFY(values[3] == nearly); // to the last bit: it is that throw
    }

    void quantitiesAreTheThrowsOwn() {
        const Throw t{6, 7, 0.01, -0.2, 30, 0.4};
        const double expected[] = {6, 7, 0.01, -0.2, 30, 0.4};
        for (int q = 0; q < throwQuantities; ++q) {
            QCOMPARE(quantityOf(t, ThrowQuantity(q)), expected[q]);
            const Throw other = withQuantity(t, ThrowQuantity(q), 5.5);
            for (int p = 0; p < throwQuantities; ++p)
                QCOMPARE(quantityOf(other, ThrowQuantity(p)), p == q ? 5.5 : expected[p]);
        }
    }

    void outcomesAreTheRuns_data() {
        QTest::addColumn<int>("quantity");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::newRow("weight") << int(ThrowQuantity::Mass) << 2.7 << 7.26;
        QTest::newRow("speed") << int(ThrowQuantity::Speed) << 5.0 << 11.0;
        QTest::newRow("direction") << int(ThrowQuantity::Direction) << -0.05 << 0.05;
        QTest::newRow("position") << int(ThrowQuantity::Position) << -0.5 << 0.5;
        QTest::newRow("rotation") << int(ThrowQuantity::Spin) << 0.0 << 60.0;
        QTest::newRow("axis") << int(ThrowQuantity::Axis) << -1.5 << 1.5;
    }
    void outcomesAreTheRuns() {
        QFETCH(int, quantity);
        QFETCH(double, from);
        QFETCH(double, to);
        VarySettings s;
        s.base.spin = 30;
        s.base.axis = 0.5;
        s.standing = PinSet(0b1011011111);
        s.quantity = ThrowQuantity(quantity);
        s.values = variedValues(from, to, 9, quantityOf(s.base, s.quantity));
        int told = 0;
        const auto all = varyThrow(s, [&](const VariedThrow&) { ++told; });
        QCOMPARE(all.size(), s.values.size());
        QCOMPARE(told, int(all.size()));
        for (std::size_t k = 0; k < all.size(); ++k) {
            const VariedThrow& v = all[k];
            QCOMPARE(v.value, s.values[k]);
            QVERIFY(v.possible);
            const Scene scene = bowlingScene(v.ballThrow, s.lane.restitution, s.lane.friction, s.standing);
            const Run run = std::get<Run>(simulate(scene, {}));
            PinSet left = s.standing;
            for (const int body : pinsDown(scene, run.timeline, run.timeline.endTime()))
                left.reset(std::size_t(std::stoi(scene.bodies[std::size_t(body)].id) - 1));
            QCOMPARE(v.left, left);
            QCOMPARE(v.pinsDown, int(s.standing.count() - left.count()));
            QCOMPARE(v.entry, entryOf(v.ballThrow, s.lane.friction));
            // Where the ball is at its first contact tells which pin it was: the one it touches there.
            std::optional<int> first;
            for (const Collision& c : run.timeline.collisions())
                if (!first && c.involves(0) && !c.isWall()) {
                    const BodyState ball = run.timeline.bodyAt(0, c.time);
                    for (int pin = 1; pin <= 10; ++pin)
                        if (s.standing[std::size_t(pin - 1)] &&
                            std::abs(norm(ball.position - pinPositions()[std::size_t(pin - 1)]) -
                                     regulation::ballRadius - regulation::pinRadius) < 1e-9)
                            first = pin;
                }
            QCOMPARE(v.firstPin, first);
        }
    }

    void theImpossibleIsSaid() {
        VarySettings s;
        s.quantity = ThrowQuantity::Mass;
        s.values = {-1, 0, 5, 8};
        const auto all = varyThrow(s);
        QVERIFY(!all[0].possible && !all[1].possible && all[2].possible && !all[3].possible);
        QVERIFY(!outcomeOf({.speed = -1}, allPins, {}).possible);
        QVERIFY(!outcomeOf({.speed = 101}, allPins, {}).possible);
        QVERIFY(!all[0].clears());
    }

    void stoppedItKeepsWhatThereIs() {
        VarySettings s;
        s.values = {6, 7, 8, 9};
        std::stop_source source;
        int told = 0;
        const auto some = varyThrow(
            s,
            [&](const VariedThrow&) {
                if (++told == 2)
                    source.request_stop();
            },
            source.get_token());
        QCOMPARE(some.size(), std::size_t(2));
    }
};

QTEST_GUILESS_MAIN(TestVaryThrow)
#include "test_vary_throw.moc"

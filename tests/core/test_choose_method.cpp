// The choice by measurement: the cheapest that is good enough, and what is said about it.
#include "core/scene/builtin.h"
#include "core/study/choose_method.h"
#include "core/study/compare_runs.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace thetalane;

class TestChooseMethod : public QObject {
    Q_OBJECT

private slots:
    void theCheapestThatIsGoodEnough_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("rack, a tenth of a millimetre") << "rack" << 1e-4;
        QTest::newRow("rack, a nanometre") << "rack" << 1e-9;
        QTest::newRow("bowling, a millimetre") << "bowling" << 1e-3;
        QTest::newRow("two balls, a metre") << "two-balls" << 1.0;
    }
    void theCheapestThatIsGoodEnough() {
        QFETCH(QString, scene);
        QFETCH(double, tolerance);
        const Scene s = *builtinScene(scene.toStdString());
        const auto choice = chooseMethod(s, tolerance, 3);
        QVERIFY(choice.has_value() && choice->met);
        QCOMPARE(choice->until, 3.0);
        QVERIFY(choice->tried.size() > 10);
        double last = 0;
        bool found = false;
        for (const TriedMethod& t : choice->tried) {
            QVERIFY(t.cost >= last); // from the cheapest to the dearest
            last = t.cost;
            QVERIFY(t.tooSlow || t.within == (t.error <= tolerance));
            if (t.within && !found) {
                QVERIFY(t.method == choice->method);
                found = true;
            }
        }
        // And it keeps the promise.
        const Run truth = std::get<Run>(runMethod(referenceMethod(), s, 3));
        const Run run = std::get<Run>(runMethod(choice->method, s, 3));
        QVERIFY(compareRuns(truth, run, 3).furthest <= tolerance);
    }

    void floatIsNotEnoughForANanometre() {
        const auto choice = chooseMethod(*builtinScene("rack"), 1e-9, 2);
        QVERIFY(choice->method.settings.precision == Precision::Double);
        for (const TriedMethod& t : choice->tried)
            QVERIFY(t.method.settings.precision != Precision::Float || !t.within);
    }

    void whatNothingReachesIsSaid() {
        const auto choice = chooseMethod(*builtinScene("break"), 1e-30, 2);
        QVERIFY(choice && !choice->met);
        for (const TriedMethod& t : choice->tried) {
            QVERIFY(!t.within);
            if (t.method == choice->method)
                for (const TriedMethod& other : choice->tried)
                    QVERIFY(t.error <= other.error);
        }
    }

    // 10,000 bodies for 10 s would take minutes: it measures a part, and says which.
    void aCrowdIsMeasuredInPart() {
        const auto choice = chooseMethod(*builtinScene("gas-10000"), 1e-3, 10, 0.5);
        QVERIFY(choice->until > 0 && choice->until < 10);
        QCOMPARE(choice->untilAsked, 10.0);
        QCOMPARE(choice->reference, Precision::Double);
        QVERIFY(choice->tried.size() >= 2);
        QVERIFY2(choice->seconds < 60, qPrintable(QString::number(choice->seconds)));
        for (const TriedMethod& t : choice->tried)
            QVERIFY(t.within == (t.error <= 1e-3 * roomToGrow));
    }

    void nonsenseIsNotMeasured() {
        const Scene rack = *builtinScene("rack");
        const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
        for (const double bad : {0.0, -1.0, nan, infinite}) {
            QVERIFY(!chooseMethod(rack, bad, 2));
            QVERIFY(!chooseMethod(rack, 1e-3, bad));
        }
        QVERIFY(!chooseMethod(Scene(), 1e-3, 1));
    }

    void itCanBeStopped() {
        std::stop_source stop;
        stop.request_stop();
        const auto choice = chooseMethod(*builtinScene("rack"), 1e-3, 2, 2, stop.get_token());
        QVERIFY(choice && choice->tried.empty() && !choice->met);
    }
};

QTEST_GUILESS_MAIN(TestChooseMethod)
#include "test_choose_method.moc"

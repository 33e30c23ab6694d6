// "Digits left" against what a float, a double and a 113-bit run of the same throw have in common.
#include "core/scene/builtin.h"
#include "core/study/digits_left.h"
#include "core/study/method.h"
#include "core/study/study_cases.h"

#include <QTest>

#include <cmath>

using namespace thetalane;

namespace {

Run runOf(const Method& method, const Scene& scene, double until) {
    return std::get<Run>(runMethod(method, scene, until));
}

int throwCount() {
    bool given = false;
    const int count = qEnvironmentVariableIntValue("THETALANE_DIGITS_THROWS", &given);
    return given && count > 0 ? count : 250; // 1000 take four times as long
}

} // namespace

class TestDigitsLeft : public QObject {
    Q_OBJECT

private slots:
    // The promise: within one digit on at least 95 % of the collisions.
    void isRightWithinADigit_data() {
        QTest::addColumn<int>("precision");
        QTest::addRow("float") << int(Precision::Float);
        QTest::addRow("double") << int(Precision::Double);
    }
    void isRightWithinADigit() {
        QFETCH(int, precision);
        int within = 0, total = 0;
        double bias = 0;
        for (const Scene& scene : rackThrows(throwCount(), 77).scenes) {
            const Run truth = runOf(referenceMethod(), scene, 2);
            const Run run = runOf(eventMethod(Precision(precision)), scene, 2);
            const auto said = digitsLeft(run), found = digitsInCommon(truth, run);
            QCOMPARE(said.size(), run.timeline.collisions().size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                within += std::abs(said[k] - found[k]) <= 1;
                bias += said[k] - found[k];
                ++total;
            }
        }
        qInfo("%d of %d collisions (%.2f %%), %.2f digits too many on average", within, total,
              100.0 * within / total, bias / total);
        QVERIFY(total > 8 * throwCount());
        QVERIFY(within >= 0.95 * total);
        QVERIFY(std::abs(bias / total) < 0.3);
    }

    // Elastic balls in a frame, until nothing is left: chaos takes a double's digits, and then there are
    // none.
    void chaosTakesAllOfThem() {
        const Scene scene = *builtinScene("gas-100");
        const Run run = runOf(eventMethod(), scene, 4);
        const auto digits = digitsLeft(run);
        QVERIFY(digits.size() > 500);
        QVERIFY(digits.front() > 14);
        QCOMPARE(digits.back(), 0.0);
        for (const double d : digits)
            QVERIFY(d >= 0 && d < 16);
        // The quad run has more, and its collisions part from the double's where those have none left.
        const Run truth = runOf(referenceMethod(), scene, 0.3);
        const auto found = digitsInCommon(truth, run);
        int wrong = 0;
        for (std::size_t k = 0; k < found.size(); ++k)
            wrong += std::abs(found[k] - digits[k]) > 1.5;
        QVERIFY2(wrong <= 0.1 * double(found.size()),
                 qPrintable(QString("%1 of %2").arg(wrong).arg(found.size())));
    }

    void moreBitsLeaveMoreDigits() {
        const Scene scene = *builtinScene("rack");
        const auto few = digitsLeft(runOf(eventMethod(Precision::Float), scene, 2));
        const auto some = digitsLeft(runOf(eventMethod(), scene, 2));
        const auto many = digitsLeft(runOf(referenceMethod(), scene, 2));
        QCOMPARE(few.size(), some.size());
        QCOMPARE(many.size(), some.size());
        for (std::size_t k = 0; k < some.size(); ++k) {
            QVERIFY(few[k] <= 7.3 && some[k] <= 16 && many[k] <= 34.1);
            QVERIFY(std::abs(many[k] - some[k] - 60 * std::log10(2)) < 1.0); // 113 bits less 53
        }
    }

    // A ball to and fro between two walls loses no more than its roundings add up to.
    void orderLosesLittle() {
        Scene scene;
        scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {0, 0}, {1, 0.3}}};
        scene.frame = Frame{-1, 1, -1, 1, 1};
        const auto digits = digitsLeft(runOf(eventMethod(), scene, 200));
        QVERIFY(digits.size() > 100);
        QVERIFY(digits.back() > 13);
    }

    void nothingIsSaidWhereNothingIsKnown() {
        QVERIFY(digitsLeft(runOf(eventMethod(), *builtinScene("bowling"), 5)).empty());
        QVERIFY(digitsLeft(runOf(steppedMethod(0.01, true), *builtinScene("rack"), 1)).empty());
        QVERIFY(digitsLeft(runOf(eventMethod(), *builtinScene("head-on"), 0.1)).empty()); // nothing happens
    }

    void aDifferentPairHasNothingInCommon() {
        const Run a = runOf(eventMethod(), rackThrows(2, 1).scenes[0], 2);
        const Run b = runOf(eventMethod(), rackThrows(2, 1).scenes[1], 2);
        const auto same = digitsInCommon(a, a), other = digitsInCommon(a, b);
        for (const double d : same)
            QVERIFY(d > 15.9);
        for (const double d : other)
            QVERIFY(d < 5);
    }
};

QTEST_GUILESS_MAIN(TestDigitsLeft)
#include "test_digits_left.moc"

// Numbers, formulas in one line, and the worked steps of collisions whose every number is known by hand.
#include "ui/words/formula.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace thetalane;

namespace {

Scene pair(double e) {
    Scene s;
    s.restitution = e;
    s.bodies = {{"A", BodyKind::Ball, 2, 0.3, {0.3, 0.4}, {-1, 0}},
                {"pin 3", BodyKind::Pin, 1, 0.2, {0, 0}, {0, 1}}};
    return s;
}

Disc<double> disc(const Body& b) {
    return {b.mass, b.radius, b.position, b.velocity};
}

// The 3-4-5 triangle: cos θ = 0.6, sin θ = 0.8.
Collision meeting(const Scene& s) {
    Collision c;
    c.second = 1;
    c.steps = collide(disc(s.bodies[0]), disc(s.bodies[1]), s.restitution);
    return c;
}

double value(const Formula& result) {
    for (const Formula& part : result.parts)
        if (part.kind == Formula::Kind::Number)
            return part.exact.toDouble();
    return result.kind == Formula::Kind::Number ? result.exact.toDouble() : std::nan("");
}

double valueOf(const std::vector<WorkedStep>& steps, Stage stage, const QString& left) {
    for (const WorkedLine& line : steps[std::size_t(stage)].lines)
        if (plainText(line.left) == left)
            return value(line.result);
    return std::nan("");
}

} // namespace

class TestWords : public QObject {
    Q_OBJECT

private slots:
    void numbers_data() {
        QTest::addColumn<double>("number");
        QTest::addColumn<QString>("text");
        const auto row = [](double number, const char* text) {
            QTest::newRow(qPrintable(QString::number(number, 'g', 17) + text))
                << number << QString::fromUtf8(text);
        };
        row(0, "0");
        row(-0.0, "0");
        row(0.5, "0.5");
        row(2, "2");
        row(1.25, "1.25");
        row(-6.8, "−6.8");
        row(1.0 / 3, "0.3333");
        row(2.0 / 3, "0.6667");
        row(0.1 + 0.2, "0.3000");
        row(0.15623, "0.1562");
        row(12.296, "12.30");
        row(9.99996, "10.00");
        row(123456, "123456");
        row(12345.6, "12346");
        row(999999.7, "1.000·10⁶");
        row(1e6, "1·10⁶");
        row(6.02214e23, "6.022·10²³");
        row(0.0001, "0.0001");
        row(-3.2001e-5, "−3.200·10⁻⁵");
        row(3.2e-5, "3.2·10⁻⁵");
        row(0.00009999999, "0.0001000");
        row(5e-324, "5·10⁻³²⁴");
        row(1.7976931348623157e308, "1.798·10³⁰⁸");
        row(std::numeric_limits<double>::quiet_NaN(), "—");
        row(-HUGE_VAL, "−∞");
    }

    void numbers() {
        QFETCH(double, number);
        QFETCH(QString, text);
        QCOMPARE(numberText(number), text);
    }

    void allDigitsReadBack() {
        for (const double number : {0.1, 1.0 / 3, -2.2250738585072014e-308, 1e21, 0.30000000000000004}) {
            QCOMPARE(exactText(number).toDouble(), number);
            QVERIFY(!exactText(number).contains("−"));
        }
        QCOMPARE(exactText(-0.0), QString("0"));
        QCOMPARE(exactText(0.1), QString("0.1"));
    }

    void oneLine_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        const auto check = [](const Formula& f, const char* expected) {
            QTest::newRow(expected) << plainText(f) << QString::fromUtf8(expected);
        };
        const auto square = [](Formula f) { return script(std::move(f), {}, upright("2")); };
        const auto m = [](const char* id) { return script(symbol("m"), upright(id)); };
        check(row({symbol("Z"), op("="), root(row({square(symbol("a")), op("+"), square(symbol("b"))}))}),
              "Z = √(a² + b²)");
        check(fraction(row({m("A"), op("−"), symbol("e"), m("B")}), row({m("A"), op("+"), m("B")})),
              "(m_A − e·m_B)/(m_A + m_B)");
        check(fraction(row({m("A"), m("B")}), row({m("A"), op("+"), m("B")})), "m_A·m_B/(m_A + m_B)");
        check(script(symbol("v"), row({upright("A"), symbol("x′")}), symbol("′")), "v′_Ax′");
        check(row({symbol("v"), upright("cos"), symbol("θ")}), "v cos θ");
        check(row({number(2), op("·"), signedFactor(-0.5)}), "2·(−0.5)");
        check(row({op("−"), symbol("e"), symbol("v")}), "−e·v");
        check(row({op("−"), fraction(symbol("a"), symbol("b"))}), "−a/b");
        check(row({fraction(number(1), number(2)), symbol("μ")}), "½·μ");
        check(square(signedFactor(-0.25)), "(−0.25)²");
        check(fraction(number(-1), number(-2)), "−1/(−2)");
        check(row({number(53.13010235), upright("°")}), "53.13°");
        check(row({number(1e-7), upright("m/s")}), "1·10⁻⁷ m/s");
        check({}, "");
    }

    void oneLine() {
        QFETCH(QString, text);
        QFETCH(QString, expected);
        QCOMPARE(text, expected);
    }

    void allDigitsInOneLine() {
        QCOMPARE(plainText(row({number(1.0 / 3), upright("m")}), Digits::All),
                 QString("0.3333333333333333 m"));
    }

    void knownCollision_data() {
        QTest::addColumn<int>("stage");
        QTest::addColumn<QString>("left");
        QTest::addColumn<double>("expected");
        const auto row = [](Stage stage, const char* left, double expected) {
            QTest::newRow(left) << int(stage) << QString::fromUtf8(left) << expected;
        };
        row(Stage::Contact, "a", 0.3);
        row(Stage::Contact, "b", 0.4);
        row(Stage::Contact, "Z", 0.5);
        row(Stage::Contact, "r_A + r_pin 3", 0.5);
        row(Stage::Contact, "cos θ", 0.6);
        row(Stage::Contact, "sin θ", 0.8);
        row(Stage::Contact, "θ", 53.13010235415598);
        row(Stage::Split, "v_A", 1);
        row(Stage::Split, "φ_A", 180);
        row(Stage::Split, "v_pin 3,y", 1);
        row(Stage::Rotation, "v_Ax′", -0.6);
        row(Stage::Rotation, "v_Ay′", 0.8);
        row(Stage::Rotation, "v_pin 3,x′", 0.8);
        row(Stage::Rotation, "v_pin 3,y′", 0.6);
        row(Stage::Exchange, "v′_Ax′", 0.1);
        row(Stage::Exchange, "v′_pin 3,x′", -0.6);
        row(Stage::Exchange, "v′_Ay′", 0.8);
        row(Stage::Exchange, "v′_pin 3,y′", 0.6);
        row(Stage::RotationBack, "v′_Ax", -0.58);
        row(Stage::RotationBack, "v′_Ay", 0.56);
        row(Stage::RotationBack, "v′_pin 3,x", -0.84);
        row(Stage::RotationBack, "v′_pin 3,y", -0.12);
        row(Stage::Check, "p_x", -2);
        row(Stage::Check, "p′_x", -2);
        row(Stage::Check, "p′_y", 1);
        row(Stage::Check, "p′_x − p_x", 0);
        row(Stage::Check, "e", 0.5);
        row(Stage::Check, "I", 1.4);
        row(Stage::Check, "E", 1.5);
        row(Stage::Check, "E′", 1.01);
        row(Stage::Check, "E − E′", 0.49);
    }

    void knownCollision() {
        QFETCH(int, stage);
        QFETCH(QString, left);
        QFETCH(double, expected);
        const Scene s = pair(0.5);
        const double shown = valueOf(workedSteps(s, meeting(s)), Stage(stage), left);
        QVERIFY2(std::abs(shown - expected) < 1e-12, qPrintable(QString::number(shown)));
    }

    void substitutedNumbersAreTheEngines() {
        const Scene s = pair(0.5);
        const auto steps = workedSteps(s, meeting(s));
        QCOMPARE(plainText(steps[0].lines[2]), QString("Z = √(a² + b²) = √(0.3² + 0.4²) = 0.5 m"));
        QCOMPARE(plainText(steps[2].lines[0]),
                 QString("v_Ax′ = v_Ax·cos θ + v_Ay·sin θ = −1·0.6 + 0·0.8 = −0.6 m/s"));
        const QString exchange = plainText(steps[3].lines[0]);
        QVERIFY2(exchange.startsWith(
                     "v′_Ax′ = ((m_A − e·m_pin 3)·v_Ax′ + (1 + e)·m_pin 3·v_pin 3,x′)/(m_A + m_pin 3) = "
                     "((2 − 0.5·1)·(−0.6) + (1 + 0.5)·1·0.8"),
                 qPrintable(exchange));
    }

    void wall() {
        Scene s = pair(1);
        Collision c;
        c.second = -1;
        c.side = Side::Left;
        const Disc<double> d{2, 0.25, {0.25, 1}, {-3, 0.5}};
        c.steps = collideWithWall(d, Vec2d{0, 1}, Contact<double>{0.25, 0, 0.25, 1, 0}, 0.5);
        const auto steps = workedSteps(s, c);
        QCOMPARE(plainText(steps[3].lines[0]), QString("v′_Ax′ = −e·v_Ax′ = −0.5·(−3) = 1.5 m/s"));
        QCOMPARE(plainText(steps[3].lines[1]), QString("v′_Ay′ = v_Ay′ = 0.5 m/s"));
        QCOMPARE(valueOf(steps, Stage::Check, "I"), 9.0);
        QCOMPARE(valueOf(steps, Stage::Check, "E − E′"), 6.75);
        for (const WorkedStep& step : steps)
            for (const WorkedLine& line : step.lines)
                QVERIFY2(!plainText(line).contains("∞") && !plainText(line).contains("pin"),
                         qPrintable(plainText(line)));
    }

    // e = 0, a pair that was parting (the paper's loop), and centres that coincide.
    void unusualCollisionsRead() {
        const Scene stuck = pair(0);
        const auto together = workedSteps(stuck, meeting(stuck));
        QVERIFY(together[3].sentence.contains("e = 0"));
        Scene parting = pair(0.5);
        std::swap(parting.bodies[0].velocity, parting.bodies[1].velocity);
        QVERIFY(workedSteps(parting, meeting(parting))[3].sentence.contains("moving apart"));
        Scene same = pair(1);
        same.bodies[0].position = {};
        const auto steps = workedSteps(same, meeting(same));
        QCOMPARE(valueOf(steps, Stage::Contact, "θ"), 0.0);
        for (const WorkedStep& step : steps)
            for (const WorkedLine& line : step.lines)
                QVERIFY2(!plainText(line).contains("—"), qPrintable(plainText(line)));
    }

    void everyStepIsWhole() {
        const Scene s = pair(0.75);
        const auto steps = workedSteps(s, meeting(s));
        QCOMPARE(int(steps.size()), stageCount);
        for (int i = 0; i < stageCount; ++i) {
            const WorkedStep& step = steps[std::size_t(i)];
            QCOMPARE(int(step.stage), i);
            QCOMPARE(step.title, stageTitle(Stage(i)));
            QVERIFY(step.sentence.endsWith("."));
            QVERIFY(step.key < step.lines.size());
        }
    }
};

QTEST_APPLESS_MAIN(TestWords)
#include "test_words.moc"

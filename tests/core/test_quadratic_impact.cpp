// The time of impact of two discs in quadratic motion, against roots with 100 digits by Sturm's theorem.
//
// How a case is judged: t is right if it is the exact answer for some sum of radii within ±tolerance·ε·scale
// of the given one (scale: the lengths that were added up, |Δp| + |Δv|t + ½|Δa|t² + reach) and some noise
// between none and four times the noise rule's. An answer of another kind than the exact one (an impact
// instead of none, or the other way round) that passes so is counted as decided within rounding; every other
// is missed or false.
#include "core/math/quad.h"
#include "core/motion/quadratic_impact.h"
#include "tests/core/impact_cases.h"
#include "tests/core/sturm.h"

#include <QTest>

#include <cstdio>
#include <cstring>
#include <string>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

constexpr double tolerance = 8; // roundings
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

double timeFor(const ImpactCase& c) {
    return timeToImpact<double>(c.p, c.v, c.a, c.reach, c.speed2, c.horizon);
}

double scaleOf(const ImpactCase& c, double t) {
    return norm(c.p) + norm(c.v) * t + norm(c.a) * t * t / 2 + c.reach;
}

// The motion in 100 digits; `reach` and `noise` (approach × reach) as asked.
class Exact {
public:
    Exact(const ImpactCase& c, const Hundred& reach, const Hundred& noise)
        : m_horizon(c.horizon) {
        const Hundred px(c.p.x), py(c.p.y), vx(c.v.x), vy(c.v.y), ax(c.a.x), ay(c.a.y);
        const Hundred pp = px * px + py * py, pv = px * vx + py * vy, pa = px * ax + py * ay,
                      vv = vx * vx + vy * vy, va = vx * ax + vy * ay, aa = ax * ax + ay * ay;
        m_gap = {Hundred(pp - reach * reach), Hundred(2 * pv), Hundred(vv + pa), va, Hundred(aa / 4)};
        m_rate = {Hundred(pv + noise), Hundred(vv + pa), Hundred(3 * va / 2), Hundred(aa / 2)};
    }

    Hundred gap(const Hundred& t) const { return valueOf(m_gap, t); }

    std::optional<Hundred> firstImpact() const {
        // Apart now: where the gap first changes its sign they approach, and without noise that is all.
        if (m_gap[0] > 0 && m_rate[0] == m_gap[1] / 2)
            return Sturm(m_gap).firstChange(0, m_horizon);
        const Sturm rate(m_rate);
        const Hundred beyond = m_horizon * 2;
        Hundred from = 0;
        while (from < m_horizon) {
            const auto next = rate.firstChange(from, beyond);
            const Hundred to = next && *next < m_horizon ? *next : m_horizon;
            if (valueOf(m_rate, (from + to) / 2) < 0) {
                if (gap(from) <= 0)
                    return from;
                if (gap(to) < 0)
                    return Sturm(m_gap).firstChange(from, to);
            }
            // Past this zero, whose last digits are not known.
            from = to * (1 + Hundred("1e-45"));
        }
        return {};
    }

private:
    Hundred m_horizon;
    Polynomial m_gap, m_rate;
};

bool acceptable(const ImpactCase& c, double t, double toleranceHere) {
    const double at = t < infinite ? t : c.horizon;
    const Hundred slack = Hundred(toleranceHere * epsilon) * scaleOf(c, at);
    const double noise = 4 * approachNoise<double>() * std::sqrt(c.speed2 + norm(c.a) * c.reach) * c.reach;
    const auto early = Exact(c, c.reach + slack, 0).firstImpact();
    const auto late = Exact(c, std::max(Hundred(0), Hundred(c.reach - slack)), noise).firstImpact();
    const Hundred one = 1, little = 4 * epsilon;
    if (t == infinite)
        return !late;
    return early && t >= *early * (one - little) && (!late || t <= *late * (one + little) + 1e-300);
}

struct Tally {
    int cases = 0, impacts = 0, missed = 0, falsely = 0, wrong = 0, rounding = 0;
    double time = 0;  // worst |t - exact| / exact, where the approach is at least a thousandth of the speed
    double moved = 0; // worst |t - exact| × approach, in roundings of the scale
    double gap = 0;   // worst |gap at t|, in roundings of the scale; of those apart at first
};

std::string describe(const ImpactCase& c, double t, const std::optional<Hundred>& exact) {
    char text[400];
    std::snprintf(text, sizeof text,
                  "t %.17g, exact %.17g: p {%a, %a} v {%a, %a} a {%a, %a} reach %a speed2 %a horizon %a", t,
                  exact ? exact->convert_to<double>() : infinite, c.p.x, c.p.y, c.v.x, c.v.y, c.a.x, c.a.y,
                  c.reach, c.speed2, c.horizon);
    return text;
}

void judge(const ImpactCase& c, Tally& tally) {
    const double t = timeFor(c);
    const auto exact = Exact(c, c.reach, 0).firstImpact();
    ++tally.cases;
    tally.impacts += exact.has_value();
    if (!exact && t == infinite)
        return;
    bool fine = exact && t < infinite;
    if (fine) {
        const Vec2d p = c.p + (c.v + c.a * (t / 2)) * t, v = c.v + c.a * t;
        const double approach = std::abs(dot(p, v)) / norm(p), rounding = epsilon * scaleOf(c, t);
        const double late = Hundred(abs(t - *exact)).convert_to<double>();
        const double exactly = exact->convert_to<double>();
        const double gap = Hundred(Exact(c, c.reach, 0).gap(t) / (2 * c.reach)).convert_to<double>();
        fine = late * approach <= tolerance * rounding && std::abs(gap) <= tolerance * rounding;
        if (fine) {
            tally.moved = std::max(tally.moved, late * approach / rounding);
            if (Exact(c, c.reach, 0).gap(0) > 0)
                tally.gap = std::max(tally.gap, std::abs(gap) / rounding);
            if (exactly > 0 && approach * exactly > 1e-3 * scaleOf(c, t))
                tally.time = std::max(tally.time, late / exactly);
            return;
        }
    }
    if (acceptable(c, t, tolerance)) {
        tally.rounding += exact.has_value() != (t < infinite);
        return;
    }
    (t == infinite ? tally.missed : exact ? tally.wrong : tally.falsely) += 1;
    if (tally.missed + tally.wrong + tally.falsely <= 3)
        qWarning("%s", describe(c, t, exact).c_str());
}

bool sameBits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

class TestQuadraticImpact : public QObject {
    Q_OBJECT

private slots:
    void hundredThousandCases();
    void withoutAccelerationTheVeryBits();
    void everyDegree();
    void grazingExactly();
    void touching();
    void veryShortAndVeryLong();
    void floatsAndQuads();
};

void TestQuadraticImpact::hundredThousandCases() {
    constexpr int each = 15'000;
    int cases = 0, bad = 0;
    qInfo("| category | cases | impacts | missed | false | wrong root | within rounding | time, relative | "
          "time × approach, ε scale | gap, ε scale |");
    for (const ImpactCategory& category : impactCategories()) {
        Random random(20260 + std::uint64_t(cases));
        Tally tally;
        for (int k = 0; k < each; ++k)
            judge(category.make(random), tally);
        qInfo("| %s | %d | %d | %d | %d | %d | %d | %.2g | %.2g | %.2g |", category.name, tally.cases,
              tally.impacts, tally.missed, tally.falsely, tally.wrong, tally.rounding, tally.time,
              tally.moved, tally.gap);
        cases += tally.cases;
        bad += tally.missed + tally.falsely + tally.wrong;
        QVERIFY2(tally.impacts > each / 10 && tally.impacts < each, category.name);
    }
    QVERIFY(cases >= 100'000);
    QCOMPARE(bad, 0);
}

void TestQuadraticImpact::withoutAccelerationTheVeryBits() {
    Random random(7);
    int met = 0;
    for (const ImpactCategory& category : impactCategories())
        for (int k = 0; k < 20'000; ++k) {
            ImpactCase c = category.make(random);
            c.a = {};
            const double free = timeToImpact<double>(c.p, c.v, c.reach, c.speed2);
            const double t = timeFor(c);
            met += free <= c.horizon;
            QVERIFY(sameBits(t, free <= c.horizon ? free : infinite));
        }
    QVERIFY(met > 10'000);
}

// Hand-made, with exact answers.
void TestQuadraticImpact::everyDegree() {
    const auto t = [](Vec2d p, Vec2d v, Vec2d a, double reach, double horizon = 100) {
        return timeToImpact<double>(p, v, a, reach, dot(v, v), horizon);
    };
    // Along one line: 5 - 2t - t²·½·2 = 1 has t = -1 + √5; with the acceleration alone, t = 2.
    QVERIFY(std::abs(t({5, 0}, {-2, 0}, {-2, 0}, 1) - (std::sqrt(5.0) - 1)) < 1e-15);
    QVERIFY(std::abs(t({5, 0}, {0, 0}, {-2, 0}, 1) - 2) < 1e-15);
    // Slowed: 5 - 4t + ½·2·t² = 1 is a double root at the reach (they stop as they touch); at reach 2, t = 1.
    QCOMPARE(t({5, 0}, {-4, 0}, {2, 0}, 2), 1.0);
    QCOMPARE(t({6, 0}, {-4, 0}, {2, 0}, 1), infinite);
    // It leaves, turns, and comes back: 2 + 2t - t² = 1.
    QVERIFY(std::abs(t({2, 0}, {2, 0}, {-2, 0}, 1) - (1 + std::sqrt(2.0))) < 1e-15);
    // An acceleration that is next to nothing.
    for (const double a : {1e-300, 1e-150, 1e-30, 1e-17})
        QVERIFY(std::abs(t({5, 0}, {-2, 0}, {a, a}, 1) - 2) < 1e-15);
    QCOMPARE(t({5, 0}, {-2, 0}, {0, 0}, 1, 1.9), infinite);
    QCOMPARE(t({5, 0}, {-2, 0}, {1e-9, 0}, 1, 1.9), infinite);
    // Without a horizon, and a far one.
    QVERIFY(std::abs(t({5, 0}, {0, 0}, {-2, 0}, 1, infinite) - 2) < 1e-15);
    QVERIFY(std::abs(t({5, 0}, {0, 0}, {-2, 0}, 1, 1e200) - 2) < 1e-15);
    QCOMPARE(t({5, 0}, {1, 3}, {2, 1}, 1, infinite), infinite);
    // Coincident centres neither approach nor part.
    QCOMPARE(t({0, 0}, {1, 0}, {1, 0}, 1), infinite);
}

// y = 1 + (t - 1)²: it touches the disc of reach 1 at t = 1 and gives no impulse; a little lower, it does.
void TestQuadraticImpact::grazingExactly() {
    const Vec2d p{-2, 2}, v{2, -2}, a{0, 2};
    QCOMPARE(timeToImpact<double>(p, v, a, 1, 8, 10), infinite);
    QCOMPARE(timeToImpact<double>(p, v, a, 1 - 1e-15, 8, 10), infinite);
    const double t = timeToImpact<double>(p, v, a, 1 + 1e-9, 8, 10);
    QVERIFY(t < 1 && t > 0.999);
    // Along a line, to a stop at the touch: nothing; beyond it: an impact at the exact root.
    QCOMPARE(timeToImpact<double>({2, 0}, {-2, 0}, {2, 0}, 1, 4, 10), infinite);
    const double in = timeToImpact<double>({2, 0}, {-2, 0}, {2, 0}, 1 + 0x1p-20, 4, 10);
    QCOMPARE(in, 1 - 0x1p-10);
}

void TestQuadraticImpact::touching() {
    const auto t = [](Vec2d v, Vec2d a) { return timeToImpact<double>({1, 0}, v, a, 1, 2, 10); };
    QCOMPARE(t({-1, 0}, {3, 0}), 0.0);     // they approach
    QCOMPARE(t({1, 0}, {1, 0}), infinite); // they part
    QCOMPARE(t({1, 0}, {-2, 0}), 1.0);     // they part and come back
    QCOMPARE(t({0, 0}, {1, 0}), infinite); // about to part
    // About to approach: as soon as the approach is more than the velocities' rounding.
    const double pressed = t({0, 0}, {-1, 0});
    QVERIFY(pressed > 0 && pressed < 1e-13);
    QVERIFY(pressed > approachNoise<double>() * std::sqrt(2.0));
    // Their approach is rounding and they are slowed: no impulse to give.
    QCOMPARE(t({-1e-17, 0}, {1, 0}), infinite);
    // Deep in each other, they approach; they part.
    QCOMPARE(timeToImpact<double>({0.2, 0}, {-1, 0}, {1, 0}, 1, 2, 10), 0.0);
    QCOMPARE(timeToImpact<double>({0.2, 0}, {1, 0}, {1, 0}, 1, 2, 10), infinite);
}

void TestQuadraticImpact::veryShortAndVeryLong() {
    const double soon = timeToImpact<double>({1 + 0x1p-50, 0}, {-1, 0}, {1, 0}, 1, 1, 1);
    QVERIFY(soon > 0 && std::abs(soon / 0x1p-50 - 1) < 1e-12);
    // 1e6 m at 1e-9 m/s, drawn by 1e-24 m/s²: 1e-9 t + 5e-25 t² = 1e6 - 1.
    const double late = timeToImpact<double>({1e6, 0}, {-1e-9, 0}, {-1e-24, 0}, 1, 1e-18, 1e20);
    const double expected = 2 * (1e6 - 1) / (1e-9 + std::sqrt(1e-18 + 2e-24 * (1e6 - 1)));
    QVERIFY(std::abs(late / expected - 1) < 1e-14);
}

void TestQuadraticImpact::floatsAndQuads() {
    Random random(99);
    for (int k = 0; k < 2000; ++k) {
        const ImpactCase c = impactCategories()[0].make(random);
        const auto exact = Exact(c, c.reach, 0).firstImpact();
        const Quad q = timeToImpact<Quad>(convert<Quad>(c.p), convert<Quad>(c.v), convert<Quad>(c.a),
                                          Quad(c.reach), Quad(c.speed2), Quad(c.horizon));
        QCOMPARE(exact.has_value(), q < Quad(infinite));
        if (exact)
            QVERIFY(abs(Hundred(q) - *exact) <= Hundred("1e-25") * *exact);
        const float f = timeToImpact<float>(convert<float>(c.p), convert<float>(c.v), convert<float>(c.a),
                                            float(c.reach), float(c.speed2), float(c.horizon));
        QVERIFY(f >= 0);
        if (exact && *exact < c.horizon * 0.99 && f < 1e30f)
            QVERIFY(std::abs(f - exact->convert_to<double>()) < 0.05);
    }
}

QTEST_GUILESS_MAIN(TestQuadraticImpact)
#include "test_quadratic_impact.moc"

// What a class expects of a collision, judged: the score by its rule, and every fault by its name.
#include "core/collision/prediction.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace thetalane;
using enum Misconception;

namespace {

// A, 2 kg, runs at (1, 0) into B, 1 kg, at rest; the line of centres is turned by 150°, e = 0.5.
PairCollision<double> glancing(double massA = 2, double e = 0.5) {
    const Disc<double> a{massA, 0.1, {-0.1 * std::sqrt(3.0), 0.1}, {1, 0}};
    const Disc<double> b{1, 0.1, {0, 0}, {0, 0}};
    return collide(a, b, e);
}

PairCollision<double> headOn(double e) {
    const Disc<double> a{1, 0.1, {-0.2, 0}, {1, 0}}, b{1, 0.1, {0, 0}, {-0.5, 0}};
    return collide(a, b, e);
}

// A ball that comes down on a floor at 45°.
PairCollision<double> wall(double e) {
    const Disc<double> a{1, 0.1, {0, 0.1}, {1, -1}};
    return collideWithWall<double>(a, {0, 0}, {0, 0.1, 0.1, 0, 1}, e);
}

bool says(const Verdict& v, Misconception what, int body = -1) {
    return std::any_of(v.wrong.begin(), v.wrong.end(),
                       [&](const Diagnosis& d) { return d.what == what && (body < 0 || d.body == body); });
}

} // namespace

class TestPrediction : public QObject {
    Q_OBJECT

private slots:
    void theTruthIsRight() {
        for (const auto& t : {glancing(), glancing(1, 1), headOn(1), headOn(0)}) {
            const Verdict v = judge(t, {t.after, momentumOf(t, t.before), t.energyLoss});
            QCOMPARE(v.score, 100);
            QVERIFY(v.right);
            QVERIFY(v.wrong.empty());
        }
        const auto t = wall(0.6);
        QVERIFY(judge(t, {t.after, {}, t.energyLoss}).right);
    }

    void nearIsRightToo() {
        const auto t = glancing();
        Prediction p{t.after};
        p.after.first.x += 0.04; // of a fastest speed of 1 m/s
        QCOMPARE(judge(t, p).score, 100);
        QVERIFY(judge(t, p).right);
        p.after.first.x += 0.02;
        QVERIFY(!judge(t, p).right);
    }

    void theScoreFallsEvenly() {
        const auto t = headOn(1); // fastest: 1 m/s
        Prediction p{t.after};
        p.after.first.x += 0.275; // halfway between 5 % and 50 %: half of one of two
        QCOMPARE(judge(t, p).score, 75);
        p.after.first.x += 0.225;
        QCOMPARE(judge(t, p).score, 50);
        p.after.second.y = 9;
        QCOMPARE(judge(t, p).score, 0);
        p.momentum = momentumOf(t, t.before); // one of three
        QCOMPARE(judge(t, p).score, 33);
        p.energyLost = 0;
        QCOMPARE(judge(t, p).score, 50);
    }

    void nothingChanged() {
        const auto t = glancing();
        const Verdict v = judge(t, {t.before});
        QVERIFY(says(v, NothingChanged));
        QCOMPARE(v.wrong.size(), 1u);
    }

    void onlyOneChanged() {
        const auto t = glancing();
        const Verdict v = judge(t, {{t.before.first, t.after.second}});
        QVERIFY(says(v, OnlyOneChanged, 0));
        QVERIFY(says(v, MomentumNotKept));
        QVERIFY(says(judge(t, {{t.after.first, t.before.second}}), OnlyOneChanged, 1));
    }

    void swapped() {
        const auto t = glancing();
        QVERIFY(says(judge(t, {{t.after.second, t.after.first}}), BodiesSwapped));
    }

    void exchangedWhole() {
        const auto t = glancing(1, 1); // equal masses: along x′ they do exchange
        const Verdict v = judge(t, {{t.before.second, t.before.first}});
        QVERIFY(says(v, ExchangedWhole));
        QCOMPARE(v.wrong.size(), 1u);
        // Head-on that is the truth.
        const auto h = headOn(1);
        QVERIFY(judge(h, {{h.before.second, h.before.first}}).right);
    }

    void massesIgnored() {
        const auto t = glancing(4, 0.5);
        QVERIFY(says(judge(t, {glancing(1, 0.5).after}), MassesIgnored));
    }

    void momentumAndEnergy() {
        const auto t = headOn(0.5);
        // 1 − 0.5 kg·m/s come; 0 + 2 leave, with more energy than came.
        const Verdict v = judge(t, {{{0, 0}, {2, 0}}});
        QVERIFY(says(v, MomentumNotKept));
        QVERIFY(says(v, EnergyGained));
        const auto d = std::find_if(v.wrong.begin(), v.wrong.end(),
                                    [](const Diagnosis& x) { return x.what == MomentumNotKept; });
        QCOMPARE(d->value, 2.0);
        QCOMPARE(d->wanted, 0.5);
    }

    void restitution() {
        const auto t = headOn(0.5);
        const Verdict bouncy = judge(t, {headOn(1).after});
        QVERIFY(says(bouncy, RestitutionDiffers));
        QVERIFY(!says(bouncy, MomentumNotKept));
        QVERIFY(!says(bouncy, EnergyGained));
        QCOMPARE(bouncy.wrong.front().value, 1.0);
        QCOMPARE(bouncy.wrong.front().wanted, 0.5);
        // Above 1, momentum kept: A back at −1, B at 1.5.
        const Verdict above = judge(t, {{{-1, 0}, {1.5, 0}}});
        QVERIFY(says(above, EnergyGained));
        QVERIFY(says(above, RestitutionDiffers));
    }

    void wentThrough() {
        const auto t = headOn(0.5);
        const Verdict v = judge(t, {{{0.75, 0}, {-0.25, 0}}});
        QVERIFY(says(v, WentThrough));
        QVERIFY(!says(v, RestitutionDiffers));
    }

    void tangential() {
        const auto t = glancing();
        // Along x′ right; across, A gives 0.3 m/s to B, mass by mass.
        VelocityPair<double> turned = t.exchanged;
        turned.first.y -= 0.15;
        turned.second.y += 0.3;
        const Verdict v = judge(t, {rotateBack(turned, t.contact)});
        QVERIFY(says(v, TangentialChanged, 0));
        QVERIFY(says(v, TangentialChanged, 1));
        QVERIFY(!says(v, MomentumNotKept));
        QVERIFY(!says(v, RestitutionDiffers));
    }

    void wrongWay() {
        const auto t = headOn(1);
        QVERIFY(says(judge(t, {{-t.after.first, t.after.second}}), WrongWay, 0));
    }

    void walls() {
        const auto t = wall(0.5);
        QVERIFY(says(judge(t, {t.before}), NothingChanged));
        QVERIFY(says(judge(t, {{{1, 1}, {}}}), RestitutionDiffers));
        QVERIFY(says(judge(t, {{{-1, 0.5}, {}}}), TangentialChanged, 0));
        QVERIFY(says(judge(t, {{{1, -0.4}, {}}}), WentThrough));
        QVERIFY(says(judge(t, {{{1, 2}, {}}}), EnergyGained));
        // A wall takes momentum: nothing is said of it.
        const Verdict v = judge(t, {{{0, 1}, {}}, Vec2d{5, 5}, {}});
        QVERIFY(!says(v, MomentumNotKept));
        QVERIFY(!says(v, MomentumNumberWrong));
    }

    void numbers() {
        const auto t = headOn(0.5); // 0.5 kg·m/s; loses ½·0.5·0.75·1.5² J
        const double loss = 0.421875;
        const auto of = [&](Vec2d p, double e) { return judge(t, {t.after, p, e}); };
        QVERIFY(of({0.5, 0}, loss).right);
        QVERIFY(says(of({1.5, 0}, loss), MomentumNumberWrong));
        QVERIFY(says(of({-0.5, 0}, loss), MomentumNumberWrong));
        QVERIFY(says(of({0.5, 0}, 0.1), EnergyNumberWrong));
        QVERIFY(says(of({0.5, 0}, -loss), EnergyNumberNegative));
        QCOMPARE(of({1.5, 0}, loss).wrong.size(), 1u);
    }
};

QTEST_GUILESS_MAIN(TestPrediction)
#include "test_prediction.moc"

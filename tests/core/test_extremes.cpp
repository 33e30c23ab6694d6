// The study of extremes: its rows hold, none is missing, and its judge can fail.
#include "core/collision/pair_collision.h"
#include "core/study/extreme_rows.h"
#include "core/study/extremes.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <set>

using namespace thetalane;

class TestExtremes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_results = studyExtremes(true, [this](ExtremeRow row) { m_begun.push_back(row); });
    }

    void everyRowIsThere() {
        std::set<ExtremeRow> rows;
        std::set<ExtremeCase> cases;
        for (const ExtremeResult& r : m_results) {
            rows.insert(r.row);
            cases.insert(r.kase);
        }
        QCOMPARE(rows.size(), std::size_t(ExtremeRow::Mirror) + 1);
        QCOMPARE(cases.size(), std::size_t(ExtremeCase::CueOnTwo) + 1);
        QCOMPARE(m_begun.size(), rows.size());
        QVERIFY(std::is_sorted(m_results.begin(), m_results.end(),
                               [](auto& a, auto& b) { return a.row < b.row; }));
    }

    void allAreWithinTheirBounds() {
        QStringList beyond;
        for (const ExtremeResult& r : m_results)
            if (!r.within())
                beyond << QString("row %1, case %2, value %3, measure %4: exact %5, got %6, error %7 > %8")
                              .arg(int(r.row))
                              .arg(int(r.kase))
                              .arg(r.value)
                              .arg(int(r.asked))
                              .arg(r.exact, 0, 'g', 17)
                              .arg(r.got, 0, 'g', 17)
                              .arg(r.error)
                              .arg(r.bound);
        QVERIFY2(beyond.isEmpty(), qPrintable('\n' + beyond.join('\n')));
    }

    // Sample rows against numbers worked out by hand.
    void knownNumbers() {
        const auto find = [&](ExtremeCase kase, double value, ExtremeMeasure asked) {
            const auto found = std::find_if(m_results.begin(), m_results.end(), [&](auto& r) {
                return r.kase == kase && r.value == value && r.asked == asked;
            });
            return found == m_results.end() ? ExtremeResult{} : *found;
        };
        // 2 m_A/(m_A + m_B) of 1 m/s.
        QCOMPARE(find(ExtremeCase::HeadOn, 1e-15, ExtremeMeasure::Speed).exact, 2e-15);
        QCOMPARE(find(ExtremeCase::PiDigits, 1e12, ExtremeMeasure::Collisions).got, 3141592.0);
        // Contact at 0.8 m - 0.2 m cos 30°.
        QCOMPARE(find(ExtremeCase::Speed, 1e6, ExtremeMeasure::ContactTime).exact,
                 (0.8 - 0.1 * std::sqrt(3.0)) * 1e-6);
        // e = 0, masses 2 and 1, 30°: ½ · 2/3 · cos² 30°.
        QCOMPARE(find(ExtremeCase::Elasticity, 0, ExtremeMeasure::EnergyLoss).exact, 0.25);
        // Worked out on paper: 1 and 0.5 m/s of approach, e = 0.2.
        QCOMPARE(find(ExtremeCase::ThreeInALine, 0.2, ExtremeMeasure::Collisions).exact, 4.0);
    }

    void theClosedFormAgreesWithTheSteps() {
        const Body a = extremes::ball(1, 2, 0.1, {-0.5, 0.03}, {1, 0.1});
        const Body b = extremes::ball(2, 5, 0.2, {0.4, 0}, {-0.2, 0});
        const auto m = extremes::meetingOf(a, b, Quad(0.6));
        QVERIFY(m.meets);
        const double t = double(m.time);
        const auto steps = collide<double>({2, 0.1, a.position + a.velocity * t, a.velocity},
                                           {5, 0.2, b.position + b.velocity * t, b.velocity}, 0.6);
        QVERIFY(norm(steps.after.first - convert<double>(m.first)) < 1e-14);
        QVERIFY(norm(steps.after.second - convert<double>(m.second)) < 1e-14);
        QVERIFY(std::abs(steps.energyLoss - double(Quad(m.energyBefore - m.energyAfter))) < 1e-14);
    }

    void theJudgeCanFail() {
        QVERIFY((ExtremeResult{.error = 1, .bound = 1}.within()));
        QVERIFY(!(ExtremeResult{.error = 1.1, .bound = 1}.within()));
        QVERIFY(!(ExtremeResult{.error = std::numeric_limits<double>::quiet_NaN(), .bound = 1}.within()));
    }

private:
    std::vector<ExtremeResult> m_results;
    std::vector<ExtremeRow> m_begun;
};

QTEST_GUILESS_MAIN(TestExtremes)
#include "test_extremes.moc"

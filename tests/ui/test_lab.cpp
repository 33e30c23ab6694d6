// The accuracy lab as a user meets it: a question is pressed, measured beside the window, and answered with
// the numbers of the study.
#include "core/study/measure_cost.h"
#include "panel_bench.h"
#include "ui/lab/ghost_box.h"
#include "ui/lab/ghost_view.h"
#include "ui/lab/lab_panel.h"
#include "ui/lab/lab_table.h"
#include "ui/lab/lab_words.h"
#include "ui/lab/shifted_throws.h"
#include "ui/plot/plot_view.h"
#include "ui/words/method_text.h"
#include "ui/words/number_text.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTimer>

#include <cmath>

using namespace thetalane;

namespace {

constexpr int patience = 120'000; // on a busy machine [ms]
constexpr double few = 0.08;      // of the usual throws

struct Bench : PanelBench {
    LabPanel panel{context, nullptr, few};

    explicit Bench(double share = few)
        : panel(context, nullptr, share) {
        panel.resize(480, 900);
        panel.show();
    }
    LabTable& table() { return *panel.findChild<LabTable*>("labTable"); }
    PlotView& plot() { return *panel.findChild<PlotView*>("labPlot"); }
    GhostBox& ghosts() { return *panel.findChild<GhostBox*>(); }
    QString sentence() {
        return panel.findChild<QLabel*>("labSentence")->text().replace(QChar(0x00A0), u' ');
    }
    QString state() { return panel.findChild<QLabel*>("labState")->text(); }

    void press(const QString& name) {
        auto* button = panel.findChild<QAbstractButton*>(name);
        QVERIFY2(button, qPrintable(name));
        panel.findChild<QScrollArea*>()->ensureWidgetVisible(button);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    bool finish() {
        return QTest::qWaitFor([&] { return !panel.running() && panel.result() && panel.result()->ended; },
                               patience);
    }
};

std::size_t pointsOf(const Plot& plot) {
    std::size_t count = 0;
    for (const PlotSeries& s : plot.series)
        count += s.points.size();
    return count;
}

const MethodResult& resultOf(const LabResult& result, const Method& method) {
    for (const MethodResult& r : result.study.methods)
        if (r.method == method)
            return r;
    qFatal("no such method");
}

} // namespace

class TestLab : public QObject {
    Q_OBJECT

private slots:
    void everyPresetAnswers_data() {
        QTest::addColumn<int>("preset");
        for (int k = 0; k < presetCount; ++k)
            QTest::newRow(qPrintable(QString::number(k))) << k;
    }
    void everyPresetAnswers() {
        QFETCH(int, preset);
        Bench b;
        b.press(QStringLiteral("preset%1").arg(preset));
        QVERIFY(b.panel.running());
        QVERIFY(b.finish());
        const LabResult& r = *b.panel.result();
        QVERIFY(!r.study.cancelled);
        QCOMPARE(r.study.cases, r.study.casesAsked);
        QCOMPARE(std::size_t(b.table().rowCount()), r.plan->rows());
        QVERIFY(pointsOf(b.plot().plot()) >= 2);
        QVERIFY(r.ghosts && !r.ghosts->all.empty());
        QVERIFY(!b.sentence().isEmpty());
        QVERIFY2(!b.sentence().contains('%') || !b.sentence().contains(QRegularExpression("%[0-9]")),
                 qPrintable(b.sentence()));
        QVERIFY(b.state().contains(QString::number(r.study.cases)));
    }

    // Half of what a step is too long goes through, by geometry: 1 - 2(r₁ + r₂)/(v·h).
    void tunnellingIsAsGeometrySays() {
        LabDials dials{20, 30};
        const LabPlan plan = presetPlan(Preset::Through, dials);
        const StudyResult study = runStudy(plan.cases, [&] {
            StudyOptions o = plan.options;
            o.costRounds = 0;
            return o;
        }());
        int above = 0, below = 0;
        for (const MethodResult& r : study.methods) {
            if (r.method.settings.kind != EngineKind::Stepped)
                continue;
            const double way = dials.speed * r.method.settings.step;
            const double expected = std::max(0.0, 1 - 2 * (0.10845 + 0.06053) / way);
            QVERIFY2(std::abs(1 - r.sameTouched - expected) < 0.03,
                     qPrintable(QString("%1: %2, not %3").arg(way).arg(1 - r.sameTouched).arg(expected)));
            ++(expected > 0 ? above : below);
        }
        QVERIFY(above > 4 && below > 1);
    }

    // A pair that leaves with e times its speed is still inside in 1 - e of all places in the step.
    void hitsTwiceAtEveryStep() {
        const LabPlan plan = presetPlan(Preset::Twice, {}, 0.5);
        StudyOptions options = plan.options;
        options.costRounds = 0;
        std::erase_if(options.methods, [](const Method& m) { return m.settings.step < 1e-4; });
        for (const MethodResult& r : runStudy(plan.cases, options).methods)
            if (r.method.settings.kind == EngineKind::Stepped) {
                const double expected = r.method.settings.approachingOnly ? 0 : 0.25;
                QVERIFY2(std::abs(1 - r.sameOrder - expected) < 0.1, qPrintable(methodText(r.method)));
            }
    }

    void shownNumbersAreTheStudys() {
        Bench b;
        b.press("preset3");
        QVERIFY(b.finish());
        const LabResult& r = *b.panel.result();
        for (std::size_t row = 0; row < r.study.methods.size(); ++row) {
            const MethodResult& m = r.study.methods[row];
            const auto text = [&](int column) { return b.table().item(int(row), column)->text(); };
            QCOMPARE(text(LabTable::Name), keptTogether(methodText(m.method)));
            QCOMPARE(text(LabTable::Cost), costText(m.cost.median));
            QCOMPARE(text(LabTable::Error), numberText(m.error().median, 2) + " m");
            QCOMPARE(text(LabTable::Same), percentText(m.sameTouched));
        }
        const MethodResult& single = resultOf(r, eventMethod(Precision::Float));
        QVERIFY(b.sentence().contains(QString::number(single.cases)));
        const PlotSeries& series = b.plot().plot().series.back(); // float over time
        QCOMPARE(series.points.back().y, single.error().median);
        QCOMPARE(series.points.front().y, single.errors.front().median);
    }

    // What is there stays, and says what it is.
    void cancelKeepsWhatThereIs() {
        Bench b(1);
        b.press("preset2");
        QVERIFY(QTest::qWaitFor(
            [&] { return b.panel.result() && b.panel.result()->study.methods.front().cases > 0; }, patience));
        b.press("labStop");
        QVERIFY(b.finish());
        const LabResult& r = *b.panel.result();
        QVERIFY(r.study.cancelled);
        QVERIFY(r.study.cases < r.study.casesAsked);
        QVERIFY(r.study.methods.front().cases > 0);
        QVERIFY(b.table().item(0, LabTable::Same)->text().contains('%'));
        QVERIFY2(b.state().startsWith("Cancelled"), qPrintable(b.state()));
        QVERIFY(!b.panel.findChild<QProgressBar*>()->isVisible());
    }

    // The last one pressed is the one that is answered.
    void anotherPresetTakesOver() {
        Bench b(1);
        b.press("preset2");
        b.press("preset0");
        QVERIFY(QTest::qWaitFor(
            [&] {
                return b.panel.result() && b.panel.result()->ended &&
                       b.panel.result()->plan->preset == Preset::Through;
            },
            patience));
        QVERIFY(!b.panel.running());
    }

    void dialsMeasureAnew() {
        Bench b;
        b.press("preset0");
        QVERIFY(b.finish());
        QVERIFY2(b.sentence().contains("66.7 cm"), qPrintable(b.sentence()));
        type(b.panel, "labSpeedField", "5");
        QVERIFY(QTest::qWaitFor([&] { return b.panel.result()->plan->dials.speed == 5; }, patience));
        QVERIFY(b.finish());
        QVERIFY2(b.sentence().contains("16.7 cm") && b.sentence().contains("cannot"),
                 qPrintable(b.sentence()));
        type(b.panel, "labSpeedField", "0");
        QVERIFY(QTest::qWaitFor([&] { return !message(b.panel, "labSpeedMessage").isEmpty(); }, patience));
        QVERIFY(!b.panel.running());
    }

    void ownScene() {
        Bench b;
        b.session.openBuiltin("rack");
        b.press("ownScene");
        b.press("method2"); // the paper's loop at 1/60 s: not now
        b.press("runOwn");
        QVERIFY(b.finish());
        const LabResult& r = *b.panel.result();
        QVERIFY(!r.plan->preset);
        QCOMPARE(r.plan->rows(), chosenAtFirst - 1);
        QCOMPARE(r.plan->cases.scenes.front(), b.session.scene());
        QCOMPARE(b.table().rowCount(), int(chosenAtFirst) - 1);
        for (const MethodResult& m : r.study.methods)
            QVERIFY(m.method.settings.kind != EngineKind::Stepped);
        b.session.openBuiltin("glancing"); // what was found is of another scene
        QVERIFY(!b.panel.result() && !b.table().isVisible());
    }

    void withoutAnyMethodThereIsNothingToRun() {
        Bench b;
        b.press("ownScene");
        for (std::size_t k = 0; k < chosenAtFirst; ++k)
            b.press(QStringLiteral("method%1").arg(k));
        QVERIFY(!b.panel.findChild<QPushButton*>("runOwn")->isEnabled());
        QVERIFY(!b.panel.findChild<QPushButton*>("method16")->isVisible()); // no friction to leave out
    }

    // A mark opens with the mouse, a line of the legend with the keyboard, and the row follows.
    void ghostsOpen() {
        Bench b;
        b.press("preset1");
        QVERIFY(b.finish());
        const Ghosts& ghosts = *b.panel.result()->ghosts;
        const auto mark = b.ghosts().view()->markAt(0);
        QVERIFY(mark);
        QTest::mouseClick(b.ghosts().view(), Qt::LeftButton, {}, mark->toPoint());
        QCOMPARE(b.table().currentRow(), int(ghosts.all[0].row));
        const QString story = b.panel.findChild<QLabel*>("ghostStory")->text().replace(QChar(0x00A0), u' ');
        QVERIFY2(story.contains(numberText(ghosts.all[0].parting->time)), qPrintable(story));
        QVERIFY(std::abs(b.ghosts().view()->time() - ghosts.all[0].parting->time) < ghosts.lastShown() / 100);
        auto* entry = b.panel.findChild<QPushButton*>("ghost1");
        entry->setFocus();
        QTest::keyClick(entry, Qt::Key_Space);
        QCOMPARE(b.table().currentRow(), int(ghosts.all[1].row));
    }

    void pointsOfTheDiagramChooseTheirRow() {
        Bench b;
        b.press("preset2");
        QVERIFY(b.finish());
        emit b.plot().picked(0, 0);
        const std::size_t row = methodOfPoint(b.panel.result()->study, 0, 0);
        QCOMPARE(b.table().currentRow(), int(row));
        auto* diagrams = b.panel.findChild<QComboBox*>("labDiagram");
        diagrams->setFocus();
        QTest::keyClick(diagrams, Qt::Key_Down);
        QCOMPARE(b.plot().plot().x.logarithmic, false); // over time
    }

    void languageSwitches() {
        Language language;
        useLanguage(language, false);
        Bench b;
        b.press("preset5");
        QVERIFY(b.finish());
        const QString english = b.sentence(), row = b.table().item(1, 0)->text();
        useLanguage(language, true);
        QVERIFY(b.sentence() != english);
        QVERIFY(b.table().item(1, 0)->text() != row);
        static const QRegularExpression hangul("[\\x{AC00}-\\x{D7A3}]");
        for (const QString& text :
             {b.sentence(), b.state(), b.table().item(1, 0)->text(), b.plot().plot().x.title})
            QVERIFY2(text.contains(hangul), qPrintable(text));
        for (const QPushButton* button : b.panel.findChildren<QPushButton*>())
            if (button->objectName().startsWith("preset"))
                QVERIFY2(button->text().contains(hangul), qPrintable(button->text()));
        useLanguage(language, false);
        QCOMPARE(b.sentence(), english);
    }

    void everythingCanBeReachedAndIsNamed() {
        Bench b;
        b.press("preset0");
        QVERIFY(b.finish());
        for (const bool projector : {false, true}) {
            b.appearance.setProjector(projector);
            QCoreApplication::processEvents();
            for (const QWidget* w : b.panel.findChildren<QWidget*>()) {
                const bool handled = qobject_cast<const QAbstractButton*>(w) ||
                                     qobject_cast<const QComboBox*>(w) ||
                                     qobject_cast<const QAbstractSlider*>(w);
                if (!handled || !w->isVisible() || w->objectName().startsWith("qt_") ||
                    w->inherits("QScrollBar"))
                    continue;
                QVERIFY2(!w->objectName().isEmpty(), w->metaObject()->className());
                QVERIFY2(!w->accessibleName().isEmpty(), qPrintable(w->objectName()));
                QVERIFY2(!w->toolTip().isEmpty(), qPrintable(w->objectName()));
                QVERIFY2(w->focusPolicy() & Qt::TabFocus, qPrintable(w->objectName()));
                QVERIFY2(w->height() >= (projector ? 36 : 24), qPrintable(w->objectName()));
            }
        }
    }

    // What stalls the window is told; on a busy machine only a stall that anybody would see fails.
    void windowDoesNotStall() {
        Bench b(1);
        QElapsedTimer clock;
        qint64 last = 0, longest = 0, firstPoints = -1;
        double worked = threadTime(), most = 0; // of the window's own thread, whoever else has the cores [s]
        QTimer heart;
        heart.setTimerType(Qt::PreciseTimer);
        connect(&heart, &QTimer::timeout, this, [&] {
            longest = std::max(longest, clock.elapsed() - last);
            last = clock.elapsed();
            most = std::max(most, threadTime() - worked);
            worked = threadTime();
        });
        connect(&b.panel, &LabPanel::resultShown, this, [&] {
            if (firstPoints < 0 && pointsOf(b.plot().plot()) > 0)
                firstPoints = clock.elapsed();
        });
        b.press("preset3");
        clock.start();
        heart.start(4);
        QVERIFY(b.finish());
        heart.stop();
        qInfo("longest pause of the window %lld ms, of it at work %.0f ms, first points after %lld ms, whole "
              "study %lld ms",
              longest, 1e3 * most, firstPoints, clock.elapsed());
        QVERIFY(most < 0.3);
        QVERIFY(longest < 1000);
        QVERIFY(firstPoints >= 0);
    }

    void closingStopsTheStudy() {
        QElapsedTimer clock;
        {
            Bench b(1);
            b.press("preset2");
            QTest::qWait(50);
            clock.start();
        }
        QVERIFY(clock.elapsed() < 20'000);
    }
};

QTEST_MAIN(TestLab)
#include "test_lab.moc"

// Contacts of the same instant, as the panels show them: runs whose every number is known by hand, real
// clicks and keys.
#include "made_runs.h"
#include "panel_bench.h"
#include "ui/panels/collision_list.h"
#include "ui/panels/collision_model.h"
#include "ui/panels/scrub_bar.h"
#include "ui/steps/step_panel.h"

#include <QTableView>

using namespace thetalane;

namespace {

const double third = std::sqrt(3) / 2;

QStringList linesOf(const Run& run, std::size_t index, Stage stage) {
    QStringList lines;
    const auto steps = workedSteps(run.scene, run.timeline.collisions(), index);
    for (const WorkedLine& line : steps[std::size_t(stage)].lines)
        lines << plainText(line);
    return lines;
}

double valueOf(const Run& run, std::size_t index, Stage stage, const QString& left) {
    const auto steps = workedSteps(run.scene, run.timeline.collisions(), index);
    for (const WorkedLine& line : steps[std::size_t(stage)].lines)
        if (plainText(line.left) == left)
            return plainText(line.result, Digits::All).section(' ', 0, 0).toDouble();
    return std::nan("");
}

struct Bench : PanelBench {
    StepPanel panel{context};

    explicit Bench(double e = 1) {
        adoptRun(session, oneOnTwo(e));
        panel.resize(380, 700);
        panel.show();
    }
    QString text(const char* name) const { return panel.findChild<QLabel*>(QLatin1String(name))->text(); }
};

} // namespace

class TestInstants : public QObject {
    Q_OBJECT

    Language m_language;

private slots:
    void initTestCase_data() { addLanguages(); }
    void init() {
        QFETCH_GLOBAL(bool, korean);
        useLanguage(m_language, korean);
    }
    bool korean() const { return m_language.code() == Language::Code::Korean; }

    void knowsThePasses() {
        const Run run = oneOnTwo(1);
        const auto all = run.timeline.collisions();
        const Instant one = instantOf(all, 1);
        QCOMPARE(one.size, std::size_t(3));
        QCOMPARE(one.passSize, std::size_t(2));
        QCOMPARE(one.pass, 1);
        QCOMPARE(one.passes, 2);
        const Instant last = instantOf(all, 2);
        QCOMPARE(last.passSize, std::size_t(1));
        QCOMPARE(last.pass, 2);
        QCOMPARE(instantText(one, 1),
                 korean()
                     ? QString("이 순간의 접촉 3개 중 2번째 · 2회차 중 1회차: 접촉 2개를 함께 계산")
                     : QString("Contact 2 of 3 at this instant · pass 1 of 2: 2 contacts resolved together"));
        QCOMPARE(bodiesOf(passOf(all, 0)).size(), std::size_t(3)); // A once
    }

    // At e = 1: v_Ax′ = −√3/2, both impulses 0.4 √3, the other's line at 60°: v′_Ax′ = 0.1 √3.
    void impulsesThatMeetAddUp() {
        const Run run = oneOnTwo(1);
        const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12; };
        QVERIFY(near(valueOf(run, 0, Stage::Exchange, "I_AB"), 0.8 * third));
        QVERIFY(near(valueOf(run, 0, Stage::Exchange, "I_AC"), 0.8 * third));
        QVERIFY(near(valueOf(run, 0, Stage::Exchange, "v′_Ax′"), 0.2 * third));
        QVERIFY(near(valueOf(run, 0, Stage::Exchange, "v′_Ay′"), -0.1));
        QVERIFY(near(valueOf(run, 0, Stage::Exchange, "v′_Bx′"), -0.8 * third));
        QVERIFY(near(valueOf(run, 0, Stage::Exchange, "v′_Ax′ − v′_Bx′"), third));
        const QStringList lines = linesOf(run, 0, Stage::Exchange);
        const QString sum = lines.filter("v′_Ax′ = ").join('\n');
        QVERIFY2(sum.contains("v_Ax′ + (I_AB + I_AC cos δ_AC)/m_A = −0.8660 + (0.6928 + 0.6928·0.5000)/1") ||
                     sum.contains("v_Ax′ + (I_AB + I_AC cos δ_AC)/m_A = −0.8660 + (0.6928 + 0.6928·0.5)/1"),
                 qPrintable(sum));
        QVERIFY2(!lines.join('\n').contains("(1 + e)"), qPrintable(lines.join('\n'))); // of two bodies
    }

    void theWholePassIsChecked() {
        const Run run = oneOnTwo(0.5);
        const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12; };
        QVERIFY(near(valueOf(run, 0, Stage::Check, "p_y"), 1));
        QVERIFY(near(valueOf(run, 0, Stage::Check, "p′_y"), 1));
        QVERIFY(near(valueOf(run, 0, Stage::Check, "e"), 0.5));
        const double before = valueOf(run, 0, Stage::Check, "E");
        const double after = valueOf(run, 0, Stage::Check, "E′");
        QVERIFY(near(before, 0.5));
        QVERIFY(near(valueOf(run, 0, Stage::Check, "E − E′"), before - after));
        // Half of it at each of the two.
        QVERIFY(near(valueOf(run, 0, Stage::Check, "L_AB"), (before - after) / 2));
    }

    void oneAfterAnotherIsTheOrdinaryExchange() {
        const Run run = oneOnTwo(0.5);
        QVERIFY(linesOf(run, 2, Stage::Exchange)[0].contains("(m_B − e·m_D)"));
        const Instant last = instantOf(run.timeline.collisions(), 2);
        QVERIFY(instantText(last, 2).contains(korean() ? "한 번에 하나씩" : "one pass after another"));
        const Instant first = instantOf(run.timeline.collisions(), 0);
        QVERIFY(instantRule(last, EngineSettings{}) != instantRule(first, EngineSettings{}));
        QVERIFY(instantRule(last, EngineSettings{.kind = EngineKind::Stepped})
                    .contains(korean() ? "논문" : "The paper's loop"));
    }

    // λ = 0 where the others part the two faster than e asks.
    void partedFasterByOthers() {
        Run run = oneOnTwo(0.5);
        TimelineRecord record;
        for (const Collision& c : run.timeline.collisions())
            record.collisions.push_back(c);
        Collision& c = record.collisions[1];
        c.pass = record.collisions[0].pass = 1;
        c.steps.impulse = c.steps.energyLoss = 0;
        c.steps.restitutionResidual = 0.25;
        run.timeline = Timeline(0, std::move(record));
        const auto steps = workedSteps(run.scene, run.timeline.collisions(), 1);
        QVERIFY2(steps[3].sentence.contains(korean() ? "더 빠르게" : "faster than e asks"),
                 qPrintable(steps[3].sentence));
        QVERIFY(std::isnan(valueOf(run, 1, Stage::Check, "e")));
        QVERIFY(!std::isnan(valueOf(run, 1, Stage::Exchange, "−e·(v_Ax′ − v_Cx′)")));
    }

    void theHeadSaysIt() {
        Bench b;
        b.playhead.select(0);
        const auto* note = b.panel.findChild<InstantNote*>();
        QVERIFY(note->isVisible());
        QTRY_COMPARE(note->height(), note->heightForWidth(note->width()));
        QVERIFY2(b.text("instantPlace").contains(korean() ? "함께 계산" : "2 contacts resolved together"),
                 qPrintable(b.text("instantPlace")));
        QVERIFY2(b.text("stepSentence3").contains(korean() ? "접촉 2개" : "2 contacts"),
                 qPrintable(b.text("stepSentence3")));
        QVERIFY(b.text("stepSentence3").contains(korean() ? "A도" : "strikes A too"));
        b.session.openBuiltin("two-balls");
        b.playhead.select(0);
        QVERIFY(!b.panel.findChild<InstantNote*>()->isVisible());
    }

    void linksGoToTheOthers() {
        Bench b;
        b.playhead.select(0);
        click(b.panel, "passContact1");
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(1));
        QVERIFY(!b.panel.findChild<QWidget*>("passContact1") ||
                b.panel.findChild<QWidget*>("passContact1")->isHidden());
        auto* back = b.panel.findChild<InstantLink*>("passContact0");
        QVERIFY(back->height() >= 24);
        back->setFocus();
        QTest::keyClick(back, Qt::Key_Space);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
        b.playhead.select(2); // alone in its pass
        for (const auto* link : b.panel.findChildren<InstantLink*>())
            QVERIFY(link->isHidden() || link->objectName() == "whyTogether");
    }

    void theRuleCanBeRead() {
        Bench b;
        b.playhead.select(0);
        auto* rule = b.panel.findChild<QLabel*>("instantRule");
        QVERIFY(!rule->isVisible());
        click(b.panel, "whyTogether");
        QVERIFY(rule->isVisible());
        QCOMPARE(rule->height(), rule->heightForWidth(rule->width())); // all of it
        auto* why = b.panel.findChild<QAbstractButton*>("whyTogether");
        why->setFocus();
        QTest::keyClick(why, Qt::Key_Space);
        QVERIFY(!rule->isVisible());
        QTest::keyClick(why, Qt::Key_Space);
        QVERIFY(rule->isVisible());
        b.appearance.setProjector(true);
        QCoreApplication::processEvents();
        QCOMPARE(rule->height(), rule->heightForWidth(rule->width()));
        const auto* note = b.panel.findChild<InstantNote*>();
        QTRY_COMPARE(note->height(), note->heightForWidth(note->width()));
    }

    void labelsKeepOffTheArrows() {
        const Appearance appearance;
        const Run run = oneOnTwo(0.5);
        for (std::size_t k = 0; k < 3; ++k)
            for (int stage = 0; stage < stageCount; ++stage) {
                const FigureCanvas canvas = stageFigure(run.scene, run.timeline.collisions(), k, Stage(stage),
                                                        appearance, {330, 220});
                for (const FigureLabel& label : canvas.labels())
                    for (const QLineF& stroke : canvas.strokes())
                        for (int i = 0; i <= 50; ++i)
                            QVERIFY2(!label.place.contains(stroke.pointAt(i / 50.0)),
                                     qPrintable(QString("%1 stage %2").arg(k).arg(stage)));
            }
    }

    void theListJoinsThem() {
        PanelBench b;
        adoptRun(b.session, oneOnTwo(1));
        CollisionList list(b.context);
        showPanel(list, {340, 300});
        const QAbstractItemModel* model = list.findChild<QTableView*>()->model();
        const auto at = [&](int row, int role) { return model->index(row, 0).data(role).toInt(); };
        using M = CollisionModel;
        QCOMPARE(at(0, M::InstantRole), int(M::First));
        QCOMPARE(at(1, M::InstantRole), int(M::Between));
        QCOMPARE(at(2, M::InstantRole), int(M::Last));
        QCOMPARE(at(0, M::PassRole), int(M::First));
        QCOMPARE(at(1, M::PassRole), int(M::Last));
        QCOMPARE(at(2, M::PassRole), int(M::Alone));
        const QString tip = model->index(1, 0).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(korean() ? "함께 계산" : "2 contacts resolved together"), qPrintable(tip));
        // The bar of the pass reaches from the first row into the second, and not into the third.
        auto* table = list.findChild<QTableView*>();
        const QImage image = table->viewport()->grab().toImage();
        const auto amber = [&](int y) {
            for (int x = 8; x < 14; ++x)
                if (image.pixelColor(x, y) == b.appearance.ink(Ink::Triangle))
                    return true;
            return false;
        };
        QVERIFY(amber(table->visualRect(model->index(0, 0)).bottom()));
        QVERIFY(!amber(table->visualRect(model->index(1, 0)).bottom()));
    }

    void theTimeLineSaysIt() {
        PanelBench b;
        adoptRun(b.session, oneOnTwo(1));
        ScrubBar bar(b.context);
        showPanel(bar, {600, 32});
        const QString hint = bar.hintAt(bar.xAt(0.5));
        QVERIFY2(hint.contains(korean() ? "2건 더" : "and 2 more at the same instant, in 2 passes"),
                 qPrintable(hint));
    }
};

QTEST_MAIN(TestInstants)
#include "test_instants.moc"

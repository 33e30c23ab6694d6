// Predict, then reveal: arrows dragged and typed, the truth hidden until it is asked for, and then judged.
#include "core/scene/builtin.h"
#include "panel_bench.h"
#include "ui/predict/guess_fields.h"
#include "ui/predict/predict_figure.h"
#include "ui/predict/predict_panel.h"
#include "ui/words/number_text.h"

#include <QCheckBox>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalSpy>

#include <cmath>
#include <memory>

using namespace thetalane;
using State = PredictPanel::State;

namespace {

constexpr QSize usualRoom(344, 540);
constexpr QSize projectorRoom(480, 500);

struct PredictBench : PanelBench {
    explicit PredictBench(const char* scene, bool projector = false) {
        if (!session.openBuiltin(scene))
            qFatal("no scene %s", scene);
        appearance.setProjector(projector);
        panel = std::make_unique<PredictPanel>(context);
        showPanel(*panel, projector ? projectorRoom : usualRoom);
    }
    const PairCollision<double>& truth(int number = 1) const {
        return session.timeline().collisions()[std::size_t(number - 1)].steps;
    }
    PredictFigure& figure() { return *panel->findChild<PredictFigure*>(); }
    QString text(const char* name) {
        auto* label = panel->findChild<QLabel*>(QLatin1String(name));
        return label && label->isVisible() ? label->text() : QString();
    }
    void typeTruth(int number = 1) {
        const auto& t = truth(number);
        type(*panel, "guessFirstX", QString::number(t.after.first.x, 'g', 9));
        type(*panel, "guessFirstY", QString::number(t.after.first.y, 'g', 9));
        if (std::isinf(t.second.mass))
            return;
        type(*panel, "guessSecondX", QString::number(t.after.second.x, 'g', 9));
        type(*panel, "guessSecondY", QString::number(t.after.second.y, 'g', 9));
    }
    std::unique_ptr<PredictPanel> panel;
};

void drag(QWidget& w, QPointF from, QPointF to) {
    QTest::mousePress(&w, Qt::LeftButton, {}, from.toPoint());
    QTest::mouseMove(&w, ((from + to) / 2).toPoint());
    QTest::mouseMove(&w, to.toPoint());
    QTest::mouseRelease(&w, Qt::LeftButton, {}, to.toPoint());
}

bool hasHangul(const QString& text) {
    static const QRegularExpression hangul("[\\x{AC00}-\\x{D7A3}]");
    return hangul.match(text).hasMatch();
}

QStringList everyText(QWidget& panel) {
    QStringList texts;
    for (QWidget* w : panel.findChildren<QWidget*>()) {
        texts << w->toolTip() << w->accessibleName() << w->accessibleDescription();
        if (auto* l = qobject_cast<QLabel*>(w))
            texts << l->text();
        if (auto* e = qobject_cast<QLineEdit*>(w))
            texts << e->text();
    }
    return texts;
}

} // namespace

class TestPredict : public QObject {
    Q_OBJECT

    std::unique_ptr<Language> m_language;

private slots:
    void init() { m_language = std::make_unique<Language>(); }
    void cleanup() { useLanguage(*m_language, false); }

    void holdsJustBefore() {
        PredictBench bench("two-balls");
        QSignalSpy hides(bench.panel.get(), &PredictPanel::predicting);
        click(*bench.panel, "beginPrediction");
        QCOMPARE(int(bench.panel->state()), int(State::Predicting));
        QCOMPARE(bench.panel->number(), 1);
        QVERIFY(hides.last()[0].toBool());
        const double contact = bench.session.timeline().collisions()[0].time;
        QVERIFY(bench.playhead.time() < contact && bench.playhead.time() > contact - 0.2);
        QVERIFY(!bench.playhead.selected());
        // As it begins, nothing is changed: the arrows are those of before.
        QVERIFY(bench.figure().guess().first == bench.truth().before.first);
        QCOMPARE(bench.text("predictTitle"), QString("Collision 1: A → B"));
        QVERIFY(bench.text("predictFacts").contains("e = 1"));
    }

    void theTruthIsNotShown() {
        PredictBench bench("glancing");
        click(*bench.panel, "beginPrediction");
        const auto& t = bench.truth();
        const QImage before = bench.panel->grab().toImage();
        for (const double hidden :
             {t.after.first.x, t.after.first.y, t.after.second.x, t.after.second.y, t.energyLoss})
            for (const QString& text : everyText(*bench.panel)) {
                QVERIFY2(!text.contains(numberText(hidden, 3)), qPrintable(text));
                QVERIFY2(!text.contains(numberText(hidden, 4)), qPrintable(text));
            }
        QCOMPARE(bench.text("predictScore"), QString());
        QCOMPARE(bench.text("predictTruth"), QString());
        QVERIFY(!bench.panel->verdict());
        click(*bench.panel, "revealPrediction");
        QVERIFY(before != bench.panel->grab().toImage());
        QVERIFY(bench.text("predictTruth").contains(numberText(t.after.first.x, 3)));
    }

    void fieldsFollowEachOtherAsTheyAreRead() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        bench.panel->activateWindow();
        bench.panel->findChild<QLineEdit*>("guessFirstX")->setFocus();
        for (const char* next :
             {"guessFirstY", "guessSecondX", "guessSecondY", "guessMode", "guessMomentum"}) {
            QTest::keyClick(bench.panel->focusWidget(), Qt::Key_Tab);
            QCOMPARE(bench.panel->focusWidget()->objectName(), QString(next));
        }
    }

    // A speed that nobody could drag an arrow to still has its tip in the figure.
    void aTypedArrowEndsInside() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        type(*bench.panel, "guessFirstX", "40");
        type(*bench.panel, "guessSecondY", "-30");
        for (const int body : {0, 1})
            QVERIFY(QRectF(bench.figure().rect()).contains(bench.figure().tip(body)));
    }

    void aTipIsDragged() {
        PredictBench bench("right-angle");
        click(*bench.panel, "beginPrediction");
        PredictFigure& figure = bench.figure();
        const QPointF from = figure.tip(1); // B is at rest: its tip is at its centre
        drag(figure, from, from + QPointF(40, 30));
        const Vec2d v = figure.guess().second;
        QVERIFY(v.x > 0 && v.y < 0);
        QVERIFY(std::abs(v.x / -v.y - 4.0 / 3) < 0.15);
        QVERIFY(QLineF(figure.tip(1), from + QPointF(40, 30)).length() < 4);
        // The fields say the same.
        QVERIFY(std::abs(parseNumber(field(*bench.panel, "guessSecondX").text()).value() - v.x) < 1e-6);
        QCOMPARE(figure.guess().first, bench.truth().before.first);
    }

    void typedNumbersMoveTheArrow() {
        PredictBench bench("right-angle");
        click(*bench.panel, "beginPrediction");
        type(*bench.panel, "guessSecondX", "0.75");
        type(*bench.panel, "guessSecondY", "-0.433");
        QCOMPARE(bench.figure().guess().second.x, 0.75);
        QCOMPARE(bench.figure().guess().second.y, -0.433);
        click(*bench.panel, "guessMode"); // speed and direction
        QVERIFY(std::abs(parseNumber(field(*bench.panel, "guessSecondX").text()).value() - 0.866) < 1e-3);
        QVERIFY(std::abs(parseNumber(field(*bench.panel, "guessSecondY").text()).value() + 30) < 0.01);
        type(*bench.panel, "guessFirstX", "0.5");
        type(*bench.panel, "guessFirstY", "60");
        QVERIFY(std::abs(bench.figure().guess().first.x - 0.25) < 1e-12);
        QVERIFY(std::abs(bench.figure().guess().first.y - 0.4330127018922193) < 1e-12);
        click(*bench.panel, "revealPrediction");
        QCOMPARE(bench.panel->verdict()->score, 100);
    }

    void keysAlone() {
        PredictBench bench("head-on"); // equal masses, 1 and −0.5 m/s, e = 1: they exchange
        bench.panel->findChild<QAbstractButton*>("beginPrediction")->setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        PredictFigure& figure = bench.figure();
        QCOMPARE(QApplication::focusWidget(), &figure);
        for (int k = 0; k < 15; ++k) // 0.01 a step, ten at once with Shift
            QTest::keyClick(&figure, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(std::abs(figure.guess().first.x + 0.5) < 1e-12);
        QTest::keyClick(&figure, Qt::Key_Space);
        QCOMPARE(figure.chosen(), 1);
        for (int k = 0; k < 15; ++k)
            QTest::keyClick(&figure, Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(figure.guess().second.x - 1) < 1e-12);
        auto* reveal = bench.panel->findChild<QAbstractButton*>("revealPrediction");
        reveal->setFocus();
        QTest::keyClick(reveal, Qt::Key_Space);
        QCOMPARE(bench.panel->verdict()->score, 100);
        QVERIFY(bench.text("predictScore").startsWith("100 "));
    }

    void revealOpensTheCollision() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        bench.typeTruth();
        click(*bench.panel, "revealPrediction");
        QCOMPARE(int(bench.panel->state()), int(State::Revealed));
        QCOMPARE(bench.panel->verdict()->score, 100);
        QVERIFY(bench.panel->verdict()->right);
        QCOMPARE(bench.playhead.selectedNumber().value_or(0), std::int64_t(1));
        QCOMPARE(int(bench.playhead.stage()), int(Stage::Check));
        // Once more, and the truth is gone again; the arrows stay.
        const auto guess = bench.figure().guess().first;
        click(*bench.panel, "revealPrediction");
        QCOMPARE(int(bench.panel->state()), int(State::Predicting));
        QCOMPARE(bench.text("predictTruth"), QString());
        QVERIFY(bench.figure().guess().first == guess);
        QVERIFY(!bench.playhead.selected());
    }

    void whatWentWrong_data() { addLanguages(); }
    void whatWentWrong() {
        QFETCH(bool, korean);
        useLanguage(*m_language, korean);
        PredictBench bench("right-angle");
        click(*bench.panel, "beginPrediction");
        click(*bench.panel, "revealPrediction"); // nothing changed
        QCOMPARE(bench.panel->verdict()->wrong.front().what, Misconception::NothingChanged);
        QCOMPARE(hasHangul(bench.text("predictWrong")), korean);
        click(*bench.panel, "revealPrediction");
        type(*bench.panel, "guessFirstX", "0"); // the whole velocities exchanged, as in one dimension
        type(*bench.panel, "guessSecondX", "1");
        click(*bench.panel, "revealPrediction");
        QCOMPARE(bench.panel->verdict()->wrong.front().what, Misconception::ExchangedWhole);
        QVERIFY(bench.panel->verdict()->score < 60);
    }

    void numbersToo() {
        PredictBench bench("inelastic");
        click(*bench.panel, "beginPrediction");
        bench.typeTruth();
        QTest::mouseClick(bench.panel->findChild<QCheckBox*>("guessMomentum"), Qt::LeftButton, {}, {8, 12});
        QTest::mouseClick(bench.panel->findChild<QCheckBox*>("guessEnergy"), Qt::LeftButton, {}, {8, 12});
        type(*bench.panel, "guessMomentumX", "0.7"); // 1 − 0.3
        type(*bench.panel, "guessEnergyLost", "-1");
        click(*bench.panel, "revealPrediction");
        QCOMPARE(bench.panel->verdict()->wrong.size(), 1u);
        QCOMPARE(bench.panel->verdict()->wrong.front().what, Misconception::EnergyNumberNegative);
        QCOMPARE(bench.panel->verdict()->score, 75);
    }

    void unreadableIsSaid() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        type(*bench.panel, "guessFirstX", "fast");
        QVERIFY(bench.text("predictMessage").contains("fast"));
        QVERIFY(!bench.panel->findChild<QAbstractButton*>("revealPrediction")->isEnabled());
        type(*bench.panel, "guessFirstX", "1");
        QCOMPARE(bench.text("predictMessage"), QString());
        QVERIFY(bench.panel->findChild<QAbstractButton*>("revealPrediction")->isEnabled());
    }

    void wallsToo() {
        PredictBench bench("two-balls");
        const auto all = bench.session.timeline().collisions();
        const auto wall = std::find_if(all.begin(), all.end(), [](const Collision& c) { return c.isWall(); });
        QVERIFY(wall != all.end());
        const int number = int(wall - all.begin()) + 1;
        bench.playhead.selectNumber(number);
        click(*bench.panel, "beginPrediction");
        QCOMPARE(bench.panel->number(), number);
        QVERIFY(!field(*bench.panel, "guessSecondX").isVisible());
        QVERIFY(!bench.panel->findChild<QCheckBox*>("guessMomentum")->isVisible());
        bench.typeTruth(number);
        click(*bench.panel, "revealPrediction");
        QCOMPARE(bench.panel->verdict()->score, 100);
        click(*bench.panel, "predictNext");
        QCOMPARE(bench.panel->number(), number + 1);
        QCOMPARE(int(bench.panel->state()), int(State::Predicting));
    }

    // Of several resolved together none follows from its own arrows: the next single one is asked for.
    void tiesAreLeftOut() {
        PredictBench bench("break");
        const auto all = bench.session.timeline().collisions();
        click(*bench.panel, "beginPrediction");
        if (bench.panel->state() == State::Predicting)
            QCOMPARE(all[std::size_t(bench.panel->number() - 1)].together, 1);
    }

    void aLookAheadIsNoticed() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        auto* hold = bench.panel->findChild<QAbstractButton*>("holdBefore");
        QVERIFY(!hold->isVisible());
        bench.playhead.setTime(bench.session.timeline().collisions()[0].time + 0.1);
        QVERIFY(hold->isVisible());
        click(*bench.panel, "holdBefore");
        QVERIFY(!hold->isVisible());
        QVERIFY(bench.playhead.time() < bench.session.timeline().collisions()[0].time);
    }

    void anotherRunEndsIt() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        bench.session.openBuiltin("head-on");
        QCOMPARE(int(bench.panel->state()), int(State::Invitation));
        Scene still = bench.session.scene();
        still.bodies.resize(1);
        QVERIFY(bench.session.open(still).empty());
        QVERIFY(!bench.panel->findChild<QAbstractButton*>("beginPrediction")->isVisible());
    }

    void fits_data() {
        QTest::addColumn<bool>("korean");
        QTest::addColumn<bool>("projector");
        for (const bool korean : {false, true})
            for (const bool projector : {false, true})
                QTest::addRow("%s%s", korean ? "Korean" : "English", projector ? ", projector" : "")
                    << korean << projector;
    }
    void fits() {
        QFETCH(bool, korean);
        QFETCH(bool, projector);
        useLanguage(*m_language, korean);
        PredictBench bench("glancing", projector);
        const auto check = [&] {
            QCoreApplication::processEvents();
            for (QLabel* l : bench.panel->findChildren<QLabel*>())
                if (l->isVisible() && !l->text().isEmpty()) {
                    const int needed = l->wordWrap() ? l->heightForWidth(l->width()) : l->sizeHint().height();
                    QVERIFY2(needed <= l->height() + 1, qPrintable(l->objectName() + ": " + l->text()));
                    QVERIFY2(l->wordWrap() || l->sizeHint().width() <= l->width() + 1, qPrintable(l->text()));
                }
            for (QAbstractButton* b : bench.panel->findChildren<QAbstractButton*>())
                if (b->isVisible()) {
                    QVERIFY2(b->sizeHint().width() <= b->width() + 1, qPrintable(b->text()));
                    QVERIFY2(b->height() >= (projector ? 36 : 24), qPrintable(b->text()));
                    QCOMPARE(hasHangul(b->text()), korean);
                }
            auto* scroll = bench.panel->findChild<QScrollArea*>();
            QVERIFY(!scroll->isVisible() || scroll->widget()->width() <= scroll->viewport()->width());
        };
        check();
        click(*bench.panel, "beginPrediction");
        check();
        for (const char* box : {"guessMomentum", "guessEnergy"})
            bench.panel->findChild<QCheckBox*>(box)->setChecked(true);
        check();
        click(*bench.panel, "guessMode");
        check();
        click(*bench.panel, "revealPrediction");
        check();
    }

    void everyWidgetHasItsWords() {
        PredictBench bench("two-balls");
        click(*bench.panel, "beginPrediction");
        for (QWidget* w : bench.panel->findChildren<QWidget*>())
            if (w->focusPolicy() != Qt::NoFocus && w->isVisible()) {
                QVERIFY2(!w->objectName().isEmpty(), w->metaObject()->className());
                QVERIFY2(!w->accessibleName().isEmpty() || qobject_cast<QCheckBox*>(w),
                         qPrintable(w->objectName()));
                QVERIFY2(!w->toolTip().isEmpty(), qPrintable(w->objectName()));
            }
    }
};

QTEST_MAIN(TestPredict)
#include "test_predict.moc"

// The typesetter, the figures and the panel: nothing clipped, labels off the arrows, real keys and clicks.
#include "core/scene/builtin.h"
#include "core/study/digits_left.h"
#include "ui/steps/step_panel.h"
#include "ui/words/language.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

using namespace thetalane;

namespace {

std::shared_ptr<const Run> runOf(const char* id) {
    return std::make_shared<const Run>(std::get<Run>(simulate(*builtinScene(id), {})));
}

const std::array scenes{"two-balls", "head-on", "glancing", "inelastic", "cradle", "rack", "heavy-light"};

struct Bench {
    Language language;
    Appearance appearance;
    Session session;
    Playhead playhead{session};
    StepPanel panel{Context{session, playhead, appearance}};

    Bench() {
        language.use(Language::Code::English);
        panel.resize(360, 700);
        panel.show();
    }
    template <class T> T* find(const QString& name) const { return panel.findChild<T*>(name); }
    StepCard* card(int stage) const { return find<StepCard>(QStringLiteral("stepCard%1").arg(stage)); }

    // Whatever a person can read or have read out.
    QStringList texts() const {
        QStringList all;
        for (const QWidget* w : panel.findChildren<QWidget*>()) {
            all << w->toolTip() << w->accessibleName();
            if (const auto* label = qobject_cast<const QLabel*>(w))
                all << label->text();
            if (const auto* button = qobject_cast<const QAbstractButton*>(w))
                all << button->text();
        }
        all.removeAll(QString());
        return all;
    }
};

} // namespace

class TestSteps : public QObject {
    Q_OBJECT

private slots:
    // Each stage holds; a hand on the keys takes over; after the last it begins anew.
    void thePlayerGoesThroughTheStages() {
        Bench b;
        b.panel.player().setHold(40);
        b.panel.player().setPlaying(true);
        QVERIFY(!b.panel.player().playing()); // nothing is open
        b.playhead.select(0);
        auto* play = b.find<QToolButton>("playSteps");
        QSignalSpy stages(&b.playhead, &Playhead::stageChanged);
        QTest::mouseClick(play, Qt::LeftButton);
        QVERIFY(b.panel.player().playing());
        QTRY_COMPARE(int(b.playhead.stage()), stageCount - 1);
        QVERIFY(!b.panel.player().playing());
        QCOMPARE(stages.count(), stageCount - 1);
        QTest::mouseClick(play, Qt::LeftButton);
        QCOMPARE(int(b.playhead.stage()), 0);
        QTRY_COMPARE(int(b.playhead.stage()), 1);
        QTest::keyClick(&b.panel, Qt::Key_Down);
        QVERIFY(!b.panel.player().playing());
        QCOMPARE(int(b.playhead.stage()), 2);
    }

    void fractionStandsOnTheAxis() {
        const Appearance appearance;
        const FormulaLayout layout(appearance, 20);
        const FormulaBox box = layout.box(row({op("="), fraction(number(1.5), number(250))}));
        const auto rects = inkRects(box, {0, 0});
        const double bar = rects.back().center().y();
        QVERIFY(std::abs(bar + layout.axis()) < 0.6);
        QVERIFY(std::abs(rects.front().center().y() - bar) < 1.5); // the equals sign
        QVERIFY(rects[1].bottom() < rects.back().top());           // above the stroke
        QVERIFY(rects[2].top() > rects.back().bottom());           // below it
        QVERIFY(std::abs(rects[1].center().x() - rects[2].center().x()) < 1.5);
    }

    void rootsAndParenthesesGrow() {
        const Appearance appearance;
        const FormulaLayout layout(appearance, 20);
        const Formula tall = fraction(symbol("a"), symbol("b"));
        const FormulaBox inside = layout.box(tall);
        const FormulaBox held = layout.box(group(tall));
        const FormulaBox under = layout.box(root(tall));
        QVERIFY(held.ascent >= inside.ascent && held.descent >= inside.descent);
        QVERIFY(under.ascent > inside.ascent && under.width > inside.width);
        QVERIFY(held.width > inside.width);
    }

    void nothingIsClipped_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<bool>("projector");
        QTest::newRow("340") << 340 << false;
        QTest::newRow("360") << 360 << false;
        QTest::newRow("520") << 520 << false;
        QTest::newRow("projector 520") << 520 << true;
    }

    void nothingIsClipped() {
        QFETCH(int, width);
        QFETCH(bool, projector);
        Appearance appearance;
        appearance.setProjector(projector);
        FormulaView view(appearance);
        const int inner =
            width - 4 * appearance.unit() - appearance.unit() - 2; // the card's margins, the bar
        for (const char* id : scenes) {
            const auto run = runOf(id);
            const auto collisions = run->timeline.collisions();
            for (std::size_t k = 0; k < std::min<std::size_t>(3, collisions.size()); ++k)
                for (const WorkedStep& step : workedSteps(run->scene, collisions, k)) {
                    view.setLines(step.lines);
                    const QRectF frame(0, 0, inner, view.heightForWidth(inner));
                    for (const QRectF& ink : view.inkRectsAt(inner))
                        QVERIFY2(frame.adjusted(-1, -1, 1, 1).contains(ink),
                                 qPrintable(QStringLiteral("%1 %2 stage %3: %4…%5 of %6")
                                                .arg(id)
                                                .arg(k + 1)
                                                .arg(int(step.stage))
                                                .arg(ink.left())
                                                .arg(ink.right())
                                                .arg(inner)));
                }
        }
    }

    void narrowBreaksWideDoesNot() {
        const Appearance appearance;
        FormulaView view(appearance);
        const auto run = runOf("two-balls");
        view.setLines({workedSteps(run->scene, run->timeline.collisions()[0])[2].lines[0]});
        QVERIFY(view.heightForWidth(300) > 1.7 * view.heightForWidth(900));
    }

    void labelsKeepOffTheArrows() {
        Appearance appearance;
        for (const char* id : scenes) {
            const auto run = runOf(id);
            for (int stage = 0; stage < stageCount; ++stage) {
                const QSizeF size(330, 220);
                const FigureCanvas canvas =
                    stageFigure(run->scene, run->timeline.collisions(), 0, Stage(stage), appearance, size);
                QVERIFY(!canvas.labels().empty());
                for (const FigureLabel& label : canvas.labels()) {
                    const QString where = QStringLiteral("%1 stage %2").arg(id).arg(stage);
                    QVERIFY2(QRectF(QPointF(), size).contains(label.place), qPrintable(where));
                    for (const QLineF& stroke : canvas.strokes())
                        for (int i = 0; i <= 50; ++i)
                            QVERIFY2(!label.place.contains(stroke.pointAt(i / 50.0)), qPrintable(where));
                }
            }
        }
    }

    void invitesAndGoes() {
        Bench b;
        auto* go = b.find<QPushButton>("goToFirstCollision");
        QVERIFY(go->isVisible());
        QVERIFY(go->height() >= 24);
        QTest::mouseClick(go, Qt::LeftButton);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
        QVERIFY(!go->isVisible());
        QVERIFY(b.card(0)->isVisible() && b.card(0)->isOpen());
    }

    void saysWhereNothingCollides() {
        Bench b;
        Scene lonely = b.session.scene();
        lonely.bodies.resize(1);
        lonely.frame.reset();
        QVERIFY(b.session.setScene(lonely).empty());
        QVERIFY(!b.find<QPushButton>("goToFirstCollision")->isVisible());
        QCOMPARE(b.find<QLabel>("invitation")->text(), QString("Nothing collides in this run."));
    }

    // Against a run with 113 bits; of a run in steps nothing is said.
    void saysHowManyDigitsAreLeft() {
        Bench b;
        QVERIFY(b.session.openBuiltin("rack"));
        EngineSettings exact = b.session.run()->settings;
        exact.precision = Precision::Quad;
        const Run truth = std::get<Run>(simulate(b.session.scene(), exact));
        const auto common = digitsInCommon(truth, *b.session.run());
        static const QRegularExpression said(QStringLiteral("digits&nbsp;left:&nbsp;(\\d+)"));
        for (std::size_t k = 0; k < common.size(); ++k) {
            b.playhead.select(k);
            const auto found = said.match(b.find<QLabel>("collisionPartners")->text());
            QVERIFY(found.hasMatch());
            QVERIFY2(std::abs(found.captured(1).toInt() + 0.5 - common[k]) < 1.6,
                     qPrintable(QStringLiteral("%1: %2").arg(found.captured(1)).arg(common[k])));
        }
        EngineSettings steps = b.session.run()->settings;
        steps.kind = EngineKind::Stepped;
        QVERIFY(!b.session.setEngine(steps));
        b.playhead.select(0);
        QVERIFY(!b.find<QLabel>("collisionPartners")->text().contains("left"));
    }
    void clicksAndKeysChooseTheStage() {
        Bench b;
        b.playhead.select(0);
        auto* header = b.find<StepHeader>("stepHeader2");
        QTest::mouseClick(header, Qt::LeftButton);
        QCOMPARE(b.playhead.stage(), Stage::Rotation);
        QVERIFY(b.card(2)->isOpen() && !b.card(0)->isOpen());
        b.panel.setFocus();
        QTest::keyClick(&b.panel, Qt::Key_Down);
        QCOMPARE(b.playhead.stage(), Stage::Exchange);
        QTest::keyClick(&b.panel, Qt::Key_Up);
        QTest::keyClick(&b.panel, Qt::Key_Up);
        QCOMPARE(b.playhead.stage(), Stage::Split);
        // From wherever the focus is in the panel.
        QTest::keyClick(b.find<StepHeader>("stepHeader4"), Qt::Key_Down);
        QCOMPARE(b.playhead.stage(), Stage::Rotation);
        QTest::keyClick(b.card(2)->findChild<FormulaView*>(), Qt::Key_Up);
        QCOMPARE(b.playhead.stage(), Stage::Split);
        // Opened all the way, the open header in sight.
        auto* open = b.card(1);
        QTRY_COMPARE(open->height(), open->heightForWidth(open->width()));
        QTRY_VERIFY(open->height() > 300);
        QTRY_COMPARE(b.card(2)->height(), b.card(2)->headerHeight());
        const auto* scroll = b.find<QScrollArea>("stepScroll");
        QVERIFY(open->mapTo(scroll->viewport(), QPoint()).y() >= 0);
    }

    void previousAndNext() {
        Bench b;
        b.playhead.select(0);
        auto* previous = b.find<QToolButton>("previousCollision");
        auto* next = b.find<QToolButton>("nextCollision");
        QVERIFY(!previous->isEnabled());
        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(1));
        QVERIFY(b.find<QLabel>("collisionTitle")->text().startsWith("Collision 2 of "));
        QTest::mouseClick(previous, Qt::LeftButton);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
    }

    void copiesAllDigits() {
        Bench b;
        b.playhead.select(0);
        auto* view = b.card(0)->findChild<FormulaView*>();
        QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier);
        const QString text = QGuiApplication::clipboard()->text();
        QCOMPARE(text.count('\n') + 1, 7);
        const double Z = b.session.timeline().collisions()[0].steps.contact.Z;
        QVERIFY2(text.contains(QString::number(Z, 'g', QLocale::FloatingPointShortest)), qPrintable(text));
    }

    void languageChangesEverythingAtOnce() {
        Bench b;
        QVERIFY(b.session.openBuiltin("rack"));
        b.playhead.select(0);
        const QStringList english = b.texts();
        b.language.use(Language::Code::Korean);
        QCoreApplication::sendPostedEvents();
        const QStringList korean = b.texts();
        QVERIFY(english != korean);
        static const QRegularExpression hangul("[가-힣]");
        static const QRegularExpression markup("<[^>]*>|&nbsp;");
        static const QRegularExpression latin("[A-Za-z]{2,}");
        for (QString text : korean) {
            text.remove(markup).remove("Ctrl").remove("F1");
            QVERIFY2(!text.contains(latin), qPrintable(text));
        }
        QVERIFY(korean.join(' ').contains(hangul));
        for (int i = 0; i < stageCount; ++i)
            QVERIFY(b.find<QLabel>(QStringLiteral("stepSentence%1").arg(i))->text().contains(hangul));
        b.language.use(Language::Code::English);
        QCoreApplication::sendPostedEvents();
        QCOMPARE(b.texts(), english);
    }

    void followsTheRun() {
        Bench b;
        b.playhead.select(2);
        QVERIFY(b.session.openBuiltin("cradle"));
        QVERIFY(b.find<QPushButton>("goToFirstCollision")->isVisible());
        b.playhead.select(1);
        QVERIFY(b.find<QLabel>("collisionTitle")->text().startsWith("Collision 2 of "));
        b.appearance.setProjector(true);
        QVERIFY(b.find<StepHeader>("stepHeader1")->height() >= 36);
    }
};

QTEST_MAIN(TestSteps)
#include "test_steps.moc"

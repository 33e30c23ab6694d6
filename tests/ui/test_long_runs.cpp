// Runs that are too long to be kept whole: whatever is seen of them, in whatever order, is to the bit what a
// run kept whole shows, with its numbers; and little of it is kept.
#include "long_run_bench.h"
#include "ui/count_text.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"
#include "ui/lane/pin_badge.h"
#include "ui/lane/scale.h"
#include "ui/panels/collision_list.h"
#include "ui/panels/scrub_bar.h"
#include "ui/panels/timeline_bar.h"
#include "ui/steps/step_panel.h"

#include <QElapsedTimer>
#include <QMenu>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTableView>

#include <algorithm>

using namespace thetalane;

class TestLongRuns : public QObject {
    Q_OBJECT

    Language m_language;

private slots:
    void initTestCase_data() { addLanguages(); }
    void init() {
        QFETCH_GLOBAL(bool, korean);
        useLanguage(m_language, korean);
    }

    // By the keys, through every border there is, to the end and back.
    void steppingCrossesChapters() {
        LongRunBench b;
        QVERIFY(b.count() > 5 * small);
        QVERIFY(b.session.timeline().collisionCount() < b.count());
        StepPanel steps(b.context);
        ScrubBar scrub(b.context);
        showPanel(scrub, {600, 32});
        auto* title = steps.findChild<QLabel*>("collisionTitle");
        QFETCH_GLOBAL(bool, korean);
        const QString pattern = korean ? "충돌 %1 / %2" : "Collision %1 of %2";
        for (std::int64_t number = 1; number <= b.count(); ++number) {
            QTest::keyClick(&scrub, Qt::Key_Right, Qt::ControlModifier);
            QVERIFY(b.showsCollision(number));
            QCOMPARE(title->text(), pattern.arg(countText(number), countText(b.count())));
        }
        QVERIFY(b.session.part().last);
        QTest::keyClick(&scrub, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(b.showsCollision(b.count()));
        for (std::int64_t number = b.count() - 1; number >= 1; --number) {
            QTest::keyClick(&scrub, Qt::Key_Left, Qt::ControlModifier);
            QVERIFY(b.showsCollision(number));
        }
        QVERIFY(!b.playhead.canStepCollisions(-1));
    }

    // Between two collisions, at a border too.
    void steppingFromAnyMoment() {
        LongRunBench b;
        for (std::int64_t k = 1; k < b.count(); ++k) {
            const double before = b.whole.collisions()[std::size_t(k - 1)].time;
            const double after = b.whole.collisions()[std::size_t(k)].time;
            b.playhead.setTime(before + (after - before) / 2);
            QVERIFY(!b.playhead.selected() && b.showsTheWhole());
            b.playhead.stepCollisions(k % 2 ? 1 : -1);
            QVERIFY(b.showsCollision(k % 2 ? k + 1 : k));
        }
    }

    void anyMomentInAnyOrder() {
        LongRunBench b;
        TimelineBar bar(b.context);
        LanePanel lane(b.context);
        showPanel(bar, {1000, 60});
        auto* scrub = bar.findChild<ScrubBar*>();
        QRandomGenerator random(4);
        for (int k = 0; k < 200; ++k) {
            const double t = random.generateDouble() * b.playhead.end();
            b.playhead.setTime(t);
            QCOMPARE(b.playhead.time(), t);
            QVERIFY(b.showsTheWhole());
            QVERIFY(lane.scene().states() == b.whole.stateAt(t));
            const auto part = b.session.part();
            QVERIFY(part.from <= t && (t < part.to || part.last));
        }
        // By mouse: all of the run is on the line.
        for (const int x : {300, 520, 200, 450}) {
            QTest::mousePress(scrub, Qt::LeftButton, {}, {x, 16});
            QTest::mouseRelease(scrub, Qt::LeftButton, {}, {x, 16});
            const double reach = scrub->timeAt(ScrubBar::reach) - scrub->timeAt(0);
            QVERIFY(std::abs(b.playhead.time() - scrub->timeAt(x)) <= reach);
            QVERIFY(b.showsTheWhole());
        }
    }

    void playingCrossesChapters() {
        LongRunBench b(smallChapters(150));
        b.playhead.setRate(1);
        b.playhead.setPlaying(true);
        int chapters = 0;
        connect(&b.session, &Session::chapterChanged, this, [&] { ++chapters; });
        QElapsedTimer clock;
        clock.start();
        while (b.playhead.playing() && clock.elapsed() < 20'000) {
            const double before = b.playhead.time();
            b.playhead.advance(1.0 / 60);
            QVERIFY(b.playhead.time() <= before + 1.0001 / 60);
            QVERIFY(b.showsTheWhole());
        }
        QCOMPARE(b.playhead.time(), b.playhead.end());
        QVERIFY(chapters >= int(b.count() / 200));
    }

    void fewChaptersAreKept() {
        LongRunBench b;
        LanePanel lane(b.context);
        StepPanel steps(b.context);
        CollisionList list(b.context);
        TimelineBar bar(b.context);
        std::vector<std::weak_ptr<const Run>> seen{b.session.run()};
        connect(&b.session, &Session::chapterChanged, this, [&](const auto& run) { seen.push_back(run); });
        for (std::int64_t number = 1; number <= b.count(); number += small / 3) {
            b.playhead.selectNumber(number);
            const auto alive =
                std::count_if(seen.begin(), seen.end(), [](auto& run) { return !run.expired(); });
            QVERIFY2(alive <= 4, qPrintable(QString::number(alive)));
        }
        QVERIFY(seen.size() > 5);
    }

    // What is not computed yet is gone to when it is; meanwhile the window goes on.
    void aheadOfTheComputing() {
        PanelBench b;
        TimelineBar bar(b.context);
        showPanel(bar, {1000, 60});
        b.session.openBuiltin("gas-1000");
        QVERIFY(!b.session.part().ended && b.session.part().isWhole() == false);
        QVERIFY(b.session.reach() > 0 && b.session.reach() < 10);
        QCOMPARE(b.playhead.end(), 10.0);
        auto* scrub = bar.findChild<ScrubBar*>();
        QVERIFY(!scrub->hintAt(scrub->xAt(9.9)).isEmpty()); // not computed yet
        b.playhead.setTime(9);
        QVERIFY(b.playhead.time() < 9);
        QTRY_COMPARE_WITH_TIMEOUT(b.playhead.time(), 9.0, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(b.session.part().ended, 20'000);
        QVERIFY(scrub->hintAt(scrub->xAt(9.9)).isEmpty());
        QVERIFY(b.session.part().collisionCount > 300'000);
        QVERIFY(b.session.timeline().collisions().size() < 13'000);
        // A wish is forgotten by whoever goes elsewhere.
        b.playhead.runUntil(60);
        b.playhead.setTime(59);
        b.playhead.setTime(0.1);
        QTest::qWait(200);
        QCOMPARE(b.playhead.time(), 0.1);
        b.session.openBuiltin("two-balls"); // in the midst of it
        QVERIFY(b.session.part().ended && b.session.part().isWhole());
        QCOMPARE(b.session.until(), 10.0);
    }

    // Where a chapter takes long, the window does not wait for it.
    void aChapterThatTakesLong() {
        Session::Limits limits = smallChapters();
        limits.patience = 0;
        LongRunBench b(limits);
        QRandomGenerator random(6);
        for (int k = 0; k < 20; ++k) {
            const std::int64_t number = 1 + random.bounded(int(b.count()));
            b.playhead.selectNumber(number);
            QTRY_VERIFY(b.showsCollision(number));
            const double t = random.generateDouble() * b.playhead.end();
            b.playhead.setTime(t);
            QTRY_COMPARE(b.playhead.time(), t);
            QVERIFY(b.showsTheWhole());
        }
    }

    void longerAndShorter() {
        LongRunBench b;
        TimelineBar bar(b.context);
        showPanel(bar, {1000, 60});
        auto* button = bar.findChild<QPushButton*>("untilButton");
        QVERIFY(button->isVisible());
        QCOMPARE(button->text(), QString("/ 1 s"));
        b.playhead.selectNumber(3 * small);
        b.playhead.setStage(Stage(3));
        button->setFocus(Qt::TabFocusReason);
        auto* menu = bar.findChild<QMenu*>("untilMenu");
        QTimer::singleShot(0, this, [&] {
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        QTest::keyClick(button, Qt::Key_Space);
        QTRY_COMPARE(b.session.until(), 10.0);
        QCOMPARE(button->text(), QString("/ 10 s"));
        QTRY_VERIFY(b.showsCollision(3 * small));
        QCOMPARE(b.playhead.stage(), Stage(3));
        QTRY_COMPARE(b.session.part().computedTo, 10.0);
        b.playhead.setTime(10);
        b.playhead.runUntil(1);
        QTRY_COMPARE(b.playhead.time(), 1.0);
        b.session.reset(); // that is about the scene
        QCOMPARE(b.session.until(), 1.0);
        b.session.openBuiltin("bowling"); // it ends by itself
        QVERIFY(!button->isVisible());
        QVERIFY(b.session.setUntil(-1).has_value());
        QCOMPARE(b.session.until(), 10.0);
    }

    void theListTurnsItsPages() {
        LongRunBench b;
        CollisionList list(b.context);
        showPanel(list, {360, 400});
        auto* table = list.findChild<QTableView*>("collisionTable");
        const auto number = [&](int row) { return table->model()->index(row, 0).data().toString(); };
        const int rows = table->model()->rowCount();
        QVERIFY(message(list, "whichCollisions").contains(countText(rows)));
        b.playhead.selectNumber(rows);
        QTest::keyClick(table, Qt::Key_Down);
        QVERIFY(b.showsCollision(rows + 1));
        QCOMPARE(number(0), countText(rows + 1));
        QCOMPARE(table->currentIndex().row(), 0);
        QTest::keyClick(table, Qt::Key_Up);
        QVERIFY(b.showsCollision(rows));
        click(list, "laterCollisions");
        QVERIFY(b.showsCollision(rows + 1));
        QVERIFY(table->selectionModel()->isRowSelected(0));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(4, 1)).center());
        QVERIFY(b.showsCollision(rows + 5));
        click(list, "earlierCollisions");
        QVERIFY(b.showsCollision(rows));
        b.playhead.selectNumber(b.count());
        QVERIFY(!list.findChild<QAbstractButton*>("laterCollisions")->isEnabled());
        // What was passed while nobody looked is there for whoever looks again.
        list.hide();
        b.playhead.selectNumber(1);
        list.show();
        QCOMPARE(number(0), QString("1"));
        b.session.openBuiltin("rack");
        QVERIFY(message(list, "whichCollisions").isEmpty());
    }

    // The next collision of a body may be in the next chapter: a click on the body opens it.
    void clicksReachBeyond() {
        LongRunBench b;
        LanePanel lane(b.context);
        b.appearance.setReducedMotion(true);
        showPanel(lane, {600, 600});
        const auto inChapter = b.session.timeline().collisions();
        const double border = b.session.part().to;
        b.playhead.setTime((inChapter.back().time + border) / 2);
        const auto next = std::int64_t(inChapter.size()) + 1;
        const int body = b.whole.collisions()[std::size_t(next - 1)].first;
        QVERIFY(!lane.scene().nextCollisionOf(body));
        const QPointF at = toUnits(b.whole.bodyAt(std::size_t(body), b.playhead.time()).position);
        QTest::mouseClick(lane.view().viewport(), Qt::LeftButton, {}, lane.view().mapFromScene(at));
        QVERIFY(b.showsCollision(next));
    }

    void pinsAreCountedRightOrNotAtAll() {
        LongRunBench few(smallChapters(3), pinsInABox(), 2);
        PinBadge hidden(few.context);
        QVERIFY(!hidden.isHidden());
        few.playhead.setTime(2);
        QVERIFY(few.session.part().collisionsBefore > 0);
        QVERIFY(hidden.isHidden()); // who was touched before is not known
        few.playhead.setTime(0);
        QVERIFY(!hidden.isHidden() && hidden.touched() == 0);

        LongRunBench many(smallChapters(400), pinsInABox(), 60);
        PinBadge badge(many.context);
        many.playhead.setTime(60);
        QVERIFY(many.session.part().collisionsBefore > 0);
        QVERIFY(!badge.isHidden());
        QCOMPARE(badge.touched(), 8);
        QCOMPARE(badge.down(), 8);
    }

    void otherEnginesAreKeptWhole() {
        LongRunBench b;
        EngineSettings settings = b.session.run()->settings;
        settings.kind = EngineKind::Stepped;
        QVERIFY(!b.session.setEngine(settings));
        QVERIFY(b.session.part().isWhole() && b.session.part().ended);
        QVERIFY(b.session.timeline().collisionCount() > small);
        QCOMPARE(b.session.run()->settings.maxCollisions, std::int64_t(125'000));
        settings = b.session.run()->settings;
        settings.kind = EngineKind::Event;
        QVERIFY(!b.session.setEngine(settings));
        QVERIFY(b.session.run()->settings.maxCollisions > 125'000);
    }

    void countsAreGrouped() {
        QCOMPARE(countText(0), QString("0"));
        QCOMPARE(countText(1234), QString("1234"));
        QCOMPARE(countText(12345), QString("12,345"));
        QCOMPARE(countText(20'700'123), QString("20,700,123"));
    }
};

QTEST_MAIN(TestLongRuns)
#include "test_long_runs.moc"

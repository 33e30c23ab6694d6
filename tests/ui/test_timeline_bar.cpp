// The timeline bar by mouse, wheel and keyboard: every button, the ticks, dragging, and very many collisions.
#include "panel_bench.h"
#include "ui/panels/scrub_bar.h"
#include "ui/panels/time_readout.h"
#include "ui/panels/timeline_bar.h"

#include <QElapsedTimer>
#include <QWheelEvent>

using namespace thetalane;

class TestTimelineBar : public QObject {
    Q_OBJECT

    Language m_language;

private slots:
    void initTestCase_data() { addLanguages(); }
    void init() {
        QFETCH_GLOBAL(bool, korean);
        useLanguage(m_language, korean);
    }

    void buttons() {
        PanelBench b;
        b.session.openBuiltin("rack");
        TimelineBar bar(b.context);
        showPanel(bar, {684, 100});
        const auto collisions = b.session.timeline().collisions();
        click(bar, "collisionForwardButton");
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
        QCOMPARE(b.playhead.time(), collisions[0].time);
        click(bar, "collisionForwardButton");
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(1));
        click(bar, "collisionBackButton");
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
        QVERIFY(!bar.findChild<QAbstractButton*>("collisionBackButton")->isEnabled());

        const double before = b.playhead.time();
        click(bar, "frameForwardButton");
        QCOMPARE(b.playhead.time(), before + 1.0 / 60);
        QVERIFY(!b.playhead.selected());
        click(bar, "frameBackButton");
        QVERIFY(std::abs(b.playhead.time() - before) < 1e-15);

        click(bar, "playButton");
        QVERIFY(b.playhead.playing());
        QTRY_VERIFY(b.playhead.time() > before);
        click(bar, "playButton");
        QVERIFY(!b.playhead.playing());
        click(bar, "startButton");
        QCOMPARE(b.playhead.time(), 0.0);
        QVERIFY(!bar.findChild<QAbstractButton*>("startButton")->isEnabled());
    }

    void rates() {
        PanelBench b;
        TimelineBar bar(b.context);
        showPanel(bar, {684, 100});
        auto* label = bar.findChild<QLabel*>("rateLabel");
        QCOMPARE(label->text(), QString("1×"));
        for (int i = 0; i < 5; ++i)
            click(bar, "slowerButton");
        QCOMPARE(b.playhead.rate(), 1.0 / 32);
        QCOMPARE(label->text(), QString("1/32×"));
        QVERIFY(!bar.findChild<QAbstractButton*>("slowerButton")->isEnabled());
        for (int i = 0; i < 7; ++i)
            click(bar, "fasterButton");
        QCOMPARE(b.playhead.rate(), 4.0);
        QVERIFY(!bar.findChild<QAbstractButton*>("fasterButton")->isEnabled());
    }

    void scrubbing() {
        PanelBench b; // two balls, with walls
        ScrubBar scrub(b.context);
        showPanel(scrub, {600, 32});
        const auto collisions = b.session.timeline().collisions();
        QVERIFY(collisions.size() > 3);
        const int tick = int(scrub.xAt(collisions[2].time));
        QTest::mouseClick(&scrub, Qt::LeftButton, {}, {tick + 1, 16});
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(2));
        QCOMPARE(b.playhead.time(), collisions[2].time); // the very instant, not the pixel's
        QVERIFY(scrub.hintAt(tick).startsWith("3: "));
        QVERIFY(scrub.hintAt(tick).contains("→"));

        int away = tick;
        while (scrub.collisionNear(away))
            ++away;
        QVERIFY(away <= tick + 200 && scrub.hintAt(away).isEmpty());
        QTest::mousePress(&scrub, Qt::LeftButton, {}, {away, 16});
        QVERIFY(!b.playhead.selected());
        QCOMPARE(b.playhead.time(), scrub.timeAt(away));
        // Dragging, over ticks too, takes the time along and selects nothing.
        for (int x : {tick, 400, 450})
            QTest::mouseMove(&scrub, {x, 16});
        QTRY_COMPARE(b.playhead.time(), scrub.timeAt(450));
        QVERIFY(!b.playhead.selected());
        QTest::mouseMove(&scrub, {900, 16});
        QTRY_COMPARE(b.playhead.time(), b.playhead.end());
        QTest::mouseRelease(&scrub, Qt::LeftButton, {}, {450, 16});
    }

    void keysAndWheel() {
        PanelBench b;
        ScrubBar scrub(b.context);
        showPanel(scrub, {600, 32});
        scrub.setFocus();
        QTest::keyClick(&scrub, Qt::Key_Right);
        QCOMPARE(b.playhead.time(), 1.0 / 60);
        QTest::keyClick(&scrub, Qt::Key_Left);
        QCOMPARE(b.playhead.time(), 0.0);
        QTest::keyClick(&scrub, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
        QTest::keyClick(&scrub, Qt::Key_End);
        QCOMPARE(b.playhead.time(), b.playhead.end());
        QTest::keyClick(&scrub, Qt::Key_Home);
        QCOMPARE(b.playhead.time(), 0.0);
        QWheelEvent wheel({300, 16}, scrub.mapToGlobal(QPointF(300, 16)), {}, {0, 240}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&scrub, &wheel);
        QCOMPARE(b.playhead.time(), 2 * (1.0 / 60));
    }

    void sharedInstantsAreOneTick() {
        PanelBench b;
        Scene scene; // one ball on two others at once, as mirror images
        scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {-1, 0}, {1, 0}},
                        {"B", BodyKind::Ball, 1, 0.1, {0, 0.1}, {}},
                        {"C", BodyKind::Ball, 1, 0.1, {0, -0.1}, {}}};
        QVERIFY(b.session.setScene(scene).empty());
        const auto collisions = b.session.timeline().collisions();
        QVERIFY(collisions.size() >= 2 && collisions[0].group == collisions[1].group);
        ScrubBar scrub(b.context);
        showPanel(scrub, {600, 32});
        const double x = scrub.xAt(collisions[0].time);
        QCOMPARE(scrub.collisionNear(x), std::optional<std::size_t>(0));
        QCOMPARE(scrub.hintAt(x).count('\n'), 1); // one more line: how many more
    }

    void tenThousandCollisionsStayFast() {
        PanelBench b;
        Scene scene; // one ball between two near walls
        scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {0, 0}, {250, 0}}};
        scene.frame = Frame{-0.2, 0.2, {}, {}, 1};
        QVERIFY(b.session.setScene(scene).empty());
        QVERIFY(b.session.timeline().collisions().size() > 10'000);
        ScrubBar scrub(b.context);
        showPanel(scrub, {600, 32});
        scrub.grab();
        QElapsedTimer clock;
        clock.start();
        for (int i = 0; i < 100; ++i) {
            b.playhead.setTime(b.playhead.end() * i / 100);
            scrub.grab();
            scrub.hintAt(6.0 * i);
        }
        QVERIFY2(clock.elapsed() < 1600, "a frame has 16 ms");
    }

    void readoutKeepsItsPlace() {
        PanelBench b;
        TimeReadout readout(b.context);
        b.playhead.setTime(1.2341);
        QCOMPARE(readout.text(), QString("1.234 s"));
        const QSize size = readout.sizeHint();
        b.playhead.setTime(1.1111);
        QCOMPARE(readout.sizeHint(), size);
    }

    void wordsFollowTheLanguage() {
        PanelBench b;
        TimelineBar bar(b.context);
        auto* play = bar.findChild<QAbstractButton*>("playButton");
        auto* next = bar.findChild<QAbstractButton*>("collisionForwardButton");
        useLanguage(m_language, true);
        QCOMPARE(play->toolTip(), QString("재생 (스페이스 바)"));
        QCOMPARE(next->toolTip(), QString("다음 충돌 (Ctrl+→)"));
        useLanguage(m_language, false);
        QCOMPARE(play->toolTip(), QString("Play (Space)"));
        QCOMPARE(next->toolTip(), QString("Next collision (Ctrl+→)"));
    }

    void fitsANarrowWindow() {
        PanelBench b;
        TimelineBar bar(b.context);
        for (const bool projector : {false, true}) {
            b.appearance.setProjector(projector);
            QVERIFY(bar.minimumSizeHint().width() <= 684);
            for (auto* button : bar.findChildren<QAbstractButton*>()) {
                QVERIFY(button->sizeHint().height() >= (projector ? 36 : 24));
                QVERIFY(!button->objectName().isEmpty() && !button->toolTip().isEmpty() &&
                        !button->accessibleName().isEmpty());
            }
        }
    }
};

QTEST_MAIN(TestTimelineBar)
#include "test_timeline_bar.moc"

// Aiming on the lane and seeing the throw, by real mouse and key events; and what the session does with a
// throw.
#include "core/bowling/pinfall.h"
#include "tests/ui/panel_bench.h"
#include "ui/aim/aim_tool.h"
#include "ui/lane/body_item.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_strip.h"
#include "ui/lane/lane_view.h"
#include "ui/lane/pin_badge.h"
#include "ui/panels/spin_dial.h"
#include "ui/panels/throw_panel.h"
#include "ui/panels/timeline_bar.h"

#include <QComboBox>
#include <QMenu>
#include <QSettings>
#include <QShortcut>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>

using namespace thetalane;

namespace {

constexpr double foulLine = -18.288;

struct Alley : PanelBench {
    LanePanel panel{context};
    AimTool aim{context};

    explicit Alley(QSize size = {900, 600}) {
        appearance.setReducedMotion(true);
        panel.addTool(aim);
        session.openBuiltin("bowling");
        panel.resize(size);
        panel.show();
        QCoreApplication::processEvents();
    }
    LaneView& view() { return panel.view(); }
    const Throw& now() const { return *session.currentThrow(); }
    void lookAtFoulLine() {
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_B);
    }
    // The tests' own inverse: a millimetre is a unit, y up.
    static QPoint pixelOn(const QGraphicsView& view, const Vec2d& metres) {
        return view.viewportTransform().map(QPointF(metres.x * 1000, -metres.y * 1000)).toPoint();
    }
    QPoint pixel(const Vec2d& metres) { return pixelOn(view(), metres); }
    QPoint pixelOf(AimPart part) { return pixel(placeOf(part, now())); }
    double metresPerPixel() { return 1 / (1000 * view().transform().m11()); }

    static void move(QGraphicsView& on, const QPoint& at, Qt::MouseButtons held,
                     Qt::KeyboardModifiers keys = {}) {
        QWidget* port = on.viewport();
        QMouseEvent event(QEvent::MouseMove, at, port->mapToGlobal(at), Qt::NoButton, held, keys);
        QCoreApplication::sendEvent(port, &event);
    }
    void drag(QGraphicsView& on, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(on.viewport(), Qt::LeftButton, keys, from);
        for (int k = 1; k <= 4; ++k)
            move(on, from + (to - from) * k / 4, Qt::LeftButton, keys);
        QTest::mouseRelease(on.viewport(), Qt::LeftButton, keys, to);
    }
    void drag(AimPart part, const QPoint& way, Qt::KeyboardModifiers keys = {}) {
        const QPoint from = pixelOf(part);
        drag(view(), from, from + way, keys);
    }
};

bool near(double a, double b, double within) {
    return std::abs(a - b) <= within;
}

Throw hooking() {
    Throw t;
    t.spin = 300 * 2 * std::numbers::pi / 60;
    t.axis = 20 * std::numbers::pi / 180;
    t.direction = 2.5 * std::numbers::pi / 180;
    return t;
}

} // namespace

class TestAim : public QObject {
    Q_OBJECT

    QTemporaryDir m_settings;

private slots:
    void initTestCase() {
        QCoreApplication::setOrganizationName("ThetaLaneTest");
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_settings.path());
    }

    void theBallGoesAsFarAsTheHand() {
        Alley a;
        a.lookAtFoulLine();
        QSignalSpy runs(&a.session, &Session::runChanged);
        a.drag(AimPart::Ball, {40, 17}); // up and down is not along the foul line
        Throw expected;
        expected.position += 40 * a.metresPerPixel();
        QVERIFY(near(a.now().position, expected.position, 1e-12));
        expected.position = a.now().position;
        QVERIFY(a.now() == expected);
        QCOMPARE(a.session.scene().bodies[0].position.x, expected.position);
        QVERIFY(runs.count() >= 4);                        // live, at each move
        a.drag(AimPart::Ball, {40, 0}, Qt::ShiftModifier); // a tenth of the way
        QVERIFY(near(a.now().position, expected.position + 4 * a.metresPerPixel(), 1e-12));
    }

    void theBallStaysOnTheLaneAndSaysWhy() {
        Alley a;
        a.lookAtFoulLine();
        const QPoint from = a.pixelOf(AimPart::Ball);
        QTest::mousePress(a.view().viewport(), Qt::LeftButton, {}, from);
        Alley::move(a.view(), from - QPoint(200, 0), Qt::LeftButton);
        QCOMPARE(a.now().position, -1.0541 / 2);
        QVERIFY(!a.aim.limitText().isEmpty());
        Alley::move(a.view(), from + QPoint(10, 0), Qt::LeftButton); // the hand is where the ball is again
        QVERIFY(near(a.now().position, -0.41 + 10 * a.metresPerPixel(), 1e-12));
        QVERIFY(a.aim.limitText().isEmpty());
        QTest::mouseRelease(a.view().viewport(), Qt::LeftButton, {}, from);
    }

    void theTipAimsAndTheBeadIsTheSpeed() {
        Alley a;
        a.lookAtFoulLine();
        const Vec2d tip = placeOf(AimPart::Direction, a.now());
        a.drag(AimPart::Direction, {4, 0});
        const double there = tip.x + 4 * a.metresPerPixel();
        QVERIFY(near(std::tan(a.now().direction), (there - a.now().position) / (tip.y - foulLine), 1e-12));
        QCOMPARE(a.now().speed, 8.0);
        const Vec2d v = a.session.scene().bodies[0].velocity;
        QVERIFY(near(v.x / v.y, std::tan(a.now().direction), 1e-12));
        const double met = a.session.timeline().collisions()[0].time;
        a.drag(AimPart::Speed, {0, -25});
        QVERIFY(a.now().speed > 8.1);
        const double along = 25 * a.metresPerPixel() * std::cos(a.now().direction);
        QVERIFY(near(a.now().speed, 8 + along / metresPerAimedSpeed, 1e-9));
        QVERIFY(a.session.timeline().collisions()[0].time < met);
        a.drag(AimPart::Direction, {300, 0});
        QVERIFY(near(a.now().direction, 6 * std::numbers::pi / 180, 1e-12));
    }

    void roundTheBallTurnsTheAxis() {
        Alley a;
        a.lookAtFoulLine();
        const Vec2d ball{a.now().position, foulLine};
        // 30° to the left of where it goes, 0.3 m from its centre.
        const double bearing = a.now().direction - 30 * std::numbers::pi / 180;
        const Vec2d to = ball + Vec2d{std::sin(bearing), std::cos(bearing)} * 0.3;
        const QPoint from = a.pixelOf(AimPart::Rotation);
        a.drag(a.view(), from, a.pixel(to));
        QVERIFY(near(a.now().axis * 180 / std::numbers::pi, 30, 2)); // to a pixel or so
        const double rpm = a.now().spin * 60 / (2 * std::numbers::pi);
        QVERIFY2(near(rpm, (0.3 - rotationRing) / metresPerRotation, 20), qPrintable(QString::number(rpm)));
        QVERIFY(a.session.scene().bodies[0].spin == throwSpin(a.now()));
        QVERIFY(a.aim.valueText(AimPart::Rotation).contains("rpm"));
        a.drag(AimPart::Rotation, {0, -400});
        QVERIFY(near(a.now().spin * 60 / (2 * std::numbers::pi), 600, 1e-9));
    }

    void escapeBringsBackTheVeryBits() {
        for (const AimPart part : {AimPart::Ball, AimPart::Direction, AimPart::Speed, AimPart::Rotation}) {
            Alley a;
            a.session.setDelivery(hooking(), PinSet("1000000001"), a.session.laneConditions());
            a.lookAtFoulLine();
            const Subject before = a.session.subject();
            const QPoint from = a.pixelOf(part);
            QTest::mousePress(a.view().viewport(), Qt::LeftButton, {}, from);
            Alley::move(a.view(), from + QPoint(23, -31), Qt::LeftButton);
            QVERIFY(!(a.session.subject() == before));
            QTest::keyClick(&a.view(), Qt::Key_Escape);
            QVERIFY(a.session.subject() == before);
            QVERIFY(a.session.scene() == before.scene);
            Alley::move(a.view(), from + QPoint(50, -50), Qt::LeftButton); // the button is still down
            QVERIFY(a.session.subject() == before);
            QTest::mouseRelease(a.view().viewport(), Qt::LeftButton, {}, from);
            QVERIFY(a.session.subject() == before);
        }
    }

    void theKeysDoTheSame() {
        Alley a;
        a.lookAtFoulLine();
        // The window's shortcuts have the arrows, as the program's do.
        int frames = 0, escapes = 0;
        for (const auto& [key, count] : {std::pair{Qt::Key_Left, &frames},
                                         {Qt::Key_Right, &frames},
                                         {Qt::Key_Up, &frames},
                                         {Qt::Key_Escape, &escapes}})
            connect(new QShortcut(key, &a.panel), &QShortcut::activated, &a.panel, [n = count] { ++*n; });
        a.panel.activateWindow();
        a.view().setFocus();
        QVERIFY(QTest::qWaitForWindowActive(&a.panel));
        const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = {}) {
            QTest::keyClick(a.panel.window()->windowHandle(), key, with); // as it comes from outside
        };
        press(Qt::Key_Right);
        QCOMPARE(frames, 1); // no part has the focus
        QVERIFY(a.now() == Throw{});

        press(Qt::Key_A);
        QVERIFY(a.aim.focused() == AimPart::Ball);
        press(Qt::Key_Right);
        QCOMPARE(a.now().position, -0.4);
        press(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(a.now().position, -0.401);
        press(Qt::Key_A);
        press(Qt::Key_Left);
        QVERIFY(near(a.now().direction * 180 / std::numbers::pi, 1.4, 1e-12));
        press(Qt::Key_A);
        press(Qt::Key_Up);
        QCOMPARE(a.now().speed, 8.1);
        press(Qt::Key_A);
        press(Qt::Key_Up);
        press(Qt::Key_Left);
        QVERIFY(near(a.now().spin, 10 * 2 * std::numbers::pi / 60, 1e-12));
        QVERIFY(near(a.now().axis * 180 / std::numbers::pi, 5, 1e-12));
        QCOMPARE(frames, 1);
        press(Qt::Key_Escape);
        QVERIFY(!a.aim.focused());
        QCOMPARE(escapes, 0);
        press(Qt::Key_Escape);
        QCOMPARE(escapes, 1);
        press(Qt::Key_Right);
        QCOMPARE(frames, 2);
    }

    void whatIsNotAHandleIsTheViews() {
        Alley a;
        a.lookAtFoulLine();
        const Camera before = a.view().camera();
        const QPoint empty = a.pixel({0.3, foulLine + 3});
        a.drag(a.view(), empty, empty + QPoint(0, 60));
        QVERIFY(a.view().camera().centre.y() < before.centre.y() - 1);
        QVERIFY(a.now() == Throw{});
        QTest::keyClick(&a.view(), Qt::Key_P);
        QTest::mouseClick(a.view().viewport(), Qt::LeftButton, {}, a.pixel({0, 0})); // the head pin
        QVERIFY(a.playhead.selectedNumber());
    }

    void nothingIsGrabbedWhilePlayingOrWithACollisionOpen() {
        Alley a;
        a.lookAtFoulLine();
        const Pointer ball{placeOf(AimPart::Ball, a.now()), 0.02, {}};
        QVERIFY(a.aim.handleAt(ball));
        a.playhead.setPlaying(true);
        QVERIFY(!a.aim.handleAt(ball));
        a.playhead.setPlaying(false);
        a.playhead.setTime(0);
        QVERIFY(a.aim.handleAt(ball));
        a.playhead.select(0);
        QVERIFY(!a.aim.handleAt(ball));
        a.playhead.clearSelection();
        QVERIFY(!a.aim.handleAt(ball)); // the ball is at the pins
        a.playhead.setTime(0);
        QVERIFY(a.aim.handleAt(ball));
        a.session.openBuiltin("two-balls");
        QVERIFY(!a.aim.handleAt(ball));
    }

    void handlesAreShownAndSaid() {
        Alley a;
        a.lookAtFoulLine();
        const QPoint at = a.pixelOf(AimPart::Direction);
        const QImage before = a.view().viewport()->grab().toImage();
        Alley::move(a.view(), at, Qt::NoButton);
        QCOMPARE(a.view().viewport()->cursor().shape(), Qt::SizeHorCursor);
        const QImage after = a.view().viewport()->grab().toImage();
        QVERIFY(before.pixelColor(at + QPoint(9, 0)) != after.pixelColor(at + QPoint(9, 0))); // the halo
        const auto handle = a.aim.handleAt({placeOf(AimPart::Direction, a.now()), 0.02, {}});
        QVERIFY(handle && handle->tip.contains("Shift"));
        QVERIFY(a.aim.valueText(AimPart::Ball).contains("35")); // the board: (0.527 + 0.41)/0.02703 = 34.67
        Alley::move(a.view(), a.pixel({0.4, foulLine + 3}), Qt::NoButton);
        QCOMPARE(a.view().viewport()->cursor().shape(), Qt::OpenHandCursor);
    }

    void theStripAimsToo() {
        Alley a;
        LaneStrip& strip = a.panel.strip();
        const double scale = 1000 * strip.transform().m11();
        const QPoint ball = Alley::pixelOn(strip, placeOf(AimPart::Ball, a.now()));
        a.drag(strip, ball, ball + QPoint(8, 0));
        QVERIFY(near(a.now().position, -0.41 + 8 / scale, 1e-12));
        const double set = a.now().position;
        const QPoint there = Alley::pixelOn(strip, placeOf(AimPart::Ball, a.now()));
        a.drag(strip, there, there + QPoint(8, 0), Qt::ShiftModifier);
        QVERIFY(near(a.now().position, set + 0.8 / scale, 1e-12));
        const QPoint tip = Alley::pixelOn(strip, placeOf(AimPart::Direction, a.now()));
        a.drag(strip, tip, tip + QPoint(4, 0));
        QVERIFY(a.now().direction > 2.5 * std::numbers::pi / 180);
        // A click looks there, as ever, and gives the ball to the keys.
        QTest::mouseClick(strip.viewport(), Qt::LeftButton, {},
                          Alley::pixelOn(strip, placeOf(AimPart::Ball, a.now())));
        QVERIFY(a.view().visibleRect().contains(QPointF(0, 1000 * -foulLine)));
        QVERIFY(a.aim.focused() == AimPart::Ball);
    }

    void aGestureIsOneForWhoeverUndoes() {
        Alley a;
        a.lookAtFoulLine();
        QSignalSpy grips(&a.view(), &LaneView::gripped);
        a.drag(AimPart::Ball, {12, 0});
        QCOMPARE(grips.count(), 2);
        QCOMPARE(grips[0][0].toBool(), true);
        QCOMPARE(grips[1][0].toBool(), false);
    }

    void foresightEndsAtTheFirstContact() {
        Alley a;
        const double end = a.session.timeline().endTime();
        const Collision first = a.session.timeline().collisions()[0];
        const double ball = a.session.timeline().bodyAt(0, first.time * 0.99).position.x;
        QVERIFY(a.session.timeline().collisions().size() > 5);
        a.session.setForesight(Foresight::FirstContact);
        QCOMPARE(a.session.timeline().collisions().size(), std::size_t(1));
        QVERIFY(a.session.timeline().endTime() < end);
        QCOMPARE(a.session.timeline().collisions()[0].time, first.time);
        QCOMPARE(a.session.timeline().bodyAt(0, first.time * 0.99).position.x, ball);
        QCOMPARE(a.playhead.end(), a.session.shownUntil());

        // Thrown, it is shown whole; from where it stood.
        a.playhead.setTime(1);
        a.playhead.setPlaying(true);
        QVERIFY(a.playhead.playing());
        QCOMPARE(a.playhead.time(), 1.0);
        QVERIFY(a.session.foresight() == Foresight::Whole);
        QVERIFY(a.session.timeline().collisions().size() > 5);

        a.session.setForesight(Foresight::FirstContact);
        a.session.openBuiltin("two-balls"); // no throw: shown whole
        QVERIFY(a.session.timeline().collisions().size() > 1);
    }

    void thePanelChoosesHowMuchIsForeseen() {
        Alley a;
        ThrowPanel panel(a.context);
        showPanel(panel, {340, 700});
        auto* path = panel.findChild<QComboBox*>("pathAhead");
        path->setFocus();
        QTest::keyClick(path, Qt::Key_Down);
        QVERIFY(a.session.foresight() == Foresight::FirstContact);
        click(panel, "throwButton");
        QVERIFY(a.session.foresight() == Foresight::Whole && a.playhead.playing());
        a.playhead.setPlaying(false);
        a.playhead.setTime(0);
        type(panel, "speedField", "9"); // another throw: not thrown yet
        QVERIFY(a.session.foresight() == Foresight::FirstContact);
        QCOMPARE(a.session.timeline().collisions().size(), std::size_t(1));
    }

    void aDeliveryIsAValue() {
        PanelBench b;
        QSignalSpy edited(&b.session, &Session::edited), opened(&b.session, &Session::opened);
        b.session.openBuiltin("bowling");
        QCOMPARE(opened.count(), 1);
        const Subject first = b.session.subject();
        const PinSet spare("1000000010"); // the 2 and the 10
        LaneConditions dry;
        dry.friction->oil.clear();
        QVERIFY(b.session.setDelivery(hooking(), spare, dry).empty());
        QCOMPARE(b.session.scene().bodies.size(), std::size_t(3));
        QCOMPARE(b.session.scene().bodies[1].id, std::string("2"));
        QCOMPARE(b.session.scene().bodies[2].id, std::string("10"));
        QVERIFY(b.session.standing() == spare && b.session.laneConditions() == dry);
        QCOMPARE(edited.count(), 1);
        QVERIFY(edited[0][0].value<Subject>() == first);
        const Subject second = b.session.subject();

        QVERIFY(b.session.setThrow(Throw{}, 0.5).empty()); // the pins and the floor of now
        QVERIFY(b.session.standing() == spare && b.session.scene().friction->oil.empty());
        QCOMPARE(b.session.scene().restitution, 0.5);
        QVERIFY(edited[1][0].value<Subject>() == second);

        b.session.restore(second);
        QVERIFY(b.session.subject() == second && b.session.scene() == second.scene);
        QCOMPARE(edited.count(), 2); // nothing new to undo
        b.session.restore(first);
        QVERIFY(b.session.subject() == first);
        QCOMPARE(b.session.sceneId(), QString("bowling"));

        Throw wrong;
        wrong.mass = -1;
        QVERIFY(!b.session.setDelivery(wrong, spare, dry).empty());
        QVERIFY(b.session.subject() == first);
        QCOMPARE(edited.count(), 2);
        b.session.reset();
        QCOMPARE(opened.count(), 2);
    }

    void theCameraFollowsTheBall() {
        Alley a({1000, 620});
        QTest::keyClick(&a.view(), Qt::Key_C);
        QVERIFY(a.view().following());
        const double met = a.session.timeline().collisions()[0].time;
        double scale = 0;
        for (int k = 0; k <= 200; ++k) {
            a.playhead.setTime(met * k / 200);
            const Vec2d ball = a.session.timeline().bodyAt(0, a.playhead.time()).position;
            QVERIFY(QRectF(a.view().viewport()->rect()).contains(a.pixel(ball)));
            QVERIFY(a.view().camera().scale >= scale * (1 - 1e-12)); // it only closes in
            scale = a.view().camera().scale;
        }
        a.playhead.setTime(a.playhead.end());
        Alley fitted({1000, 620});
        QVERIFY(near(a.view().camera().scale, fitted.view().camera().scale, 1e-9));
        QVERIFY((a.view().camera().centre - fitted.view().camera().centre).manhattanLength() < 1);
        // The same again on the way back, and from anywhere.
        a.playhead.setTime(met / 2);
        const Camera there = a.view().camera();
        a.playhead.setTime(0.1);
        a.playhead.setTime(met / 2);
        QCOMPARE(a.view().camera().scale, there.scale);
        QCOMPARE(a.view().camera().centre, there.centre);
        // An open collision has the view; afterwards the ball has it again.
        a.playhead.select(0);
        QVERIFY(a.view().camera().scale > there.scale);
        a.playhead.setTime(met / 2);
        QCOMPARE(a.view().camera().scale, there.scale);
        // A hand on the camera ends it.
        QTest::keyClick(&a.view(), Qt::Key_Plus);
        QVERIFY(!a.view().following());
        auto* button = a.panel.findChild<QAbstractButton*>("followBall");
        QVERIFY(!button->isChecked());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(a.view().following() && button->isChecked());
        Alley next;
        next.panel.restoreChoices();
        QVERIFY(next.view().following());
    }

    void slowMotionComesAndGoesByItself() {
        Alley a;
        const double met = a.session.timeline().collisions()[0].time;
        a.playhead.setTime(met - 0.2);
        a.playhead.advance(0.1);
        QCOMPARE(a.playhead.time(), met - 0.2 + 0.1); // off by default
        a.playhead.setSlowAtImpact(true);
        a.playhead.setTime(met - 0.2);
        QCOMPARE(a.playhead.rateNow(), 1.0);
        a.playhead.advance(0.1);
        QCOMPARE(a.playhead.time(), met - 0.2 + 0.1); // before it, evenly
        a.playhead.setTime(met);
        QCOMPARE(a.playhead.rateNow(), 1.0 / 16);
        a.playhead.advance(0.16);
        QVERIFY(near(a.playhead.time(), met + 0.01, 1e-12));
        // The same time for the same clock, in however many frames.
        a.playhead.setTime(met - 0.2);
        for (int k = 0; k < 300; ++k)
            a.playhead.advance(6.2 / 300);
        const double inFrames = a.playhead.time();
        a.playhead.setTime(met - 0.2);
        a.playhead.advance(6.2);
        QVERIFY(near(a.playhead.time(), inFrames, 1e-9));
        QVERIFY(inFrames > met + 0.3); // and on at the full rate
        QCOMPARE(a.playhead.rateNow(), 1.0);
        QCOMPARE(a.playhead.rate(), 1.0);

        TimelineBar bar(a.context);
        showPanel(bar, {1000, 60});
        auto* button = bar.findChild<QAbstractButton*>("slowMotionButton");
        QVERIFY(button->isVisible() && button->isChecked());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(!a.playhead.slowAtImpact());
        a.session.openBuiltin("two-balls");
        QVERIFY(!button->isVisible());
    }

    void pinsGoDownTheWayTheyWereStruck() {
        Alley a;
        const Run& run = *a.session.run();
        for (int k = 0; k <= 60; ++k) {
            a.playhead.setTime(a.playhead.end() * k / 60);
            const auto down = pinsDown(run.scene, run.timeline, a.playhead.time());
            for (int i = 1; i <= 10; ++i) {
                const bool fell = std::find(down.begin(), down.end(), i) != down.end();
                QCOMPARE(a.panel.scene().bodies()[std::size_t(i)]->tipped().has_value(), fell);
            }
            QCOMPARE(a.panel.badge().standing().size(), 10 - down.size());
        }
        const auto falls = fallsOf(run);
        QVERIFY(!falls[0]);
        const Collision& first = run.timeline.collisions()[0]; // ball and head pin
        const Vec2d v = first.steps.after.second;
        QVERIFY(falls[std::size_t(first.second)]);
        QCOMPARE(falls[std::size_t(first.second)]->time, first.time);
        const Vec2d along = falls[std::size_t(first.second)]->along;
        QVERIFY(near(cross(along, v), 0, 1e-12) && dot(along, v) > 0);
        QCOMPARE(tipped(*falls[std::size_t(first.second)], first.time + 1), 1.0);
        a.session.openBuiltin("break");
        QVERIFY(!a.panel.badge().isVisible());
    }

    void unitsAreChosenAndKept() {
        PanelBench b;
        b.session.openBuiltin("bowling");
        ThrowPanel panel(b.context);
        showPanel(panel, {360, 900});
        QSignalSpy changed(&panel, &ThrowPanel::unitsChanged);
        const Throw before = *b.session.currentThrow();
        const auto choose = [&](const char* button, int index) {
            click(panel, button);
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            const QAction* action = menu->actions()[index];
            QTest::mouseClick(menu, Qt::LeftButton, {},
                              menu->actionGeometry(const_cast<QAction*>(action)).center());
        };
        choose("weightFieldUnit", 1);
        choose("speedFieldUnit", 2);
        QCOMPARE(changed.count(), 2);
        QVERIFY(*b.session.currentThrow() == before);                     // to the last bit
        QCOMPARE(field(panel, "weightField").text(), QString("14.9914")); // 6.8 kg / 0.45359237
        QCOMPARE(field(panel, "speedField").text(), QString("17.8955"));  // 8 m/s · 3600/1609.344
        QCOMPARE(message(panel, "weightNote"), QString("6.8 kg"));
        QCOMPARE(message(panel, "speedNote"), QString("8.0 m/s"));
        type(panel, "speedField", "20");
        QVERIFY(near(b.session.currentThrow()->speed, 20 * 0.44704, 1e-12));
        QCOMPARE(b.session.currentThrow()->mass, before.mass);
        type(panel, "weightField", "17");
        QVERIFY(!message(panel, "weightMessage").isEmpty());
        QVERIFY(message(panel, "weightMessage").contains("16"));
        type(panel, "weightField", "16");
        QVERIFY(near(b.session.currentThrow()->mass, 7.25747792, 1e-12));
        QVERIFY(rememberedThrowUnits() == panel.units());
        AimTool aim(b.context);
        aim.setUnits(panel.units());
        QCOMPARE(aim.valueText(AimPart::Speed), QString("20.00 mph"));
    }

    void theDialTurnsTheBall() {
        PanelBench b;
        b.session.openBuiltin("bowling");
        ThrowPanel panel(b.context);
        showPanel(panel, {360, 900});
        auto* dial = panel.findChild<SpinDial*>("spinDial");
        QTest::mousePress(dial, Qt::LeftButton, {}, dial->beadAt(0, 0).toPoint());
        const QPoint to = dial->beadAt(300, 45).toPoint();
        QMouseEvent move(QEvent::MouseMove, to, dial->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(dial, &move);
        QTest::mouseRelease(dial, Qt::LeftButton, {}, to);
        const auto rpm = [&] { return b.session.currentThrow()->spin * 60 / (2 * std::numbers::pi); };
        const auto axis = [&] { return b.session.currentThrow()->axis * 180 / std::numbers::pi; };
        QVERIFY2(near(rpm(), 300, 25), qPrintable(QString::number(rpm())));
        QVERIFY2(near(axis(), 45, 2), qPrintable(QString::number(axis())));
        QCOMPARE(field(panel, "axisField").text(), QString::number(std::lround(axis())));
        const double turned = rpm();
        QTest::keyClick(dial, Qt::Key_Up);
        QVERIFY(near(rpm(), turned + 10, 1e-9));
        const double was = axis();
        QTest::keyClick(dial, Qt::Key_Left);
        QVERIFY(near(axis(), was + 5, 1e-9));
        type(panel, "rotationField", "700"); // more than the dial goes: it stays
        QVERIFY(near(rpm(), 700, 1e-9));
        QCOMPARE(dial->rpm(), 700.0);
        QVERIFY(!dial->accessibleName().isEmpty() && dial->accessibleDescription().contains("700"));
    }
};

QTEST_MAIN(TestAim)
#include "test_aim.moc"

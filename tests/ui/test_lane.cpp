// The lane, driven by real events: where things stand, what is drawn on top, what the mouse does.
#include "core/bowling/pinfall.h"
#include "core/scene/builtin.h"
#include "ui/lane/body_item.h"
#include "ui/lane/extent.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_strip.h"
#include "ui/lane/lane_view.h"
#include "ui/lane/pin_badge.h"
#include "ui/words/language.h"

#include <QAbstractButton>
#include <QRandomGenerator>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <ctime>

using namespace thetalane;

namespace {

struct Room {
    Session session;
    Playhead playhead{session};
    Appearance appearance;
    LanePanel panel{Context{session, playhead, appearance}};

    explicit Room(const char* scene, QSize size = {900, 600}) {
        appearance.setReducedMotion(true);
        session.openBuiltin(scene);
        panel.resize(size);
        panel.show();
        QCoreApplication::processEvents();
    }
    LaneView& view() { return panel.view(); }
    const Timeline& timeline() const { return session.timeline(); }

    // The test's own inverse: a millimetre is a unit, y up.
    QPointF pixel(const Vec2d& metres) {
        return view().viewportTransform().map(QPointF(metres.x * 1000, -metres.y * 1000));
    }
    bool visible(const Vec2d& centre, double radius) {
        const QRectF box(view().viewport()->rect());
        return box.contains(pixel(centre - Vec2d{radius, radius})) &&
               box.contains(pixel(centre + Vec2d{radius, radius}));
    }
    void wheel(const QPointF& at, int notches) {
        QWheelEvent event(at, view().viewport()->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(view().viewport(), &event);
    }
    void moveMouse(const QPoint& at) {
        QWidget* port = view().viewport();
        QMouseEvent move(QEvent::MouseMove, at, port->mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(port, &move);
    }
    void drag(const QPoint& from, const QPoint& to) {
        QWidget* port = view().viewport();
        QTest::mousePress(port, Qt::LeftButton, {}, from);
        for (int k = 1; k <= 5; ++k) {
            const QPoint at = from + (to - from) * k / 5;
            QMouseEvent move(QEvent::MouseMove, at, port->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(port, &move);
        }
        QTest::mouseRelease(port, Qt::LeftButton, {}, to);
    }
};

double distance(const Vec2d& a, const Vec2d& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

const OverlayArrow* find(const StepOverlay& o, int body, ArrowPart part) {
    for (const OverlayArrow& a : o.arrows)
        if (a.body == body && a.part == part)
            return &a;
    return nullptr;
}

} // namespace

class TestLane : public QObject {
    Q_OBJECT

private slots:
    // The paper's loop holds ball and pin together as they fly off; the rack still fills the view.
    void aPairThatSticksLeavesTheSceneItsSize() {
        Session session;
        session.openBuiltin("rack");
        const QSizeF exact = fitRect(*session.run(), session.shownUntil()).size();
        EngineSettings loop = session.run()->settings;
        loop.kind = EngineKind::Stepped;
        loop.step = 1.0 / 60;
        loop.approachingOnly = false;
        QVERIFY(!session.setEngine(loop));
        QVERIFY(session.timeline().collisions().size() > 100);
        const QSizeF stuck = fitRect(*session.run(), session.shownUntil()).size();
        QVERIFY(stuck.width() < 2 * exact.width() && stuck.height() < 2 * exact.height());
    }

    void bodiesStandWhereTheTimelineSays_data() {
        QTest::addColumn<QString>("scene");
        for (const BuiltinScene& s : builtinScenes())
            QTest::newRow(s.id.data()) << QString::fromUtf8(s.id.data(), qsizetype(s.id.size()));
    }

    void bodiesStandWhereTheTimelineSays() {
        QFETCH(QString, scene);
        Room room(qPrintable(scene));
        QRandomGenerator random(7);
        const QTransform inverse = room.view().viewportTransform().inverted();
        for (int k = 0; k < 200; ++k) {
            room.playhead.setTime(random.generateDouble() * room.playhead.end());
            const auto states = room.timeline().stateAt(room.playhead.time());
            QCOMPARE(room.panel.scene().bodies().size(), states.size());
            for (std::size_t i = 0; i < states.size(); ++i) {
                const BodyItem* item = room.panel.scene().bodies()[i];
                const QPointF pixel = room.view().viewportTransform().map(item->pos());
                const QPointF units = inverse.map(pixel);
                const Vec2d metres{units.x() / 1000, -units.y() / 1000};
                QVERIFY(distance(metres, states[i].position) < 1e-9 * (1 + norm(states[i].position)));
            }
        }
    }

    void fitShowsEverything_data() { bodiesStandWhereTheTimelineSays_data(); }

    void fitShowsEverything() {
        QFETCH(QString, scene);
        for (const QSize size : {QSize(400, 300), QSize(640, 520), QSize(1400, 900), QSize(3840, 2160)}) {
            Room room(qPrintable(scene), size);
            room.wheel({50, 60}, 5);
            QTest::keyClick(&room.view(), Qt::Key_F);
            const Scene& s = room.session.scene();
            for (const Body& body : s.bodies)
                if (!s.lane || body.kind == BodyKind::Pin)
                    QVERIFY2(room.visible(body.position, body.radius), body.id.c_str());
            if (s.frame) {
                QVERIFY(room.visible({*s.frame->left, *s.frame->bottom}, 0));
                QVERIFY(room.visible({*s.frame->right, *s.frame->top}, 0));
            }
            if (!s.lane)
                for (const Collision& c : room.timeline().collisions())
                    QVERIFY(room.visible(c.steps.first.position, c.steps.first.radius));
        }
    }

    void wheelZoomsAboutTheCursor() {
        Room room("two-balls");
        const QPointF at(523, 211);
        const QPointF held = room.view().viewportTransform().inverted().map(at);
        double scale = room.view().transform().m11();
        for (const int notches : {1, 1, 1, 2, -1, -1, 3}) {
            room.wheel(at, notches);
            const QPointF now = room.view().viewportTransform().map(held);
            QVERIFY2(std::hypot(now.x() - at.x(), now.y() - at.y()) <= 1,
                     qPrintable(QString::number(now.x())));
            QCOMPARE(room.view().transform().m11() > scale, notches > 0);
            scale = room.view().transform().m11();
        }
        room.wheel(at, 400);
        QVERIFY(room.view().transform().m11() * 2 * 80 <= 601); // the smaller ball fills the view at most
        room.wheel(at, -800);
        const QRectF seen = room.view().visibleRect();
        QVERIFY(seen.width() < 10000 && seen.contains(seen.center()));
    }

    void dragPans() {
        Room room("two-balls");
        room.wheel({450, 300}, 3);
        const QPoint from(300, 500);
        const QPointF held = room.view().viewportTransform().inverted().map(QPointF(from));
        room.drag(from, from + QPoint(80, -50));
        const QPointF now = room.view().viewportTransform().map(held);
        QVERIFY(std::hypot(now.x() - 380, now.y() - 450) <= 1);
        QVERIFY(!room.playhead.selected());
    }

    void buttonsAndKeysZoom() {
        Room room("head-on");
        const double scale = room.view().transform().m11();
        for (const char* name : {"zoomIn", "zoomOut", "zoomFit"}) {
            auto* button = room.panel.findChild<QAbstractButton*>(name);
            QVERIFY(button && button->height() >= 24 && !button->toolTip().isEmpty());
            QTest::mouseClick(button, Qt::LeftButton);
            QCOMPARE(room.view().transform().m11() > scale * 1.01, QByteArray(name) == "zoomIn");
        }
        QTest::keyClick(&room.view(), Qt::Key_Plus);
        QVERIFY(room.view().transform().m11() > scale * 1.01);
        QTest::mouseDClick(room.view().viewport(), Qt::LeftButton, {}, {60, 60});
        QVERIFY(std::abs(room.view().transform().m11() / scale - 1) < 1e-9);
    }

    void selectionZoomsToThePairAndBack_data() { bodiesStandWhereTheTimelineSays_data(); }

    void selectionZoomsToThePairAndBack() {
        QFETCH(QString, scene);
        Room room(qPrintable(scene));
        const Camera before = room.view().camera();
        const Collision& c = room.timeline().collisions()[0];
        room.playhead.select(0);
        QCOMPARE(room.playhead.time(), c.time);
        for (const auto& disc : {c.steps.first, c.steps.second})
            QVERIFY(room.visible(disc.position, disc.radius));
        const double extent = 2 * (c.steps.first.radius + c.steps.second.radius);
        const double share = extent * 1000 * room.view().transform().m11() / 600;
        QVERIFY2(share > 0.3 && share < 0.55, qPrintable(QString::number(share)));
        room.playhead.clearSelection();
        QVERIFY(!room.view().overlay());
        QVERIFY(std::abs(room.view().camera().scale / before.scale - 1) < 1e-9);
        QVERIFY((room.view().camera().centre - before.centre).manhattanLength() < 1e-6);
    }

    void flightEndsWhereReducedMotionStands() {
        Room still("two-balls"), moving("two-balls");
        moving.appearance.setReducedMotion(false);
        still.playhead.select(0);
        moving.playhead.select(0);
        QVERIFY(moving.view().camera().scale < still.view().camera().scale);
        QTRY_COMPARE_WITH_TIMEOUT(moving.view().camera().scale, still.view().camera().scale, 3000);
        QCOMPARE(moving.view().camera().centre, still.view().camera().centre);
        moving.playhead.clearSelection();
        moving.wheel({100, 100}, 1); // takes over at once
        const double scale = moving.view().camera().scale;
        QTest::qWait(400);
        QCOMPARE(moving.view().camera().scale, scale);
    }

    void overlayHasThePapersVectors_data() { bodiesStandWhereTheTimelineSays_data(); }

    // The directions come from the positions, the speeds from the run; nothing from the overlay itself.
    void overlayHasThePapersVectors() {
        QFETCH(QString, scene);
        Room room(qPrintable(scene));
        const auto collisions = room.timeline().collisions();
        for (std::size_t k = 0; k < std::min<std::size_t>(collisions.size(), 12); ++k) {
            const auto& s = collisions[k].steps;
            const Vec2d d = s.first.position - s.second.position;
            const Vec2d n = d * (1 / std::hypot(d.x, d.y));
            const Vec2d t{-n.y, n.x};
            room.playhead.select(k);
            for (int i = 0; i < (collisions[k].isWall() ? 1 : 2); ++i) {
                const Vec2d p = i ? s.second.position : s.first.position;
                const Vec2d v = i ? s.before.second : s.before.first;
                const Vec2d w = i ? s.after.second : s.after.first;
                const auto ends = [&](Stage stage, ArrowPart part, const Vec2d& velocity) {
                    room.playhead.setStage(stage);
                    const StepOverlay& o = *room.view().overlay();
                    const OverlayArrow* a = find(o, i, part);
                    return a && distance(a->from, p) < 1e-12 &&
                           distance(a->to, p + velocity * o.metresPerSpeed) < 1e-9;
                };
                QVERIFY(ends(Stage::Split, ArrowPart::Velocity, v));
                if (norm(v) > 0) {
                    QVERIFY(ends(Stage::Split, ArrowPart::FirstComponent, {v.x, 0}));
                    QVERIFY(ends(Stage::Split, ArrowPart::SecondComponent, {0, v.y}));
                    QVERIFY(ends(Stage::Rotation, ArrowPart::FirstComponent, n * dot(v, n)));
                    QVERIFY(ends(Stage::Rotation, ArrowPart::SecondComponent, t * dot(v, t)));
                }
                QVERIFY(ends(Stage::Exchange, ArrowPart::Before, n * dot(v, n)));
                QVERIFY(ends(Stage::Exchange, ArrowPart::FirstComponent, n * dot(w, n)));
                QVERIFY(ends(Stage::RotationBack, ArrowPart::Velocity, w));
                QVERIFY(ends(Stage::Check, ArrowPart::Before, v));
                QVERIFY(ends(Stage::Check, ArrowPart::Velocity, w));
            }
            room.playhead.setStage(Stage::Contact);
            const StepOverlay& o = *room.view().overlay();
            QVERIFY(o.arrows.empty());
            QCOMPARE(o.arcs.size(), std::size_t(1));
            QVERIFY(std::abs(std::cos(o.arcs[0].angle) - n.x) < 1e-12);
            QVERIFY(std::abs(std::sin(o.arcs[0].angle) - n.y) < 1e-12);
            QCOMPARE(o.wall.has_value(), collisions[k].isWall());
            QCOMPARE(o.discs.size(), std::size_t(collisions[k].isWall() ? 1 : 2));
            QVERIFY(std::abs(distance(o.contact, s.first.position) - s.first.radius) < 1e-6);
        }
    }

    void labelsCoverNeitherArrowsNorEachOther() {
        for (const QSize size : {QSize(640, 520), QSize(1400, 900)}) {
            Room room("two-balls", size);
            room.playhead.select(0);
            for (int stage = 0; stage < stageCount; ++stage) {
                room.playhead.setStage(Stage(stage));
                room.panel.grab();
                const OverlayPlaces& places = room.view().overlayPlaces();
                QVERIFY(!places.labels.empty());
                for (const QRectF& label : places.labels) {
                    QVERIFY(QRectF(room.view().viewport()->rect()).contains(label));
                    for (const QRectF& other : places.labels)
                        QVERIFY(&other == &label || !other.intersects(label));
                    for (const QLineF& arrow : places.arrows)
                        for (int k = 0; k <= 50; ++k)
                            QVERIFY2(!label.contains(arrow.pointAt(k / 50.0)),
                                     qPrintable(QString::number(stage)));
                }
            }
        }
    }

    void clickSelectsTheBodysNextCollision() {
        Room room("cradle");
        const auto collisions = room.timeline().collisions();
        const double t = (collisions[1].time + collisions[2].time) / 2;
        room.playhead.setTime(t);
        for (const int body : {4, 2}) { // E: D–E, the fourth; C: C–D, the third
            room.playhead.clearSelection();
            room.playhead.setTime(t);
            const Vec2d p = room.timeline().bodyAt(std::size_t(body), t).position;
            QTest::mouseClick(room.view().viewport(), Qt::LeftButton, {}, room.pixel(p).toPoint());
            QVERIFY(room.playhead.selected());
            QCOMPARE(*room.playhead.selected(), std::size_t(body == 4 ? 3 : 2));
        }
        room.playhead.clearSelection();
        room.playhead.setTime(t);
        const Vec2d done = room.timeline().bodyAt(0, t).position; // A has met all it will meet
        QTest::mouseClick(room.view().viewport(), Qt::LeftButton, {}, room.pixel(done).toPoint());
        QVERIFY(!room.playhead.selected());
    }

    void doubleClickOnABodyStaysWithItsCollision() {
        Room room("two-balls");
        const QPoint at = room.pixel({-0.5, 0}).toPoint();
        QTest::mouseClick(room.view().viewport(), Qt::LeftButton, {}, at);
        const double scale = room.view().camera().scale;
        QTest::mouseDClick(room.view().viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(*room.playhead.selected(), std::size_t(0));
        QCOMPARE(room.view().camera().scale, scale);
    }

    void aDialKeepsTheViewAndASceneFitsIt() {
        Room room("two-balls");
        room.wheel({450, 300}, 3);
        const Camera chosen = room.view().camera();
        Scene edited = room.session.scene();
        edited.restitution = 0.5;
        QVERIFY(room.session.setScene(edited).empty());
        QCOMPARE(room.view().camera().scale, chosen.scale);
        room.playhead.select(0);
        edited.restitution = 0.6;
        QVERIFY(room.session.setScene(edited).empty());
        QVERIFY(!room.view().overlay());
        QCOMPARE(room.view().camera().scale, chosen.scale);
        room.session.openBuiltin("bowling");
        for (int pin = 1; pin <= 10; ++pin)
            QVERIFY(room.visible(room.session.scene().bodies[std::size_t(pin)].position, 0.06));
    }

    void aWallIsMarked() {
        Room room("two-balls");
        const auto collisions = room.timeline().collisions();
        std::size_t k = 0;
        while (!collisions[k].isWall())
            ++k;
        room.playhead.select(k);
        const StepOverlay& o = *room.view().overlay();
        QVERIFY(o.wall && *o.wall == collisions[k].side && o.discs.size() == 1);
        const Vec2d centre = collisions[k].steps.first.position;
        const bool upright = *o.wall == Side::Left || *o.wall == Side::Right;
        const double wall = *room.session.scene().frame->side(*o.wall);
        QVERIFY(std::abs((upright ? o.contact.x : o.contact.y) - wall) < 1e-9);
        QVERIFY(std::abs((upright ? o.contact.y - centre.y : o.contact.x - centre.x)) < 1e-9);
        const QColor ink = room.appearance.ink(Ink::Second); // on the wall, away from the body
        const Vec2d beside = upright ? Vec2d{wall, centre.y + 0.15} : Vec2d{centre.x + 0.15, wall};
        QCOMPARE(room.view().viewport()->grab().toImage().pixelColor(room.pixel(beside).toPoint()), ink);
    }

    void hoverShowsAHalo() {
        Room room("two-balls");
        room.moveMouse(room.pixel({-0.5, 0}).toPoint());
        QVERIFY(room.panel.scene().bodies()[0]->hovered());
        room.moveMouse(room.pixel({-0.9, 0.5}).toPoint());
        QVERIFY(!room.panel.scene().bodies()[0]->hovered());
        const QString tip = room.panel.scene().bodyTip(0);
        QVERIFY(tip.contains("2") && tip.contains("kg") && tip.contains("m/s") && tip.contains("11.31"));
    }

    void othersRecede() {
        Room room("rack");
        room.playhead.select(2);
        const Collision& c = room.timeline().collisions()[2];
        for (int i = 0; i < 11; ++i) {
            using Role = BodyItem::Role;
            const Role expected = i == c.first ? Role::First : i == c.second ? Role::Second : Role::Receding;
            QVERIFY(room.panel.scene().bodies()[std::size_t(i)]->role() == expected);
        }
    }

    void badgeCountsPins() {
        for (const char* name : {"rack", "bowling"}) {
            Room room(name);
            QVERIFY(room.panel.badge().isVisible());
            for (int k = 0; k <= 60; ++k) {
                room.playhead.setTime(room.playhead.end() * k / 60);
                const double t = room.playhead.time();
                const auto& run = *room.session.run();
                QCOMPARE(room.panel.badge().touched(), int(pinsTouched(run.scene, run.timeline, t).size()));
                QCOMPARE(room.panel.badge().down(), int(pinsDown(run.scene, run.timeline, t).size()));
            }
            QVERIFY(room.panel.badge().touched() > 3);
        }
        Room balls("two-balls");
        QVERIFY(!balls.panel.badge().isVisible());
    }

    void aLaneHasTwoViews() {
        Room room("bowling");
        QVERIFY(room.panel.strip().isVisible());
        QCOMPARE(room.panel.strip().scene(), room.view().scene());
        QVERIFY(room.panel.strip().width() < room.view().width() / 4);
        // The ball is 18 m before the head pin: on the strip, not in the close-up.
        QVERIFY(!room.visible(room.session.scene().bodies[0].position, 0));
        const LaneStrip& strip = room.panel.strip();
        const QPointF ball = strip.viewportTransform().map(room.panel.scene().bodies()[0]->pos());
        QVERIFY(QRectF(strip.viewport()->rect()).contains(ball));
        QVERIFY(ball.y() > strip.height() * 0.8);
        QVERIFY(strip.frameOfCloseUp().bottom() < strip.height() * 0.3);
        QTest::mouseClick(strip.viewport(), Qt::LeftButton, {}, ball.toPoint());
        QVERIFY(room.visible(room.session.scene().bodies[0].position, 0));
        room.session.openBuiltin("cradle");
        QVERIFY(!room.panel.strip().isVisible());
        QVERIFY(room.visible(room.session.scene().bodies[0].position, 0));
    }

    void languageIsSwitched() {
        Language language;
        language.use(Language::Code::English);
        Room room("rack");
        room.playhead.select(0);
        room.playhead.setStage(Stage::Check);
        const QString words = room.view().overlay()->arrows[0].label.text;
        QVERIFY(words.startsWith("before"));
        const QString tip = room.panel.findChild<QAbstractButton*>("zoomFit")->toolTip();
        language.use(Language::Code::Korean);
        QCoreApplication::processEvents();
        QVERIFY(room.view().overlay()->arrows[0].label.text.startsWith(QStringLiteral("충돌 전")));
        QVERIFY(room.panel.findChild<QAbstractButton*>("zoomFit")->toolTip() != tip);
        QVERIFY(room.panel.badge().accessibleName().contains(QStringLiteral("핀")));
        language.use(Language::Code::English);
    }

    void aFrameIsCheap() {
        for (const char* name : {"rack", "bowling", "two-balls"}) {
            Room room(name, {1100, 800});
            constexpr int frames = 200;
            QImage image(room.panel.size(), QImage::Format_ARGB32_Premultiplied);
            room.panel.render(&image);
            std::clock_t start = std::clock(); // of this process: other load does not count
            const auto perFrame = [&start] {
                return 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC / frames;
            };
            for (int k = 0; k < frames; ++k)
                room.playhead.setTime(room.playhead.end() * k / frames);
            const double moved = perFrame();
            start = std::clock();
            for (int k = 0; k < frames; ++k) {
                room.playhead.setTime(room.playhead.end() * k / frames);
                room.panel.repaint();
                QCoreApplication::processEvents();
            }
            qInfo("%s: items moved in %.3f ms a frame, moved and painted in %.2f ms", name, moved,
                  perFrame());
        }
    }
};

QTEST_MAIN(TestLane)
#include "test_lane.moc"

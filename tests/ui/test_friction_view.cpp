// What friction puts on the screen: the ball that turns, curved paths, oil, plates, contacts that last, and
// the fields for spin.
#include "made_runs.h"
#include "panel_bench.h"
#include "ui/lane/body_item.h"
#include "ui/lane/floor.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"
#include "ui/lane/lasting_item.h"
#include "ui/lane/paths_item.h"
#include "ui/lane/scale.h"
#include "ui/panels/bodies_panel.h"
#include "ui/panels/throw_panel.h"
#include "ui/words/number_text.h"

#include <QSignalSpy>

#include <numbers>

using namespace thetalane;

namespace {

double gap(const Direction& a, const Direction& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// d/dt of a direction is ω × d: the test's own integrator (Runge-Kutta), a hundred times as fine.
Direction integrated(const Rotation& r, double duration, Direction d) {
    const auto rate = [&](const Direction& u, double t) {
        const double x = r.spin.x + r.rate.x * t, y = r.spin.y + r.rate.y * t, z = r.spin.z + r.rate.z * t;
        return Direction{y * u.z - z * u.y, z * u.x - x * u.z, x * u.y - y * u.x};
    };
    const auto moved = [](const Direction& u, const Direction& k, double h) {
        return Direction{u.x + k.x * h, u.y + k.y * h, u.z + k.z * h};
    };
    constexpr int steps = 40'000;
    const double h = duration / steps;
    for (int i = 0; i < steps; ++i) {
        const double t = i * h;
        const Direction k1 = rate(d, t), k2 = rate(moved(d, k1, h / 2), t + h / 2),
                        k3 = rate(moved(d, k2, h / 2), t + h / 2), k4 = rate(moved(d, k3, h), t + h);
        d = moved(moved(moved(moved(d, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
    }
    return d;
}

QImage floorOf(const Scene& scene, const Appearance& look, const QRectF& metres, double pixelsPerMetre) {
    QImage image((metres.size() * pixelsPerMetre).toSize(), QImage::Format_RGB32);
    QPainter painter(&image);
    const double scale = pixelsPerMetre / unitsPerMetre;
    painter.scale(scale, scale);
    painter.translate(-metres.left() * unitsPerMetre, metres.bottom() * unitsPerMetre);
    paintFloor(painter, scene, look,
               toUnits({metres.left(), metres.top()}, {metres.right(), metres.bottom()}));
    return image;
}

} // namespace

class TestFrictionView : public QObject {
    Q_OBJECT

    Language m_language;

private slots:
    void initTestCase_data() { addLanguages(); }
    void init() {
        QFETCH_GLOBAL(bool, korean);
        useLanguage(m_language, korean);
    }
    bool korean() const { return m_language.code() == Language::Code::Korean; }

    void aFixedAxisIsExact() {
        const Rotation r{{-30, 0, 0}, {10, 0, 0}, FloorPhase::Rolling};
        for (const double t : {0.0, 0.1, 0.9, 1.7, 3.0}) {
            const double angle = -30 * t + 5 * t * t;
            const Direction top = turned(turnDuring(r, t), {0, 0, 1});
            QVERIFY(gap(top, {0, -std::sin(angle), std::cos(angle)}) < 1e-13);
        }
    }

    void aMovingAxisIsClose_data() {
        QTest::addColumn<double>("time");
        for (const double t : {0.01, 0.2, 0.7, 1.5})
            QTest::addRow("%g s", t) << t;
    }
    void aMovingAxisIsClose() {
        QFETCH(double, time);
        for (const Rotation& r : {Rotation{{-20, -15, 4}, {-9, 12, 0}, FloorPhase::Sliding},
                                  Rotation{{30, 0, 0}, {0, 27, 0}, FloorPhase::Sliding},
                                  Rotation{{1, 0, 5}, {-20, 8, 0}, FloorPhase::Sliding}})
            for (const Direction& d : {Direction{0, 0, 1}, Direction{1, 0, 0}, Direction{0.6, 0.8, 0}}) {
                const double off = gap(turned(turnDuring(r, time), d), integrated(r, time, d));
                QVERIFY2(off < 2e-5, qPrintable(QString::number(off)));
            }
    }

    void scrubbingBackIsALookUp() {
        const Run run = hookingBall();
        const Turning turning(run.timeline.segments(0), run.timeline.rotations(0));
        std::vector<Orientation> there;
        for (int k = 0; k <= 200; ++k)
            there.push_back(turning.at(k * 0.01));
        for (int k = 200; k >= 0; --k)
            QVERIFY(turning.at(k * 0.01) == there[std::size_t(k)]);
        // And nothing jumps where a segment ends.
        const Direction top{0, 0, 1};
        QVERIFY(gap(turned(turning.at(0.6 - 1e-9), top), turned(turning.at(0.6), top)) < 1e-7);
    }

    void theBallTurnsOnTheLane() {
        PanelBench b;
        adoptRun(b.session, hookingBall());
        LanePanel lane(b.context);
        b.appearance.setReducedMotion(true);
        showPanel(lane, {700, 560});
        const BodyItem& ball = *lane.scene().bodies()[0];
        QVERIFY(ball.turn() && !lane.scene().bodies()[1]->turn());
        const auto patch = [&](double time) {
            b.playhead.setTime(time);
            const QPoint at = lane.view().mapFromScene(ball.pos());
            return lane.view().viewport()->grab(QRect(at - QPoint(14, 14), QSize(29, 29))).toImage();
        };
        const QImage now = patch(0.45);
        QVERIFY(patch(0.5) != now);
        QCOMPARE(patch(0.45), now);
        b.session.openBuiltin("bowling");
        QVERIFY(!b.session.scene().friction ? !lane.scene().bodies()[0]->turn() : true);
    }

    void pathsAreParabolas() {
        const Run run = hookingBall();
        Appearance look;
        PathsItem paths(look);
        paths.build(run, 1.5, std::vector<Ink>(run.scene.bodies.size(), Ink::Plain));
        const double scale = 0.6; // [px/mm]
        for (const double time : {0.25, 0.5999, 1.2}) {
            paths.setTime(time, run.timeline.stateAt(time));
            const auto lines = paths.walkedLines(0, QTransform::fromScale(scale, scale));
            QVERIFY(lines.size() > 4);
            const auto pixel = [&](double t) { return toUnits(run.timeline.bodyAt(0, t).position) * scale; };
            QVERIFY(QLineF(lines.front().p1(), pixel(0)).length() < 1e-6);
            QVERIFY(QLineF(lines.back().p2(), pixel(time)).length() < 1e-6);
            // Wherever the ball was, the line is within half a pixel.
            for (int k = 0; k <= 300; ++k) {
                const QPointF was = pixel(time * k / 300);
                double least = 1e300;
                for (const QLineF& line : lines) {
                    const QPointF way = line.p2() - line.p1();
                    const double at = std::clamp(
                        QPointF::dotProduct(was - line.p1(), way) / QPointF::dotProduct(way, way), 0.0, 1.0);
                    least = std::min(least, QLineF(line.p1() + way * at, was).length());
                }
                QVERIFY2(least < 0.5, qPrintable(QString::number(least)));
            }
        }
    }

    void straightPathsStayOneLine() {
        Session session;
        session.openBuiltin("two-balls");
        Appearance look;
        PathsItem paths(look);
        paths.build(*session.run(), 2, {Ink::First, Ink::Second});
        const double time = session.timeline().segments(0)[1].start;
        paths.setTime(time, session.timeline().stateAt(time));
        QCOMPARE(paths.walkedLines(0, QTransform()).size(), std::size_t(1));
    }

    void oilIsSeen_data() {
        QTest::addColumn<bool>("projector");
        QTest::newRow("window") << false;
        QTest::newRow("projector") << true;
    }
    void oilIsSeen() {
        QFETCH(bool, projector);
        Appearance look;
        look.setProjector(projector);
        const Run run = hookingBall();
        Scene dry = run.scene;
        dry.friction->oil.clear();
        const QRectF part(-0.8, -7, 1.6, 2);
        const double scale = 300;
        const QImage oiled = floorOf(run.scene, look, part, scale);
        const QImage plain = floorOf(dry, look, part, scale);
        const auto at = [&](const QImage& image, double x, double y) {
            return image.pixelColor(int((x - part.left()) * scale), int((part.bottom() - y) * scale));
        };
        const QColor film = at(oiled, 0.3, -6.503), wood = at(plain, 0.3, -6.503);
        QVERIFY(film.red() < wood.red() - 10 && film.red() - film.blue() < wood.red() - wood.blue() - 5);
        QCOMPARE(at(oiled, 0.3, -5.9), at(plain, 0.3, -5.9)); // beyond its end
        QCOMPARE(at(oiled, 0.6, -6.5), at(plain, 0.6, -6.5)); // in the gutter
    }

    void platesAreSeen() {
        const Appearance look;
        const Run run = hookingBall();
        Scene open = run.scene;
        open.lane->kickbacks.reset();
        const QRectF part(-1, -1, 2, 2);
        const double scale = 200;
        const QImage with = floorOf(run.scene, look, part, scale);
        const QImage without = floorOf(open, look, part, scale);
        const double edge = run.scene.lane->right + run.scene.lane->gutterWidth;
        const auto differs = [&](double x, double y) {
            const QPoint p(int((x - part.left()) * scale), int((part.bottom() - y) * scale));
            return with.pixelColor(p) != without.pixelColor(p);
        };
        QVERIFY(differs(edge + 0.025, 0.3) && differs(-edge - 0.025, 0.3));
        QVERIFY(!differs(edge + 0.025, -0.5) && !differs(edge - 0.05, 0.3) && !differs(edge + 0.15, 0.3));
    }

    void aContactThatLastsIsMarked() {
        PanelBench b;
        adoptRun(b.session, hookingBall());
        LanePanel lane(b.context);
        b.appearance.setReducedMotion(true);
        showPanel(lane, {700, 560});
        b.playhead.setTime(0.5);
        QVERIFY(lane.scene().lasting().marks().empty());
        b.playhead.setTime(0.7);
        QCOMPARE(lane.scene().lasting().marks().size(), std::size_t(1));
        const auto mark = lane.scene().lasting().marks()[0];
        const Vec2d ball = lane.scene().states()[0].position;
        QVERIFY(std::abs(norm(mark.contact - ball) - b.session.scene().bodies[0].radius) < 1e-12);
        const QString tip = lane.scene().bodyTip(0);
        QVERIFY2(tip.contains(korean() ? "1에 눌려 맞닿아 있음" : "Stays pressed against 1"),
                 qPrintable(tip));
        QVERIFY2(tip.contains("rpm"), qPrintable(tip));
        b.playhead.setTime(0.8);
        QVERIFY(lane.scene().lasting().marks().empty());
    }

    void spinHasFieldsWhereThereIsFriction() {
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 640});
        QVERIFY(!field(panel, "body0SpinX").isVisible());
        Scene rough = b.session.scene();
        rough.friction = Friction{.ball = 0.2, .oil = {}};
        QVERIFY(b.session.setScene(rough).empty());
        QVERIFY(field(panel, "body0SpinX").isVisible() && field(panel, "body1Inertia").isVisible());
        type(panel, "body0SpinX", "-31.4159");
        type(panel, "body0SpinZ", "2");
        type(panel, "body0Inertia", "0.35");
        QCOMPARE(b.session.scene().bodies[0].spin, (Spin<double>{-31.4159, 0, 2}));
        QCOMPARE(b.session.scene().bodies[0].inertia, 0.35);
        QVERIFY(field(panel, "body0SpinX").toolTip().contains("−300.0 rpm"));
        QVERIFY(field(panel, "body0SpinX").height() >= 24);
        // A pin slides and does not roll.
        adoptRun(b.session, hookingBall());
        QVERIFY(field(panel, "body0SpinY").isVisible() && !field(panel, "body1SpinY").isVisible());
    }

    void theThrowPanelIsTruthful() {
        PanelBench b;
        b.session.openBuiltin("bowling");
        ThrowPanel panel(b.context);
        showPanel(panel, {340, 760});
        const auto note = [&] { return message(panel, "rollNote"); };
        Scene dry = b.session.scene();
        dry.friction.reset();
        QVERIFY(b.session.open(dry).empty()); // of the user's own: its ball is the throw
        QVERIFY2(note().contains(korean() ? "마찰이 없" : "no friction"), qPrintable(note()));
        Scene rough = dry;
        rough.friction = Friction{.ball = 0.2, .oil = {}};
        const auto throwWith = [&](const Spin<double>& spin) {
            rough.bodies[0].spin = spin;
            Run run;
            run.scene = rough;
            run.timeline = b.session.timeline();
            adoptRun(b.session, run);
        };
        throwWith({});
        QVERIFY2(note().contains(korean() ? "회전 없이" : "without rotation"), qPrintable(note()));
        throwWith({-20 * std::cos(Throw{}.direction), 20 * std::sin(Throw{}.direction), 0});
        QVERIFY2(note().contains(korean() ? "직선" : "stays straight"), qPrintable(note()));
        throwWith({0, -20, 0}); // the slip points to the right, so friction pulls to the left
        QVERIFY2(note().contains(korean() ? "옆으로 휘" : "curves aside"), qPrintable(note()));
        QVERIFY(std::abs(parseNumber(field(panel, "axisField").text()).value_or(0) - 90) < 5);
        QVERIFY(std::abs(parseNumber(field(panel, "rotationField").text()).value_or(0) - 190.986) < 1e-2);
    }
};

QTEST_MAIN(TestFrictionView)
#include "test_friction_view.moc"

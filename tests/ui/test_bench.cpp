// Editing by hand, on the lane and in the panel, undone and redone.
#include "tests/ui/edit_bench.h"
#include "ui/bench/file_bar.h"
#include "ui/bench/rules/placing.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>

#include <functional>
#include <random>
#include <set>

namespace thetalane {
namespace {

struct Edit {
    const char* name;
    std::function<void(EditBench&)> make;
    const char* scene = "two-balls";
};

std::vector<Edit> everyEdit() {
    std::vector<Edit> edits;
    const auto typed = [&](const char* field, const char* text, const char* scene = "two-balls") {
        edits.push_back({field, [=](EditBench& b) { type(b.panel, field, text); }, scene});
    };
    typed("body0Mass", "3");
    typed("body1Radius", "0.07");
    typed("body0Speed", "1.7");
    typed("body0Direction", "-30");
    typed("body1X", "0.3");
    typed("body1Y", "-0.2");
    typed("body0Name", "ball");
    typed("restitutionField", "0.3");
    typed("wallLeftPlace", "-1.2");
    typed("wallRestitution", "0.6");
    typed("body0SpinX", "-20", "bowling-as-scene");
    typed("body0Inertia", "0.3", "bowling-as-scene");
    edits.push_back({"kind", [](EditBench& b) {
                         auto* kind = b.panel.findChild<QComboBox*>("body1Kind");
                         kind->setFocus();
                         QTest::keyClick(kind, Qt::Key_Down);
                     }});
    edits.push_back({"e by slider", [](EditBench& b) { b.slide("restitutionSlider", 1, 0.2); }});
    edits.push_back({"mass by slider", [](EditBench& b) { b.slide("body0MassSlider", 2, 6); }});
    edits.push_back({"radius by slider", [](EditBench& b) { b.slide("body0RadiusSlider", 0.1, 0.2); }});
    edits.push_back({"mass, and the radius with it", [](EditBench& b) {
                         b.check("constantSize");
                         type(b.panel, "body0Mass", "5");
                     }});
    edits.push_back({"add", [](EditBench& b) { click(b.panel, "addBody"); }});
    edits.push_back({"remove", [](EditBench& b) { click(b.panel, "body0Remove"); }});
    edits.push_back({"no wall", [](EditBench& b) { b.check("wallTop"); }});
    edits.push_back({"a wall", [](EditBench& b) { b.check("wallRight"); }, "head-on"});
    edits.push_back({"one line", [](EditBench& b) { b.check("oneLine"); }});
    edits.push_back({"drag", [](EditBench& b) { b.drag(b.body(A).position, {0.1, 0.3}); }});
    edits.push_back({"drag on the grid", [](EditBench& b) {
                         b.check("snap");
                         b.drag(b.body(A).position, {0.13, 0.27});
                     }});
    edits.push_back({"drag against another", [](EditBench& b) { b.drag(b.body(A).position, {0.35, 0}); }});
    edits.push_back({"drag into the wall", [](EditBench& b) { b.drag(b.body(A).position, {-0.99, 0.1}); }});
    edits.push_back({"arrow", [](EditBench& b) { b.drag(b.tip(A), {-0.4, 0.4}); }});
    edits.push_back({"handle of a body at rest", [](EditBench& b) {
                         const Vec2d rim = b.body(B).position + Vec2d{b.body(B).radius, 0};
                         b.drag(rim + Vec2d{9 * b.metresPerPixel(), 0}, {0.7, 0.3});
                     }});
    edits.push_back({"keys move", [](EditBench& b) {
                         b.key(Qt::Key_N);
                         b.key(Qt::Key_Up);
                     }});
    edits.push_back({"keys and speed", [](EditBench& b) {
                         b.key(Qt::Key_N, Qt::ShiftModifier);
                         b.key(Qt::Key_Left, Qt::AltModifier);
                     }});
    edits.push_back({"delete", [](EditBench& b) {
                         b.key(Qt::Key_N);
                         b.key(Qt::Key_Delete);
                     }});
    edits.push_back({"throw",
                     [](EditBench& b) {
                         Throw t = *b.session.currentThrow();
                         t.speed = 9;
                         b.session.setThrow(t, 0.75);
                     },
                     "bowling"});
    edits.push_back({"pins",
                     [](EditBench& b) {
                         b.session.setDelivery(*b.session.currentThrow(), PinSet(7),
                                               b.session.laneConditions());
                     },
                     "bowling"});
    edits.push_back({"from a throw to a scene",
                     [](EditBench& b) { b.session.setScene(*EditBench::builtinScene()); }, "bowling"});
    return edits;
}

void openFor(EditBench& b, const QString& scene) {
    if (scene == "bowling-as-scene") {
        b.session.openBuiltin("bowling");
        const Scene thrown = b.session.scene();
        b.session.open(thrown);
    } else {
        b.session.openBuiltin(scene);
    }
    QCoreApplication::processEvents();
}

// A scene of `count` bodies anywhere, none over another, within walls on some sides.
Scene randomScene(std::mt19937& random, int count) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    Scene scene;
    scene.restitution = number(0, 1);
    if (random() % 4)
        scene.frame = Frame{-1, 1, -0.7, 0.7, 1};
    if (scene.frame && random() % 3 == 0)
        scene.frame->top.reset();
    for (int tries = 0; int(scene.bodies.size()) < count && tries < 10'000; ++tries) {
        Body body{std::to_string(scene.bodies.size()),
                  BodyKind::Ball,
                  number(0.1, 5),
                  number(0.04, 0.14),
                  {number(-0.9, 0.9), number(-0.6, 0.6)},
                  {number(-1, 1), number(-1, 1)}};
        scene.bodies.push_back(body);
        if (!validate(scene).empty())
            scene.bodies.pop_back();
    }
    return scene;
}

} // namespace

class TestBench : public QObject {
    Q_OBJECT

    Language m_language;
private slots:
    void init() {
        m_language.use(Language::Code::English);
        QSettings().clear();
    }

    // The whole of it: to the same value and to the same bytes, back and forth, in one command.
    void everyEditUndoes_data() {
        QTest::addColumn<int>("index");
        const auto edits = everyEdit();
        for (int i = 0; i < int(edits.size()); ++i)
            QTest::addRow("%s", edits[std::size_t(i)].name) << i;
    }
    void everyEditUndoes() {
        QFETCH(int, index);
        const Edit edit = everyEdit()[std::size_t(index)];
        EditBench b;
        openFor(b, edit.scene);
        QCOMPARE(b.desk.undoCount(), 0);
        const Subject before = b.session.subject();
        const QByteArray bytesBefore = b.bytes();
        edit.make(b);
        QCoreApplication::processEvents();
        const Subject after = b.session.subject();
        const QByteArray bytesAfter = b.bytes();
        QVERIFY(!(before == after));
        QVERIFY(validate(after.scene).empty());
        QCOMPARE(b.desk.undoCount(), 1);
        QVERIFY(!b.desk.undoText().isEmpty());
        const QString said = b.desk.undoText();
        for (int round = 0; round < 2; ++round) {
            b.desk.undo();
            QVERIFY(b.session.subject() == before);
            QCOMPARE(b.bytes(), bytesBefore);
            QCOMPARE(b.desk.redoText(), said);
            QVERIFY(!b.desk.canUndo());
            b.desk.redo();
            QVERIFY(b.session.subject() == after);
            QCOMPARE(b.bytes(), bytesAfter);
        }
    }

    void whatWasDoneIsSaid() {
        EditBench b;
        b.drag(b.body(A).position, {0, 0.3});
        QCOMPARE(b.desk.undoText(), QString("move A"));
        type(b.panel, "body1Mass", "3");
        QCOMPARE(b.desk.undoText(), QString("mass of B"));
        click(b.panel, "addBody");
        QCOMPARE(b.desk.undoText(), QString("add C"));
        m_language.use(Language::Code::Korean);
        QCOMPARE(b.desk.undoText(), QString("C 추가"));
    }

    void fiveHundredEditsUndoAndRedo() {
        std::mt19937 random(20261122);
        EditBench b(randomScene(random, 6));
        b.desk.setMergeWithin(0);
        b.session.setUntil(0.3);
        std::vector<Subject> history{b.session.subject()};
        while (history.size() <= 500) {
            Scene scene = b.session.scene();
            const std::size_t i = random() % scene.bodies.size();
            switch (random() % 8) {
            case 0:
                scene.bodies[i].mass = 0.1 + double(random() % 50) / 7;
                break;
            case 1:
                scene.bodies[i].velocity = {double(random() % 9) / 7, -double(random() % 9) / 3};
                break;
            case 2:
                scene.restitution = double(random() % 100) / 99;
                break;
            case 3:
                scene = withOneMore(scene, {}).value_or(scene);
                break;
            case 4:
                if (scene.bodies.size() > 2)
                    scene = without(scene, i);
                break;
            case 5:
                scene.bodies[i].radius *= 0.9;
                break;
            default:
                b.drag(scene.bodies[i].position,
                       {double(random() % 200) / 100 - 1, double(random() % 140) / 100 - 0.7});
                scene = b.session.scene();
            }
            b.session.setScene(scene);
            if (!(b.session.subject() == history.back()))
                history.push_back(b.session.subject());
            QCOMPARE(b.desk.undoCount(), int(history.size()) - 1);
        }
        for (std::size_t k = 500; k-- > 0;) {
            b.desk.undo();
            QVERIFY(b.session.subject() == history[k]);
            QCOMPARE(b.bytes(), writeScene(history[k].scene));
        }
        QVERIFY(!b.desk.canUndo() && !b.desk.isModified());
        for (std::size_t k = 1; k <= 500; ++k) {
            b.desk.redo();
            QCOMPARE(b.bytes(), writeScene(history[k].scene));
        }
        QVERIFY(!b.desk.canRedo());
    }

    void whatBelongsTogetherIsOneCommand() {
        EditBench b;
        b.key(Qt::Key_N);
        for (int k = 0; k < 5; ++k)
            b.key(Qt::Key_Up);
        QCOMPARE(b.desk.undoCount(), 1); // held
        b.key(Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(b.desk.undoCount(), 2); // another kind
        b.desk.setMergeWithin(0);
        QTest::qWait(2);
        b.key(Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(b.desk.undoCount(), 3); // later
        b.desk.setMergeWithin(1000);
        b.drag(b.body(A).position, {0.1, 0.2});
        b.drag(b.body(A).position, {-0.2, 0.2});
        QCOMPARE(b.desk.undoCount(), 5); // two gestures
        b.drag(b.body(A).position, b.body(A).position + Vec2d{0.2, 0});
        b.desk.undo();
        b.desk.undo();
        b.key(Qt::Key_Down); // the future is gone
        QVERIFY(!b.desk.canRedo());
    }

    void escapeAbandonsADrag() {
        EditBench b;
        const Subject before = b.session.subject();
        b.press(b.body(A).position);
        b.move({0, 0.2});
        b.move({0.1, 0.3});
        QVERIFY(!(b.session.subject() == before)); // live
        QVERIFY(b.desk.canUndo());
        b.key(Qt::Key_Escape);
        b.release({0.1, 0.3});
        QCoreApplication::processEvents();
        QVERIFY(b.session.subject() == before);
        QVERIFY(!b.desk.canUndo() && !b.desk.isModified());
    }

    void aClickStillOpensTheCollision() {
        EditBench b;
        b.press(b.body(A).position);
        b.release(b.body(A).position);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(0));
        QVERIFY(!b.desk.canUndo());
        QVERIFY(!b.tool.isActive()); // and there is nothing to drag while it is open
    }

    void onlyWhereItMakesSense() {
        EditBench b;
        QVERIFY(b.tool.isActive());
        b.playhead.setTime(0.2);
        QVERIFY(!b.tool.isActive());
        b.playhead.setTime(0);
        b.session.openBuiltin("bowling");
        QVERIFY(!b.tool.isActive());
        b.session.openBuiltin("gas-100");
        QVERIFY(!b.tool.isActive());
        b.session.openBuiltin("cradle");
        QVERIFY(b.tool.isActive());
        b.tool.setEnabled(false);
        QVERIFY(!b.tool.isActive());
    }

    void bodiesGoWhereTheHandGoes() {
        EditBench b;
        const Vec2d v = b.body(A).velocity;
        b.drag(b.body(A).position + Vec2d{0.05, 0}, {0.05, 0.3}); // held off its centre
        QVERIFY(norm(b.body(A).position - Vec2d{0, 0.3}) < 2 * b.metresPerPixel());
        QVERIFY(b.body(A).velocity == v);
        b.options.setSnap(true);
        b.options.setGrid(0.05);
        b.drag(b.body(A).position, {-0.41, -0.27});
        QVERIFY(std::abs(b.body(A).position.x + 0.4) < 1e-12 &&
                std::abs(b.body(A).position.y + 0.25) < 1e-12);
        b.drag(b.tip(A), {-0.1, -0.1});
        const Vec2d tenths = b.body(A).velocity * 10;
        QVERIFY(std::abs(tenths.x - std::round(tenths.x)) < 1e-9);
        QVERIFY(std::abs(tenths.y - std::round(tenths.y)) < 1e-9);
    }

    void theArrowGoesWhereTheHandGoes() {
        EditBench b;
        const double scale = b.lane.scene().metresPerSpeed();
        const Vec2d to{-0.3, 0.35};
        b.drag(b.tip(A), to);
        const Vec2d reach = to - b.body(A).position;
        const double expected = (norm(reach) - b.body(A).radius) / scale;
        QVERIFY(std::abs(norm(b.body(A).velocity) - expected) < 3 * b.metresPerPixel() / scale);
        QVERIFY(std::abs(b.body(A).velocity.x * reach.y - b.body(A).velocity.y * reach.x) < 0.05);
        b.drag(b.tip(A), b.body(A).position); // into the body: at rest
        QCOMPARE(norm(b.body(A).velocity), 0.0);
    }

    // An oracle of its own: no place of very many that are free is nearer.
    void theNearestFreePlaceIsFoundAndIsFree() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> x(-1.1, 1.1), y(-0.8, 0.8);
        for (int round = 0; round < 300; ++round) {
            const Scene scene = randomScene(random, 2 + int(random() % 11));
            const std::size_t i = random() % scene.bodies.size();
            const double radius = scene.bodies[i].radius;
            const Vec2d wanted{x(random), y(random)};
            const auto place = freePlaceNear(scene, {.radius = radius, .index = int(i), .line = {}}, wanted);
            QVERIFY(place);
            Scene moved = scene;
            moved.bodies[i].position = *place;
            QVERIFY(validate(moved).empty());
            for (int k = 0; k < 300; ++k) {
                const Vec2d p = k % 2 ? *place + (wanted - *place) * (double(random() % 1000) / 1000) +
                                            Vec2d{x(random), y(random)} * 0.02
                                      : Vec2d{x(random), y(random)};
                Scene other = scene;
                other.bodies[i].position = p;
                if (validate(other).empty())
                    QVERIFY(norm(p - wanted) >= norm(*place - wanted) - 1e-9);
            }
        }
    }

    void twoThousandDragsStayValid() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> x(-1.3, 1.3), y(-0.95, 0.95);
        int drags = 0, byMouse = 0;
        while (drags < 2000) {
            EditBench b(randomScene(random, 2 + int(random() % 11)));
            b.session.setUntil(0.2);
            b.panel.hide();
            b.options.setSnap(random() % 3 == 0);
            for (int k = 0; k < 100; ++k, ++drags) {
                const std::size_t i = random() % b.session.scene().bodies.size();
                const auto others = b.session.scene().bodies;
                const bool arrow = random() % 4 == 0;
                if (k % 10 == 0) {
                    b.drag(others[i].position, {x(random), y(random)});
                    ++byMouse;
                } else {
                    const Vec2d from = others[i].position;
                    b.tool.press({int(2 * i) + arrow, {}, {}}, {from, 0.005, {}});
                    for (int step = 0; step < 3; ++step) {
                        b.tool.drag({{x(random), y(random)}, 0.005, {}});
                        const auto errors = validate(b.session.scene());
                        QVERIFY2(errors.empty(), errors.empty() ? "" : errors[0].path.c_str());
                    }
                    random() % 10 ? b.tool.release() : b.tool.abandon();
                }
                QVERIFY(validate(b.session.scene()).empty());
                for (std::size_t j = 0; j < others.size() && k % 10; ++j)
                    QVERIFY(j == i || b.body(j) == others[j]); // nobody else moved
                b.playhead.clearSelection();
                b.playhead.setTime(0);
            }
        }
        QVERIFY(byMouse >= 200);
    }

    void constantSizeIsDensityOrRadius() {
        EditBench b;
        type(b.panel, "body0Mass", "4");
        QCOMPARE(b.body(A).radius, 0.1);
        b.check("constantSize");
        type(b.panel, "body0Mass", "0.5"); // an eighth of it: half as large
        QVERIFY(std::abs(b.body(A).radius - 0.05) < 1e-12);
        type(b.panel, "body0Mass", "0"); // wrong: answered, and nothing changes
        QVERIFY(!message(b.panel, "body0MassMessage").isEmpty());
        type(b.panel, "body0Mass", "4");
        QVERIFY(std::abs(b.body(A).radius - 0.1) < 1e-12);
        b.slide("body0MassSlider", 4, 0.5);
        QVERIFY(std::abs(b.body(A).radius / std::cbrt(b.body(A).mass) - 0.1 / std::cbrt(4)) < 1e-9);
    }

    void twelveBodiesAndNoMore() {
        EditBench b;
        while (b.session.scene().bodies.size() < 12) {
            click(b.panel, "addBody");
            QVERIFY(validate(b.session.scene()).empty());
        }
        QVERIFY(!b.panel.findChild<QPushButton*>("addBody")->isEnabled());
        QVERIFY(!withOneMore(b.session.scene(), {}));
        QVERIFY(b.tool.isActive());
        std::set<std::string> names;
        for (const Body& body : b.session.scene().bodies)
            names.insert(body.id);
        QCOMPARE(names.size(), std::size_t(12));
        while (b.session.scene().bodies.size() > 1)
            click(b.panel, "body0Remove");
        QCoreApplication::processEvents();
        QVERIFY(!b.panel.findChild<QAbstractButton*>("body0Remove")->isEnabled());
        b.key(Qt::Key_N);
        b.key(Qt::Key_Delete); // the last one stays
        QCOMPARE(b.session.scene().bodies.size(), std::size_t(1));
    }

    void noRoomIsSaid() {
        Scene scene;
        scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {0, 0}, {0, 0}}};
        scene.frame = Frame{-0.15, 0.15, -0.15, 0.15, 1};
        EditBench b(scene);
        click(b.panel, "addBody");
        QCOMPARE(b.session.scene().bodies.size(), std::size_t(1));
        QVERIFY(!message(b.panel, "addMessage").isEmpty());
    }

    void oneLineIsKept() {
        EditBench b;
        click(b.panel, "addBody");
        b.check("oneLine");
        QVERIFY(b.options.oneLine());
        QVERIFY(lineOf(b.session.scene()));
        const double y = b.body(A).position.y;
        b.drag(b.body(A).position, {0.2, 0.4});
        QCOMPARE(b.body(A).position.y, y);
        b.drag(b.tip(A), b.tip(A) + Vec2d{-0.3, 0.2});
        QCOMPARE(b.body(A).velocity.y, 0.0);
        type(b.panel, "body1Speed", "-0.7"); // a velocity with its sign
        QVERIFY((b.body(B).velocity == Vec2d{-0.7, 0}));
        QVERIFY(!field(b.panel, "body1Y").isVisible());
        click(b.panel, "addBody");
        QVERIFY(lineOf(b.session.scene()));
        QVERIFY(b.options.oneLine());
        for (int k = 0; k < 5; ++k)
            b.desk.undo();
        while (b.desk.undoText() != "add C")
            b.desk.undo();
        QVERIFY(!b.options.oneLine()); // the scene is on no line any more
    }

    void namesAreTheirOwn() {
        EditBench b;
        type(b.panel, "body1Name", "A");
        QVERIFY(!message(b.panel, "body1NameMessage").isEmpty());
        QCOMPARE(b.body(B).id, std::string("B"));
        type(b.panel, "body1Name", "wall:left");
        QVERIFY(!message(b.panel, "body1NameMessage").isEmpty());
        type(b.panel, "body1Name", "blue");
        QVERIFY(message(b.panel, "body1NameMessage").isEmpty());
        QCOMPARE(b.body(B).id, std::string("blue"));
    }

    void wallsAreAnswered() {
        EditBench b;
        type(b.panel, "wallRightPlace", "-2");
        QVERIFY(!message(b.panel, "wallMessage").isEmpty());
        QCOMPARE(*b.session.scene().frame->right, 1.0);
        type(b.panel, "wallRightPlace", "1.5");
        QVERIFY(message(b.panel, "wallMessage").isEmpty());
        QCOMPARE(*b.session.scene().frame->right, 1.5);
        for (const char* side : {"wallLeft", "wallRight", "wallTop", "wallBottom"})
            b.check(side);
        QVERIFY(!b.session.scene().frame);
        b.check("wallLeft");
        QVERIFY(b.session.scene().frame->left && !b.session.scene().frame->right);
    }

    void undoByKeyInAFieldIsTheScenes() {
        EditBench b;
        FileFlow flow(b.desk, b.panel);
        FileBar bar(b.context, flow, &b.panel);
        bar.show();
        type(b.panel, "body0Mass", "3");
        QLineEdit& mass = field(b.panel, "body0Mass");
        mass.setFocus();
        QTest::keyClick(&mass, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(b.body(A).mass, 2.0);
        QTest::keyClick(&mass, Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(b.body(A).mass, 3.0);
        QTest::keyClick(&mass, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&mass, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(b.body(A).mass, 3.0);
        auto* undo = bar.findChild<QToolButton*>("undoButton");
        QVERIFY(undo->toolTip().contains("mass of A"));
        QTest::mouseClick(undo, Qt::LeftButton);
        QCOMPARE(b.body(A).mass, 2.0);
        QVERIFY(!undo->isEnabled());
    }

    void anEditIsFast() {
        std::mt19937 random(3);
        EditBench b(randomScene(random, 12));
        QElapsedTimer clock;
        clock.start();
        constexpr int count = 100;
        b.press(b.body(A).position);
        for (int k = 0; k < count; ++k)
            b.move(Vec2d{-0.8 + 1.6 * k / count, 0.1});
        const double withPanel = double(clock.nsecsElapsed()) * 1e-6 / count;
        b.panel.hide();
        clock.restart();
        for (int k = 0; k < count; ++k)
            b.move(Vec2d{0.8 - 1.6 * k / count, -0.1});
        const double alone = double(clock.nsecsElapsed()) * 1e-6 / count;
        b.release({0, 0});
        qInfo("12 bodies: %.2f ms an edit with the panel shown, %.2f ms without", withPanel, alone);
        QVERIFY(withPanel < 200);
    }
};

} // namespace thetalane

int main(int argc, char** argv) {
    return thetalane::runWithOwnSettings<thetalane::TestBench>(argc, argv);
}

#include "test_bench.moc"

// Bodies, throw, list and choosers, as a user meets them: typed, clicked, answered.
#include "panel_bench.h"
#include "ui/panels/bodies_panel.h"
#include "ui/panels/collision_list.h"
#include "ui/panels/engine_chooser.h"
#include "ui/panels/number_field.h"
#include "ui/panels/scene_chooser.h"
#include "ui/panels/throw_panel.h"
#include "ui/panels/timeline_bar.h"
#include "ui/panels/value_slider.h"
#include "ui/words/number_text.h"

#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableView>
#include <QWheelEvent>

#include <cmath>
#include <memory>

using namespace thetalane;

namespace {

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max({1.0, std::abs(a), std::abs(b)});
}

// Everything a person can read on a widget and its children.
QStringList textsOf(const QWidget& root) {
    QStringList texts;
    QList<const QWidget*> all{&root};
    for (const QWidget* w : root.findChildren<QWidget*>())
        all.append(w);
    for (const QWidget* w : all) {
        texts << w->toolTip() << w->accessibleName() << w->accessibleDescription();
        if (const auto* label = qobject_cast<const QLabel*>(w))
            texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(w))
            texts << button->text();
        if (const auto* combo = qobject_cast<const QComboBox*>(w))
            for (int i = 0; i < combo->count(); ++i)
                texts << combo->itemText(i);
        if (const auto* menu = qobject_cast<const QMenu*>(w))
            for (const QAction* action : menu->actions())
                texts << action->text();
        if (const auto* table = qobject_cast<const QTableView*>(w))
            for (int c = 0; c < table->model()->columnCount(); ++c)
                for (int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
                    texts << table->model()->headerData(c, Qt::Horizontal, role).toString();
    }
    texts.removeAll(QString());
    return texts;
}

std::vector<std::unique_ptr<QWidget>> everyPanel(const Context& c) {
    std::vector<std::unique_ptr<QWidget>> panels;
    panels.push_back(std::make_unique<BodiesPanel>(c));
    panels.push_back(std::make_unique<ThrowPanel>(c));
    panels.push_back(std::make_unique<CollisionList>(c));
    panels.push_back(std::make_unique<SceneChooser>(c));
    panels.push_back(std::make_unique<EngineChooser>(c));
    panels.push_back(std::make_unique<TimelineBar>(c));
    return panels;
}

} // namespace

class TestPanels : public QObject {
    Q_OBJECT

    Language m_language;

private slots:
    void initTestCase_data() { addLanguages(); }
    void init() {
        QFETCH_GLOBAL(bool, korean);
        useLanguage(m_language, korean);
    }

    void numbersAreReadStrictly() {
        for (const char* good : {"0", "-3", "+2", ".5", "5.", "1e-3", "−3", " 2 "})
            QVERIFY2(parseNumber(QString::fromUtf8(good)), good);
        for (const char* bad : {"", "abc", "1,5", "0x10", "inf", "nan", "1e999", "2 kg", "--1", "1e", "."})
            QVERIFY2(!parseNumber(QString::fromUtf8(bad)), bad);
        QCOMPARE(*parseNumber("−3.5"), -3.5);
    }

    void aMassThatIsTypedChangesTheRun() {
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        type(panel, "body0Mass", "3");
        type(panel, "restitutionField", "0.5");
        QCOMPARE(b.session.scene().bodies[0].mass, 3.0);

        // Closed forms: time of contact, line of centres, and the one-dimensional exchange.
        const Vec2d p{-0.5 - 0.4, 0.0 - 0.05};
        const Vec2d v{1.0, 0.2};
        const double reach = 0.10 + 0.08;
        const double half = dot(p, v);
        const double t =
            (-half - std::sqrt(half * half - dot(v, v) * (dot(p, p) - reach * reach))) / dot(v, v);
        const Vec2d n = (p + v * t) * (1 / reach);
        const double along = dot(v, n);
        const double impulse = -(1 + 0.5) * along / (1 / 3.0 + 1 / 1.0);
        const Collision& first = b.session.timeline().collisions()[0];
        QVERIFY(near(first.time, t));
        QVERIFY(near(first.steps.after.first.x, v.x + impulse / 3 * n.x));
        QVERIFY(near(first.steps.after.first.y, v.y + impulse / 3 * n.y));
        QVERIFY(near(first.steps.after.second.x, -impulse * n.x));
        QVERIFY(near(first.steps.after.second.y, -impulse * n.y));
        QVERIFY(near(first.steps.impulse, impulse));
    }

    void editingOneFieldRoundsNoOther() {
        PanelBench b;
        Scene scene = b.session.scene();
        scene.bodies[0].position.x = -0.5 - 1.0 / 3e7;
        scene.bodies[0].velocity = {1.0 / 3, 0.2 / 7};
        scene.bodies[1].mass = 10.0 / 7;
        QVERIFY(b.session.setScene(scene).empty());
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        type(panel, "body0Mass", "5");
        field(panel, "body0X").setFocus(); // through a field without editing it
        QTest::keyClick(&field(panel, "body0X"), Qt::Key_Return);
        scene.bodies[0].mass = 5;
        QVERIFY(b.session.scene() == scene);
    }

    void speedAndDirectionAreAVector() {
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        type(panel, "body0Direction", "90");
        QCOMPARE(b.session.scene().bodies[0].velocity.x, 0.0); // not 6e-17
        QVERIFY(near(b.session.scene().bodies[0].velocity.y, std::sqrt(1.04)));
        type(panel, "body1Direction", "180"); // kept while there is no speed
        type(panel, "body1Speed", "2");
        QVERIFY((b.session.scene().bodies[1].velocity == Vec2d{-2, 0}));
        type(panel, "body1Speed", "-1");
        QVERIFY(!message(panel, "body1SpeedMessage").isEmpty());
        QVERIFY((b.session.scene().bodies[1].velocity == Vec2d{-2, 0}));
    }

    void badValuesAreAnsweredBesideTheField_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("messageName");
        QTest::newRow("no mass") << "body1Mass"
                                 << "0"
                                 << "body1MassMessage";
        QTest::newRow("negative mass") << "body1Mass"
                                       << "-3"
                                       << "body1MassMessage";
        QTest::newRow("words") << "body1Mass"
                               << "abc"
                               << "body1MassMessage";
        QTest::newRow("nothing") << "body0Radius"
                                 << ""
                                 << "body0MassMessage";
        QTest::newRow("overlap") << "body1X"
                                 << "-0.5"
                                 << "body1XMessage";
        QTest::newRow("overlap, told to the one moved") << "body0X"
                                                        << "0.4"
                                                        << "body0XMessage";
        QTest::newRow("in the wall") << "body0Y"
                                     << "9"
                                     << "body0XMessage";
        QTest::newRow("e") << "restitutionField"
                           << "1.5"
                           << "restitutionMessage";
    }
    void badValuesAreAnsweredBesideTheField() {
        QFETCH(QString, name);
        QFETCH(QString, text);
        QFETCH(QString, messageName);
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        const QString good = field(panel, name).text();
        const auto run = b.session.run();
        type(panel, name, text);
        QVERIFY(!message(panel, messageName).isEmpty());
        QVERIFY(field(panel, name).property("wrong").toBool());
        QVERIFY(b.session.run() == run); // the last good scene stays
        type(panel, name, good);
        QVERIFY(message(panel, messageName).isEmpty());
        QVERIFY(!field(panel, name).property("wrong").toBool());
        type(panel, "body0Mass", "2.5"); // and it goes on from there
        QCOMPARE(b.session.scene().bodies[0].mass, 2.5);
    }

    void keysStepANumber() {
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        QLineEdit& mass = field(panel, "body0Mass");
        mass.setFocus();
        QTest::keyClick(&mass, Qt::Key_Up);
        QCOMPARE(b.session.scene().bodies[0].mass, 2.1);
        QTest::keyClick(&mass, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(b.session.scene().bodies[0].mass, 1.1);
        QTest::keyClicks(&mass, "99");
        QTest::keyClick(&mass, Qt::Key_Escape);
        QCOMPARE(mass.text(), QString("1.1"));
        QCOMPARE(b.session.scene().bodies[0].mass, 1.1);
    }

    void theWheelTurnsOnlyTheFieldInUse() {
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        QLineEdit& speed = field(panel, "body0Speed");
        field(panel, "body0Mass").setFocus();
        const auto turn = [&] {
            QWheelEvent wheel({5, 5}, speed.mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton, {},
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(&speed, &wheel);
        };
        const auto run = b.session.run();
        turn();
        QVERIFY(b.session.run() == run);
        speed.setFocus();
        turn();
        const Vec2d v = b.session.scene().bodies[0].velocity;
        QVERIFY(std::abs(std::hypot(v.x, v.y) - (std::sqrt(1.04) + 0.1)) < 1e-11); // steps: 12 digits
        QVERIFY(near(v.y / v.x, 0.2));                                             // the direction stays
    }

    void leavingAFieldCommitsIt() {
        PanelBench b;
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        QLineEdit& mass = field(panel, "body0Mass");
        mass.setFocus();
        mass.selectAll();
        QTest::keyClicks(&mass, "4");
        QCOMPARE(b.session.scene().bodies[0].mass, 2.0);
        QTest::keyClick(&mass, Qt::Key_Tab);
        QCOMPARE(b.session.scene().bodies[0].mass, 4.0);
    }

    void manyBodiesAreNotAllShown() {
        PanelBench b;
        Scene scene;
        for (int i = 0; i < 200; ++i)
            scene.bodies.push_back({"n" + std::to_string(i), BodyKind::Ball, 1, 0.1, {i * 1.0, 0}, {}});
        QVERIFY(b.session.setScene(scene).empty());
        BodiesPanel panel(b.context);
        showPanel(panel, {340, 560});
        QVERIFY(panel.findChild<QLineEdit*>("body11Mass"));
        QVERIFY(!panel.findChild<QLineEdit*>("body12Mass"));
        QVERIFY(message(panel, "moreBodies").contains("200"));
    }

    void aThrowFollowsItsDials() {
        PanelBench b;
        b.session.openBuiltin("bowling");
        ThrowPanel panel(b.context);
        showPanel(panel, {340, 560});
        const double met = b.session.timeline().collisions()[0].time;
        type(panel, "speedField", "9");
        const Body& ball = b.session.scene().bodies[0];
        QVERIFY(near(std::hypot(ball.velocity.x, ball.velocity.y), 9));
        QVERIFY(b.session.timeline().collisions()[0].time < met);
        auto* slider = panel.findChild<ValueSlider*>("directionSlider");
        QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->xOf(0), slider->height() / 2});
        QCOMPARE(b.session.currentThrow()->direction, 0.0);
        QCOMPARE(field(panel, "directionField").text(), QString("0"));
        QCOMPARE(message(panel, "weightNote"), QString("15.0 lb"));
        QCOMPARE(message(panel, "speedNote"), QString("32.4 km/h"));

        click(panel, "throwButton");
        QVERIFY(b.playhead.playing());
        QTRY_VERIFY(b.playhead.time() > 0);
        click(panel, "defaultThrowButton");
        QVERIFY(*b.session.currentThrow() == Throw{});
        QCOMPARE(field(panel, "speedField").text(), QString("8"));
    }

    void aBadThrowIsAnswered_data() {
        QTest::addColumn<QString>("row");
        QTest::addColumn<QString>("text");
        for (const char* bad : {"0", "-3", "7.3", "heavy"})
            QTest::addRow("weight %s", bad) << "weight" << bad;
        for (const char* bad : {"0", "100.5"})
            QTest::addRow("speed %s", bad) << "speed" << bad;
        for (const char* bad : {"90", "-90"})
            QTest::addRow("direction %s", bad) << "direction" << bad;
        QTest::newRow("off the lane") << "position"
                                      << "0.53";
        QTest::newRow("e") << "pinRestitution"
                           << "-0.1";
    }
    void aBadThrowIsAnswered() {
        QFETCH(QString, row);
        QFETCH(QString, text);
        PanelBench b;
        b.session.openBuiltin("bowling");
        ThrowPanel panel(b.context);
        showPanel(panel, {340, 900});
        const auto run = b.session.run();
        const QString good = field(panel, row + "Field").text();
        type(panel, row + "Field", text);
        QVERIFY(!message(panel, row + "Message").isEmpty());
        QVERIFY(b.session.run() == run);
        type(panel, row + "Field", good);
        QVERIFY(message(panel, row + "Message").isEmpty());
        QVERIFY(b.session.scene() == run->scene); // to the last bit
    }

    void theListAndThePlayheadFollowEachOther() {
        PanelBench b;
        b.session.openBuiltin("rack");
        CollisionList list(b.context);
        showPanel(list, {340, 400});
        auto* table = list.findChild<QTableView*>("collisionTable");
        const auto rowAt = [&](int row) { return table->visualRect(table->model()->index(row, 1)).center(); };
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, rowAt(2));
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(2));
        b.playhead.select(5);
        QCOMPARE(table->currentIndex().row(), 5);
        QVERIFY(table->selectionModel()->isRowSelected(5));
        b.playhead.clearSelection();
        QVERIFY(!table->selectionModel()->hasSelection());
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(5));
        QTest::keyClick(table, Qt::Key_Up);
        QCOMPARE(b.playhead.selected(), std::optional<std::size_t>(4));

        QTest::keyClick(table, Qt::Key_Down, Qt::ShiftModifier);
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 3); // the heading and two rows
        const QStringList cells = lines[1].split('\t');
        const Collision& fifth = b.session.timeline().collisions()[4];
        QCOMPARE(cells[0], QString("5"));
        QCOMPARE(cells[1].toDouble(), fifth.time); // every digit
        QCOMPARE(cells[4].toDouble(), fifth.steps.impulse);
    }

    void anEmptyListSaysSo() {
        PanelBench b;
        Scene scene;
        scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {0, 0}, {1, 0}}};
        QVERIFY(b.session.setScene(scene).empty());
        CollisionList list(b.context);
        showPanel(list, {340, 400});
        QVERIFY(!message(list, "noCollisions").isEmpty());
        b.session.openBuiltin("rack");
        QVERIFY(message(list, "noCollisions").isEmpty());
    }

    void aHundredThousandRowsStayFast() {
        PanelBench b({.chapters = {.chapter = 200'000}});
        Scene scene;
        scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {0, 0}, {2500, 0}}};
        scene.frame = Frame{-0.2, 0.2, {}, {}, 1};
        QVERIFY(b.session.setScene(scene).empty());
        const auto count = b.session.timeline().collisions().size();
        QVERIFY(count > 100'000);
        QElapsedTimer clock;
        clock.start();
        CollisionList list(b.context);
        showPanel(list, {340, 400});
        b.playhead.select(count - 1);
        b.playhead.select(count / 2);
        list.grab();
        QVERIFY2(clock.elapsed() < 1500, qPrintable(QString::number(clock.elapsed()) + " ms"));
    }

    void scenesAndEngines() {
        PanelBench b;
        SceneChooser scenes(b.context);
        EngineChooser engines(b.context);
        auto* button = scenes.findChild<QPushButton*>("sceneButton");
        showPanel(scenes, {400, 40});
        const QString first = button->text();
        scenes.findChild<QAction*>("scene-cradle")->trigger();
        QCOMPARE(b.session.sceneId(), QString("cradle"));
        QVERIFY(button->text() != first);
        const QString whole = button->text();
        Scene edited = b.session.scene();
        edited.bodies[0].mass = 2;
        QVERIFY(b.session.setScene(edited).empty());
        QVERIFY(button->text().startsWith(whole) && button->text() != whole); // and its mark
        QSignalSpy asked(&scenes, &SceneChooser::openFileRequested);
        scenes.findChild<QAction*>("openFileAction")->trigger();
        QCOMPARE(asked.size(), 1);

        EngineSettings settings = b.session.run()->settings;
        settings.until = 3;
        QVERIFY(!b.session.setEngine(settings));
        showPanel(engines, {300, 40});
        auto* combo = engines.findChild<QComboBox*>("engineCombo");
        combo->setFocus();
        const auto now = [&] { return b.session.run()->settings; };
        QTest::keyClick(combo, Qt::Key_Down);
        QVERIFY(now().kind == EngineKind::Stepped && now().step == 1.0 / 60 && !now().approachingOnly);
        QTest::keyClick(combo, Qt::Key_Down);
        QCOMPARE(now().step, 1.0 / 1000);
        QTest::keyClick(combo, Qt::Key_Down);
        QVERIFY(now().approachingOnly && now().step == 1.0 / 60);
        QTest::keyClick(combo, Qt::Key_Down);
        QVERIFY(now().kind == EngineKind::Swept && now().step == 1.0 / 60 && now().passes == 1);
        QCOMPARE(combo->currentIndex(), 4);
        EngineSettings other = now(); // what the list does not hold is named all the same
        other.passes = 8;
        other.step = 1.0 / 240;
        QVERIFY(!b.session.setEngine(other));
        QCOMPARE(combo->currentIndex(), -1);
        QVERIFY(combo->placeholderText().contains("1/240 s") && combo->placeholderText().contains("8"));
        QCOMPARE(now().until, 3.0); // the others stay
        QTest::keyClick(combo, Qt::Key_Home);
        QVERIFY(now().kind == EngineKind::Event);
    }

    void everyWordFollowsTheLanguage() {
        PanelBench b;
        b.session.openBuiltin("bowling");
        for (const auto& panel : everyPanel(b.context)) {
            useLanguage(m_language, false);
            const QStringList english = textsOf(*panel);
            static const QRegularExpression hangul("[가-힣]");
            for (const QString& text : english)
                QVERIFY2(!hangul.match(text).hasMatch(), qPrintable(text));
            useLanguage(m_language, true);
            QVERIFY(textsOf(*panel) != english);
            // Ids, symbols, units and the names on keys are the same in every language.
            static const QRegularExpression same("\\b(ball|kg|km|lb|mph|rad|rpm|Ctrl|Shift|Home|End)\\b");
            static const QRegularExpression word("[A-Za-z]{2,}");
            for (QString text : textsOf(*panel)) {
                const QString original = text;
                QVERIFY2(!word.match(text.remove(same)).hasMatch(), qPrintable(original));
            }
        }
    }

    void panelsFitTheirColumn() {
        PanelBench b;
        b.session.openBuiltin("bowling");
        for (const bool projector : {false, true}) {
            b.appearance.setProjector(projector);
            for (const auto& panel : everyPanel(b.context)) {
                showPanel(*panel, {340, 560});
                for (auto* area : panel->findChildren<QScrollArea*>())
                    QVERIFY2(area->widget()->minimumSizeHint().width() <= 330,
                             qPrintable(QString::number(area->widget()->minimumSizeHint().width())));
                QList<QWidget*> touched;
                for (auto* edit : panel->findChildren<QLineEdit*>())
                    touched << edit;
                for (auto* slider : panel->findChildren<QSlider*>())
                    touched << slider;
                for (auto* button : panel->findChildren<QPushButton*>())
                    touched << button;
                for (const QWidget* widget : touched) {
                    QVERIFY2(widget->height() >= (projector ? 36 : 24), qPrintable(widget->objectName()));
                    QVERIFY(!widget->objectName().isEmpty());
                    QVERIFY2(!widget->toolTip().isEmpty() && !widget->accessibleName().isEmpty(),
                             qPrintable(widget->objectName()));
                }
            }
        }
    }
};

QTEST_MAIN(TestPanels)
#include "test_panels.moc"

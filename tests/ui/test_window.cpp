// The whole window, driven by real keys and clicks, in both languages and at the sizes it is used at.
#include "core/scene/builtin.h"
#include "tests/ui/whole_program.h"
#include "ui/game/alley.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/rail/rail_button.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

using Program = WholeProgram;

QStringList textsOf(const QWidget* w) {
    QStringList texts{w->toolTip(), w->accessibleName(), w->accessibleDescription()};
    if (const auto* label = qobject_cast<const QLabel*>(w))
        texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(w))
        texts << button->text();
    if (const auto* combo = qobject_cast<const QComboBox*>(w))
        for (int i = 0; i < combo->count(); ++i)
            texts << combo->itemText(i);
    if (const auto* table = qobject_cast<const QTableView*>(w))
        for (int c = 0; table->model() && c < table->model()->columnCount(); ++c)
            texts << table->model()->headerData(c, Qt::Horizontal).toString()
                  << table->model()->headerData(c, Qt::Horizontal, Qt::ToolTipRole).toString();
    return texts;
}

// Words in Latin letters that a Korean page may hold: names, ids, keys, functions, units.
QStringList latinWords(const QString& text) {
    static const QStringList allowed{"ThetaLane", "English", "Ctrl", "Space", "Home", "End",  "Enter",
                                     "Esc",       "cos",     "sin",  "rpm",   "rad",  "deg",  "mph",
                                     "tan",       "CSV",     "PNG",  "PDF",   "JSON", "Shift"};
    // Tags, and calls of the command line.
    static const QRegularExpression tags("<[^>]*>|&[a-z]+;|thetalane( [-a-z]+)*"), word("[A-Za-z]{3,}");
    QStringList found;
    auto it = word.globalMatch(QString(text).remove(tags));
    while (it.hasNext())
        if (const QString w = it.next().captured(); !allowed.contains(w))
            found << w;
    return found;
}

QString describe(const QWidget* w) {
    return QString("%1 \"%2\"").arg(w->metaObject()->className(), w->objectName());
}

} // namespace

class TestWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { keepSettingsIn(m_settings, "ThetaLaneTest"); }

    void opensOnTwoBallsAboutToMeet() {
        Program p(Language::Code::English);
        QCOMPARE(p.session.sceneId(), QString("two-balls"));
        QCOMPARE(p.playhead.time(), 0.0);
        QVERIFY(!p.playhead.selected());
    }

    // Start-up to the first worked collision: one key.
    void keysReachCollisionsStagesAndTime() {
        Program p(Language::Code::English);
        QTest::keyClick(&p.window, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(p.playhead.selected(), std::optional<std::size_t>(0));
        QCOMPARE(p.playhead.time(), p.session.timeline().collisions()[0].time);
        QTest::keyClick(&p.window, Qt::Key_Down);
        QTest::keyClick(&p.window, Qt::Key_Down);
        QCOMPARE(int(p.playhead.stage()), 2);
        QTest::keyClick(&p.window, Qt::Key_Up);
        QCOMPARE(int(p.playhead.stage()), 1);
        QTest::keyClick(&p.window, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(p.playhead.selected(), std::optional<std::size_t>(1));
        QTest::keyClick(&p.window, Qt::Key_Left, Qt::ControlModifier);
        QTest::keyClick(&p.window, Qt::Key_Escape);
        QVERIFY(!p.playhead.selected());

        const double before = p.playhead.time();
        QTest::keyClick(&p.window, Qt::Key_Right);
        QVERIFY(std::abs(p.playhead.time() - before - 1.0 / 60) < 1e-12);
        QTest::keyClick(&p.window, Qt::Key_Left);
        QVERIFY(std::abs(p.playhead.time() - before) < 1e-12);

        QTest::keyClick(&p.window, Qt::Key_Space);
        QVERIFY(p.playhead.playing());
        QTRY_VERIFY(p.playhead.time() > before + 0.02);
        QTest::keyClick(&p.window, Qt::Key_Space);
        QVERIFY(!p.playhead.playing());
        QTest::keyClick(&p.window, Qt::Key_R);
        QCOMPARE(p.playhead.time(), 0.0);
    }

    // A button that the Tab key chose is pressed by the space bar; a field, a click leave it to the playhead.
    void spaceBelongsToTheButtonWithTheFocus() {
        Program p(Language::Code::English);
        auto* reset = p.window.findChild<QAbstractButton*>("reset");
        p.playhead.setTime(0.5);
        reset->setFocus(Qt::TabFocusReason);
        QTest::keyClick(reset, Qt::Key_Space);
        QVERIFY(!p.playhead.playing());
        QCOMPARE(p.playhead.time(), 0.0);

        p.window.enter(Room::Attributes);
        auto* mass = p.window.findChild<QLineEdit*>("body0Mass");
        mass->setFocus();
        const QString before = mass->text();
        QTest::keyClick(mass, Qt::Key_Space);
        QVERIFY(p.playhead.playing());
        QCOMPARE(mass->text(), before);
        p.playhead.setPlaying(false);
    }

    // Under a style sheet Qt takes a font away from a widget that gets another parent.
    void invitationIsLargeFromTheFirstPictureOn() {
        Program p(Language::Code::Korean);
        const int large = p.appearance.pixels(Appearance::Size::Large);
        QCOMPARE(p.window.findChild<QLabel*>("invitation")->font().pixelSize(), large);
        QCOMPARE(p.window.findChild<QAbstractButton*>("goToFirstCollision")->font().pixelSize(), large);
    }

    // The open card shows its figure and its first formulas without scrolling, from the back row too.
    void firstFormulasAreSeenOnAProjector() {
        Program p(Language::Code::Korean);
        p.appearance.setProjector(true);
        p.playhead.select(0);
        auto* viewport = p.window.findChild<QAbstractScrollArea*>("stepScroll")->viewport();
        for (int stage = 0; stage < stageCount; ++stage) {
            p.playhead.setStage(Stage(stage));
            auto* card = p.window.findChild<QWidget*>(QString("stepCard%1").arg(stage));
            auto* formulas = card->findChild<QWidget*>("formulaView");
            const int seen = 3 * p.appearance.pixels(Appearance::Size::Normal);
            QTRY_VERIFY2(formulas->mapTo(viewport->window(), QPoint(0, seen)).y() <
                             viewport->mapTo(viewport->window(), QPoint(0, viewport->height())).y(),
                         qPrintable(QString("stage %1").arg(stage)));
        }
    }

    void languageSwitchesEverythingAtOnce() {
        Program p(Language::Code::English);
        auto* steps = p.window.findChild<RailButton*>(QString("room%1").arg(int(Room::Steps)));
        QCOMPARE(steps->text(), QString("Steps"));
        QTest::keyClick(&p.window, Qt::Key_L);
        QCOMPARE(p.language.code(), Language::Code::Korean);
        QCoreApplication::processEvents();
        QVERIFY(steps->text() != "Steps");
        QVERIFY(p.window.findChild<QToolButton*>("korean")->isChecked());
        QTest::mouseClick(p.window.findChild<QToolButton*>("english"), Qt::LeftButton);
        QCoreApplication::processEvents();
        QCOMPARE(steps->text(), QString("Steps"));
    }

    // Before the throw nothing tells how it ends, whatever the throw's panel wishes; the space bar throws.
    void aGameSpoilsNothing() {
        Program p(Language::Code::English);
        QVERIFY(p.session.openBuiltin("bowling"));
        p.window.enter(Room::Attributes);
        QVERIFY(p.session.part().collisionCount > 1);
        p.window.alley().start({{"김", 0}}, ScoringRules::Traditional, {});
        QCOMPARE(p.window.alley().phase(), Alley::Phase::Aim);
        QCoreApplication::processEvents();
        QVERIFY(p.session.part().collisionCount <= 1);
        auto* path = p.window.findChild<QComboBox*>("pathAhead");
        path->setFocus();
        QTest::keyClick(path, Qt::Key_Home);
        QTest::keyClick(path, Qt::Key_End);
        QVERIFY(p.session.part().collisionCount <= 1);
        p.window.findChild<QWidget*>("laneView")->setFocus();
        QTest::keyClick(&p.window, Qt::Key_Space);
        QCOMPARE(p.window.alley().phase(), Alley::Phase::Rolling);
        QVERIFY(p.playhead.playing());
        QVERIFY(p.session.part().collisionCount > 1);
        QCOMPARE(p.window.alley().game().deliveries[0].size(), std::size_t(1));
        const QString kept = p.window.alley().path();
        p.window.alley().close();
        QVERIFY(QFile::remove(kept));
    }

    // A stop that shows another panel keeps its words in sight; a question brings its own panel back, and the
    // title of its scene does not answer it.
    void aLessonIsReadWhateverPanelIsInFront() {
        Program p(Language::Code::Korean, {1024, 700});
        p.window.enter(Room::Lessons);
        auto* lessons = p.window.findChild<LessonPanel*>();
        lessons->giveLesson(4);
        QVERIFY(p.window.findChild<QAbstractButton*>("sceneButton")->text().endsWith("수업의 장면"));
        auto* words = p.window.findChild<QLabel*>("lessonCaptionText");
        QVERIFY(!words->isVisible());
        lessons->player().goTo(2); // shows the steps
        QVERIFY(!lessons->isVisible() && words->isVisible());
        QVERIFY(!words->text().isEmpty());
        QTest::qWait(1);
        QVERIFY(words->height() + 1 >= words->heightForWidth(words->width()));
        p.window.findChild<QAbstractButton*>("captionBack")->click(); // the question
        QVERIFY(lessons->isVisible() && !words->isVisible());
        lessons->player().leave();
        QVERIFY(!p.window.findChild<QAbstractButton*>("sceneButton")->text().endsWith("수업의 장면"));
    }

    void lessonsFitTheWindowWhateverTheyShow_data() {
        QTest::addColumn<int>("lesson");
        for (int k = 0; k < 10; ++k)
            QTest::addRow("lesson %d", k + 1) << k;
    }
    void lessonsFitTheWindowWhateverTheyShow() {
        QFETCH(int, lesson);
        for (const bool projector : {false, true}) {
            const QSize size = projector ? QSize(1280, 800) : QSize(1024, 700);
            Program p(lesson % 2 ? Language::Code::Korean : Language::Code::English, size);
            p.appearance.setProjector(projector);
            p.window.enter(Room::Lessons);
            auto* lessons = p.window.findChild<LessonPanel*>();
            lessons->giveLesson(lesson);
            auto* words = p.window.findChild<QLabel*>("lessonCaptionText");
            const auto* rail = p.window.findChild<Rail*>("rail");
            for (int page = 0; page < lessons->player().pageCount(); ++page) {
                lessons->player().goTo(page);
                const auto fits = [&] {
                    const int right = rail->mapTo(&p.window, QPoint(rail->width(), 0)).x();
                    return p.window.size() == size && right <= size.width() &&
                           (!words->isVisible() ||
                            words->height() + 1 >= words->heightForWidth(words->width()));
                };
                QTRY_VERIFY2(fits(), qPrintable(QString("page %1, window %2 x %3, projector %4")
                                                    .arg(page)
                                                    .arg(p.window.width())
                                                    .arg(p.window.height())
                                                    .arg(projector)));
            }
        }
    }

    void koreanPagesHoldNoEnglish_data() { sceneRows(); }
    void koreanPagesHoldNoEnglish() {
        QFETCH(QString, scene);
        Program p(Language::Code::Korean);
        QVERIFY(p.session.openBuiltin(scene));
        for (const bool open : {false, true}) {
            if (open)
                p.playhead.select(0);
            const auto* rail = p.window.findChild<Rail*>("rail");
            for (int k = 0; rail->offered(k); ++k)
                p.window.enter(*rail->offered(k));
            QCoreApplication::processEvents();
            for (const QWidget* w : p.window.findChildren<QWidget*>())
                for (const QString& text : textsOf(w))
                    QVERIFY2(latinWords(text).isEmpty(), qPrintable(describe(w) + ": " + text));
        }
    }

    void nothingIsClipped_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("korean");
        QTest::addColumn<bool>("projector");
        for (const char* scene : {"two-balls", "rack", "bowling"})
            for (const QSize size : {QSize(1024, 700), QSize(1920, 1080)})
                for (const bool korean : {false, true})
                    for (const bool projector : {false, true})
                        QTest::addRow("%s %dx%d %s%s", scene, size.width(), size.height(),
                                      korean ? "ko" : "en", projector ? " projector" : "")
                            << QString(scene) << size << korean << projector;
    }
    void nothingIsClipped() {
        QFETCH(QString, scene);
        QFETCH(QSize, size);
        QFETCH(bool, korean);
        QFETCH(bool, projector);
        Program p(korean ? Language::Code::Korean : Language::Code::English, size);
        QVERIFY(p.session.openBuiltin(scene));
        p.appearance.setProjector(projector);
        auto* rail = p.window.findChild<Rail*>("rail");
        for (int k = 0; rail->offered(k); ++k) {
            const Room room = *rail->offered(k);
            p.window.enter(room);
            if (room == Room::Steps)
                p.playhead.select(0);
            QTest::qWait(1);
            QCOMPARE(p.window.size(), size); // nothing pushes the window open
            for (const QWidget* w : p.window.findChildren<QWidget*>()) {
                const auto* label = qobject_cast<const QLabel*>(w);
                const auto* button = qobject_cast<const QAbstractButton*>(w);
                const bool icon = qobject_cast<const RailButton*>(w); // may stand without its name
                const bool says = (label && !label->text().isEmpty() && !label->wordWrap()) ||
                                  (button && !icon && !button->text().isEmpty());
                if (says && w->isVisible())
                    QVERIFY2(w->width() + 1 >= w->sizeHint().width(),
                             qPrintable(QString("%1 is %2 wide, needs %3: %4")
                                            .arg(describe(w))
                                            .arg(w->width())
                                            .arg(w->sizeHint().width())
                                            .arg(textsOf(w).join('|'))));
            }
        }
    }

    void aSceneFileIsOpenedAndAWrongOneLeavesTheLastGood() {
        Program p(Language::Code::English);
        const QString good = write("good.json", R"({"format":"thetalane-scene","version":1,"restitution":1,
            "bodies":[{"id":"P","kind":"ball","mass":1,"radius":0.1,"position":[0,0],"velocity":[1,0]}]})");
        const QString bad = write("bad.json", R"({"format":"thetalane-scene","version":1,"restitution":1,
            "bodies":[{"id":"P","kind":"ball","mass":-3,"radius":0.1,"position":[0,0],"velocity":[1,0]}]})");
        p.window.openFile(good);
        QCOMPARE(p.session.scene().bodies.size(), std::size_t(1));
        p.window.openFile(bad);
        auto* message = p.window.findChild<QLabel*>("messageText");
        QVERIFY(message->isVisible());
        QVERIFY2(message->text().contains("bad.json: bodies[0].mass: "), qPrintable(message->text()));
        QVERIFY(message->text().contains("-3"));
        p.language.use(Language::Code::Korean);
        QCoreApplication::processEvents();
        QVERIFY2(message->text().contains("0보다 커야 합니다"), qPrintable(message->text()));
        p.language.use(Language::Code::English);
        QCOMPARE(p.session.scene().bodies[0].mass, 1.0);
        p.window.openFile(m_settings.filePath("nowhere.json"));
        QVERIFY(message->text().contains("nowhere.json"));
        p.window.openFile(good);
        QVERIFY(!message->isVisible());
    }

    void stateIsRemembered() {
        QList<int> sizes;
        {
            Program p(Language::Code::Korean);
            p.window.resize(1111, 777);
            p.appearance.setProjector(true);
            auto* divide = p.window.findChild<QSplitter*>("divide");
            QTest::qWait(1);
            const QPoint handle = divide->handle(1)->rect().center();
            QTest::mousePress(divide->handle(1), Qt::LeftButton, {}, handle);
            QTest::mouseMove(divide->handle(1), handle - QPoint(60, 0));
            QTest::mouseRelease(divide->handle(1), Qt::LeftButton, {}, handle - QPoint(60, 0));
            sizes = divide->sizes();
            QVERIFY(p.window.close());
        }
        QCOMPARE(QSettings().value("language").toString(), QString("ko"));
        Program p(Language::Code::English);
        p.window.restoreState();
        QCOMPARE(p.window.size(), QSize(1111, 777));
        QVERIFY(p.appearance.projector());
        QTest::qWait(1);
        const auto restored = p.window.findChild<QSplitter*>("divide")->sizes();
        QVERIFY2(std::abs(restored[1] - sizes[1]) <= 1,
                 qPrintable(QString("%1 was %2").arg(restored[1]).arg(sizes[1])));
    }

    void cardsGrowWithTheWindow() {
        Program p(Language::Code::English, QSize(1920, 1080));
        QTest::qWait(1);
        const auto wide = p.window.findChild<QSplitter*>("divide")->sizes();
        QVERIFY(wide[1] >= 500);
        p.window.resize(1024, 700);
        QTest::qWait(1);
        QVERIFY(p.window.findChild<QSplitter*>("divide")->sizes()[1] <= 360);
    }

private:
    static void sceneRows() {
        QTest::addColumn<QString>("scene");
        for (const BuiltinScene& s : builtinScenes())
            QTest::newRow(std::string(s.id).c_str()) << QString::fromUtf8(s.id.data(), int(s.id.size()));
    }
    QString write(const QString& name, const QByteArray& text) {
        QFile file(m_settings.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write a test file");
        return file.fileName();
    }
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestWindow)
#include "test_window.moc"

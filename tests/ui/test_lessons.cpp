// Every lesson, given from its card to its last page in both languages, by keys and by mouse: the scene, the
// collision and the stage are those of the file, and every word is seen whole.
#include "panel_bench.h"
#include "ui/lessons/big_text.h"
#include "ui/lessons/card_button.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/lessons/lesson_shelf.h"
#include "ui/lessons/lesson_text.h"
#include "ui/lessons/progress_dots.h"
#include "ui/lessons/question_view.h"

#include <QDir>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>
#include <memory>

using namespace thetalane;

namespace {

// What a window of 1024 by 700 leaves to the panel, without and with a projector.
constexpr QSize usualRoom(344, 540);
constexpr QSize projectorRoom(480, 500);

struct LessonBench : PanelBench {
    explicit LessonBench(bool projector = false, bool reducedMotion = true) {
        appearance.setReducedMotion(reducedMotion);
        appearance.setProjector(projector);
        panel = std::make_unique<LessonPanel>(context);
        showPanel(*panel, projector ? projectorRoom : usualRoom);
    }
    template <class T> T& find(const char* name) {
        auto* found = panel->findChild<T*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    void press(Qt::Key key) {
        QTest::keyClick(panel.get(), key);
        QCoreApplication::processEvents();
    }
    std::unique_ptr<LessonPanel> panel;
};

bool hasHangul(const QString& text) {
    static const QRegularExpression hangul("[\\x{AC00}-\\x{D7A3}]");
    return hangul.match(text).hasMatch();
}

// Every label and button that is seen has room for its words.
QString clippedIn(QWidget& panel) {
    for (QLabel* l : panel.findChildren<QLabel*>()) {
        if (!l->isVisible() || l->text().isEmpty())
            continue;
        if (l->width() > panel.width())
            return l->objectName() + ": wider than the panel";
        const int needed = l->wordWrap() ? l->heightForWidth(l->width()) : l->sizeHint().height();
        if (needed > l->height() + 1)
            return QString("%1: needs %2 px, has %3").arg(l->objectName()).arg(needed).arg(l->height());
        if (!l->wordWrap() && l->sizeHint().width() > l->width() + 1)
            return l->objectName() + ": cut at the side";
    }
    for (QAbstractButton* b : panel.findChildren<QAbstractButton*>()) {
        if (!b->isVisible())
            continue;
        const bool isCard = qobject_cast<CardButton*>(b);
        if (isCard ? b->height() < b->heightForWidth(b->width()) : b->sizeHint().width() > b->width() + 1)
            return b->objectName() + ": cut";
        if (b->height() < 24)
            return b->objectName() + ": too low to press";
    }
    return {};
}

void addLessons() {
    QTest::addColumn<int>("index");
    QTest::addColumn<bool>("korean");
    QTest::addColumn<bool>("projector");
    for (int k = 0; k < int(builtInLessons().size()); ++k)
        for (const bool korean : {false, true})
            for (const bool projector : {false, true})
                QTest::addRow("%s, %s%s", builtInLessons()[std::size_t(k)].title.en.c_str(),
                              korean ? "Korean" : "English", projector ? ", projector" : "")
                    << k << korean << projector;
}

} // namespace

class TestLessons : public QObject {
    Q_OBJECT

    std::unique_ptr<Language> m_language;

    void checkStop(LessonBench& bench, const Lesson& lesson, const LessonStop& stop, bool korean) {
        const LessonSetting& setting = lesson.settings[stop.setting];
        QVERIFY(bench.session.scene() == setting.scene);
        QCOMPARE(int(bench.session.run()->settings.kind), int(setting.engine.kind));
        QCOMPARE(bench.session.run()->settings.step, setting.engine.step);
        QCOMPARE(bench.session.until(), setting.engine.until);
        QCOMPARE(bench.session.sceneId(), QString::fromStdString(setting.sceneId));
        if (stop.at == StopAt::Collision) {
            QCOMPARE(bench.playhead.selectedNumber().value_or(0), stop.collision);
            QCOMPARE(int(bench.playhead.stage()), stop.stage);
        } else {
            QVERIFY(!bench.playhead.selectedNumber());
            QCOMPARE(bench.playhead.time(), stop.at == StopAt::Start ? 0.0 : stop.time);
        }
        QVERIFY(!bench.playhead.playing());
        auto& text = bench.find<BigText>("lessonText");
        QVERIFY(text.isVisible());
        QCOMPARE(text.words(), QString::fromStdString(korean ? stop.text.ko : stop.text.en));
        QVERIFY2(text.isWhole(), qPrintable("must be scrolled: " + text.words()));
    }

    void answer(LessonBench& bench, const Lesson& lesson, bool korean) {
        const LessonQuestion& q = *lesson.question;
        auto& view = bench.find<QuestionView>("lessonQuestion");
        QVERIFY(view.isVisible() && !view.isRevealed());
        QVERIFY2(view.isWhole(), "the question must be scrolled");
        QVERIFY(!bench.playhead.selectedNumber()); // or its stages would tell
        QVERIFY(bench.find<QLabel>("questionVerdict").text().isEmpty());
        QVERIFY(bench.find<QLabel>("questionWhy").text().isEmpty());
        if (q.kind == QuestionKind::Choice) {
            const QString right = QStringLiteral("option%1").arg(q.right);
            auto& option = bench.find<CardButton>(qPrintable(right));
            QCOMPARE(option.words(),
                     QString::fromStdString(korean ? q.options[q.right].ko : q.options[q.right].en));
            QTest::mouseClick(&option, Qt::LeftButton);
            QCOMPARE(int(option.state()), int(CardButton::State::Chosen));
            click(*bench.panel, "lessonNext");
            QCOMPARE(int(option.state()), int(CardButton::State::Right));
        } else {
            const Vec2d truth = *truthOf(lesson);
            type(*bench.panel, "answer0", QString::number(truth.x, 'g', 6));
            QCoreApplication::processEvents();
        }
        QCoreApplication::processEvents();
        QVERIFY(view.isRevealed());
        QVERIFY(q.kind == QuestionKind::Choice ||
                bench.find<QLabel>("questionVerdict").text().startsWith(u'✓'));
        QVERIFY2(view.isWhole(), "the answer must be scrolled");
        QCOMPARE(bench.find<QLabel>("questionWhy").accessibleName(),
                 QString::fromStdString(korean ? q.answer.ko : q.answer.en));
        QCOMPARE(clippedIn(*bench.panel), QString());
    }

private slots:
    void init() { m_language = std::make_unique<Language>(); }
    void cleanup() { useLanguage(*m_language, false); }

    void shelfIsWhole_data() {
        QTest::addColumn<bool>("korean");
        QTest::addColumn<bool>("projector");
        for (const bool korean : {false, true})
            for (const bool projector : {false, true})
                QTest::addRow("%s%s", korean ? "Korean" : "English", projector ? ", projector" : "")
                    << korean << projector;
    }
    void shelfIsWhole() {
        QFETCH(bool, korean);
        QFETCH(bool, projector);
        useLanguage(*m_language, korean);
        LessonBench bench(projector);
        QVERIFY(builtInLessons().size() >= 8 && builtInLessons().size() <= 10);
        QCOMPARE(clippedIn(*bench.panel), QString());
        for (int k = 0; k < int(builtInLessons().size()); ++k) {
            auto& card = bench.find<CardButton>(qPrintable(QStringLiteral("lesson%1").arg(k)));
            QCOMPARE(hasHangul(card.words()), korean);
            QCOMPARE(hasHangul(card.below()), korean);
            QVERIFY(!card.accessibleName().isEmpty() && !card.toolTip().isEmpty());
            QVERIFY(card.height() >= (projector ? 44 : 32));
        }
    }

    void everyLesson_data() { addLessons(); }
    void everyLesson() {
        QFETCH(int, index);
        QFETCH(bool, korean);
        QFETCH(bool, projector);
        useLanguage(*m_language, korean);
        LessonBench bench(projector);
        const Lesson& lesson = builtInLessons()[std::size_t(index)];
        auto& card = bench.find<CardButton>(qPrintable(QStringLiteral("lesson%1").arg(index)));
        bench.find<QScrollArea>("lessonShelf").ensureWidgetVisible(&card);
        QTest::mouseClick(&card, Qt::LeftButton);
        LessonPlayer& player = bench.panel->player();
        QVERIFY(player.running() && !bench.panel->isShelf());
        for (int page = 0; page < player.pageCount(); ++page) {
            QCOMPARE(player.page(), page);
            QCOMPARE(clippedIn(*bench.panel), QString());
            QCOMPARE(hasHangul(bench.find<QLabel>("lessonTitle").text()), korean);
            if (player.isQuestion())
                answer(bench, lesson, korean);
            else
                checkStop(bench, lesson, *player.stop(), korean);
            if (QTest::currentTestFailed())
                return;
            if (page + 1 == player.pageCount())
                break;
            if (page % 2)
                click(*bench.panel, "lessonNext");
            else
                bench.press(Qt::Key_PageDown);
        }
        for (int page = player.pageCount() - 1; page > 0; --page) {
            QCOMPARE(player.page(), page);
            bench.press(Qt::Key_PageUp);
        }
        checkStop(bench, lesson, lesson.stops.front(), korean);
        click(*bench.panel, "leaveLesson");
        QVERIFY(bench.panel->isShelf() && !player.running());
        QCOMPARE(int(bench.session.run()->settings.kind), int(EngineKind::Event));
    }

    void playsToAStopAndHolds() {
        LessonBench bench(false, false);
        bench.panel->giveLesson(0);
        LessonPlayer& player = bench.panel->player();
        QVERIFY(player.travelling() && bench.playhead.playing());
        QVERIFY(bench.playhead.time() < 0.1);
        QTRY_VERIFY_WITH_TIMEOUT(!player.travelling(), 8000);
        QVERIFY(!bench.playhead.playing());
        QCOMPARE(bench.playhead.selectedNumber().value_or(0), std::int64_t(1));
        QCOMPARE(bench.playhead.rate(), 1.0); // the user's again
        QTest::qWait(60);
        QCOMPARE(bench.playhead.selectedNumber().value_or(0), std::int64_t(1)); // it holds
    }

    void aSecondPressIsThereAtOnce() {
        LessonBench bench(false, false);
        bench.panel->giveLesson(4); // from the contact to stage 4, by playing
        LessonPlayer& player = bench.panel->player();
        bench.press(Qt::Key_PageDown);
        QVERIFY(!player.travelling());
        QCOMPARE(player.page(), 0);
        bench.press(Qt::Key_PageDown); // the question
        QVERIFY(player.isQuestion());
        QVERIFY(bench.playhead.time() < bench.session.timeline().collisions()[0].time);
        bench.press(Qt::Key_PageDown); // reveals
        QVERIFY(player.isQuestion() && bench.find<QuestionView>("lessonQuestion").isRevealed());
        bench.press(Qt::Key_PageDown);
        QVERIFY(player.travelling());
        QTRY_VERIFY_WITH_TIMEOUT(bench.playhead.stage() == Stage::Split, 8000); // one after the other
        bench.press(Qt::Key_PageDown);
        QCOMPARE(int(bench.playhead.stage()), 4);
        QVERIFY(!player.travelling());
        QCOMPARE(player.page(), 2);
    }

    void keysAlone() {
        LessonBench bench;
        auto& first = bench.find<CardButton>("lesson0");
        first.setFocus();
        QTest::keyClick(&first, Qt::Key_Down);
        auto* second = qobject_cast<CardButton*>(QApplication::focusWidget());
        QVERIFY(second && second->objectName() == "lesson1");
        QTest::keyClick(second, Qt::Key_Return);
        QVERIFY(bench.panel->player().running());
        QCOMPARE(bench.panel->player().lesson().title.en, builtInLessons()[1].title.en);
        QTest::keyClick(bench.panel.get(), Qt::Key_Escape);
        QVERIFY(bench.panel->isShelf());
        bench.press(Qt::Key_PageDown); // turns nothing now
        QVERIFY(bench.panel->isShelf());
    }

    void aWrongAnswerIsSetRight() {
        LessonBench bench;
        bench.panel->giveLesson(0);
        bench.press(Qt::Key_PageDown);
        type(*bench.panel, "answer0", "abc");
        QCoreApplication::processEvents();
        auto& view = bench.find<QuestionView>("lessonQuestion");
        QVERIFY(!view.isRevealed());
        QVERIFY(bench.find<QLabel>("questionHint").text().contains("abc"));
        type(*bench.panel, "answer0", "2");
        QCoreApplication::processEvents();
        QVERIFY(view.isRevealed());
        QCOMPARE(bench.find<QLabel>("questionVerdict").accessibleName(),
                 QString("✗ It is 0.5 m/s, not 2 m/s."));
        click(*bench.panel, "askAgain");
        QVERIFY(!view.isRevealed());
        click(*bench.panel, "lessonNext"); // without an answer of one's own
        QCOMPARE(bench.find<QLabel>("questionVerdict").accessibleName(), QString("It is 0.5 m/s."));
    }

    void aWrongChoiceIsMarked() {
        LessonBench bench;
        bench.panel->giveLesson(1);
        bench.press(Qt::Key_PageDown);
        auto& wrong = bench.find<CardButton>("option0");
        QTest::mouseClick(&wrong, Qt::LeftButton);
        click(*bench.panel, "lessonNext");
        QCOMPARE(int(wrong.state()), int(CardButton::State::Wrong));
        QCOMPARE(int(bench.find<CardButton>("option1").state()), int(CardButton::State::Right));
    }

    void anotherSceneIsNoticedAndPutBack() {
        LessonBench bench;
        bench.panel->giveLesson(0);
        auto& note = bench.find<QLabel>("lessonChanged");
        QVERIFY(!note.isVisible());
        Scene scene = bench.session.scene();
        scene.bodies[0].mass = 3;
        QVERIFY(bench.session.setScene(scene).empty());
        QVERIFY(note.isVisible());
        click(*bench.panel, "putLessonBack");
        QVERIFY(!note.isVisible());
        QCOMPARE(bench.session.scene().bodies[0].mass, 1.0);
        QCOMPARE(bench.playhead.selectedNumber().value_or(0), std::int64_t(1));
        EngineSettings stepped = bench.session.run()->settings;
        stepped.kind = EngineKind::Stepped;
        QVERIFY(!bench.session.setEngine(stepped));
        QVERIFY(note.isVisible());
        bench.press(Qt::Key_PageDown);
        QVERIFY(!note.isVisible());
        QCOMPARE(int(bench.session.run()->settings.kind), int(EngineKind::Event));
    }

    void theEngineOfBeforeComesBack() {
        LessonBench bench;
        EngineSettings swept = bench.session.run()->settings;
        swept.kind = EngineKind::Swept;
        QVERIFY(!bench.session.setEngine(swept));
        bench.panel->giveLesson(7);
        QCOMPARE(int(bench.session.run()->settings.kind), int(EngineKind::Event));
        click(*bench.panel, "leaveLesson");
        QCOMPARE(int(bench.session.run()->settings.kind), int(EngineKind::Swept));
    }

    void dotsGoThere() {
        LessonBench bench;
        bench.panel->giveLesson(0);
        auto& dots = bench.find<ProgressDots>("lessonDots");
        // Four pages, three units apart.
        QTest::mouseClick(&dots, Qt::LeftButton, {}, {dots.width() / 2 + 36, dots.height() / 2});
        QCOMPARE(bench.panel->player().page(), 3);
        QCOMPARE(int(bench.playhead.stage()), 5);
    }

    void showsWhatAStopAsksFor() {
        LessonBench bench;
        QSignalSpy spy(bench.panel.get(), &LessonPanel::showRequested);
        bench.panel->giveLesson(0);
        bench.press(Qt::Key_PageDown);
        QCOMPARE(spy.size(), 0);
        bench.press(Qt::Key_PageDown); // the answer
        bench.press(Qt::Key_PageDown);
        QCOMPARE(spy.size(), 1);
        QVERIFY(spy[0][0].value<LessonShow>() == LessonShow::Steps);
    }

    // What could tell the answer is hidden by who listens to this.
    void tellsOthersWhileItAsks() {
        LessonBench bench;
        QSignalSpy spy(bench.panel.get(), &LessonPanel::asking);
        bench.panel->giveLesson(4);
        QVERIFY(!spy.last()[0].toBool());
        bench.press(Qt::Key_PageDown);
        QVERIFY(spy.last()[0].toBool());
        bench.press(Qt::Key_PageDown); // the answer
        QVERIFY(!spy.last()[0].toBool());
        bench.press(Qt::Key_PageUp);
        bench.press(Qt::Key_PageDown);
        click(*bench.panel, "leaveLesson");
        QVERIFY(!spy.last()[0].toBool());
    }

    void nothingOpensOverUnsavedWork() {
        LessonBench bench;
        bool may = false;
        bench.panel->setMayOpen([&may] { return may; });
        bench.panel->giveLesson(0);
        QVERIFY(bench.panel->isShelf());
        may = true;
        bench.panel->giveLesson(0);
        QVERIFY(!bench.panel->isShelf());
    }

    void filesOfOnesOwn_data() { addLanguages(); }
    void filesOfOnesOwn() {
        QFETCH(bool, korean);
        useLanguage(*m_language, korean);
        LessonBench bench;
        QTemporaryDir dir;
        const auto write = [&](QByteArray json) {
            QFile file(dir.filePath("own.json"));
            if (!file.open(QIODevice::WriteOnly))
                qFatal("cannot write");
            file.write(json);
            return file.fileName();
        };
        QFile source(":/lessons/01-head-on.json");
        QVERIFY(source.open(QIODevice::ReadOnly));
        const QByteArray good = source.readAll();
        auto& note = bench.find<QLabel>("lessonFileMessage");
        QVERIFY(!bench.panel->openFile(write(QByteArray(good).replace("\"stage\": 3", "\"stage\": 9"))));
        QVERIFY(note.isVisible());
        QVERIFY(note.text().startsWith("own.json: stops[1].stage: "));
        QCOMPARE(hasHangul(note.text()), korean);
        QVERIFY(
            !bench.panel->openFile(write(QByteArray(good).replace("\"body\": \"A\"", "\"body\": \"X\""))));
        QVERIFY(note.text().startsWith("own.json: question.body: "));
        QVERIFY(note.text().contains("\"A\", \"B\""));
        QCOMPARE(hasHangul(note.text()), korean);
        QVERIFY(!bench.panel->openFile(dir.filePath("none.json")));
        QVERIFY(bench.panel->openFile(write(good)));
        QVERIFY(!note.isVisible() && !bench.panel->isShelf());
    }

    // Long words of a teacher's own are scrolled, not cut.
    void longWordsAreScrolled() {
        Appearance appearance;
        BigText text(appearance, "long");
        text.resize(300, 200);
        text.show();
        text.setWords(QString("A sentence of many words. ").repeated(60));
        QCoreApplication::processEvents();
        QVERIFY(!text.isWhole());
        QVERIFY(text.verticalScrollBar()->maximum() > 0);
        text.setWords("Short.");
        QVERIFY(text.isWhole());
    }

    void languageSwitchesInTheMiddle() {
        LessonBench bench;
        bench.panel->giveLesson(2);
        useLanguage(*m_language, true);
        QVERIFY(hasHangul(bench.find<BigText>("lessonText").words()));
        QVERIFY(hasHangul(bench.find<QAbstractButton>("lessonNext").text()));
        bench.press(Qt::Key_PageDown);
        bench.press(Qt::Key_PageDown);
        QVERIFY(bench.panel->player().isQuestion());
        QVERIFY(hasHangul(bench.find<QLabel>("questionText").text()));
        useLanguage(*m_language, false);
        QVERIFY(!hasHangul(bench.find<QLabel>("questionText").text()));
    }

    void projectorSwitchesInTheMiddle() {
        LessonBench bench;
        bench.panel->giveLesson(3);
        bench.appearance.setProjector(true);
        bench.panel->resize(projectorRoom);
        QCoreApplication::processEvents();
        QCOMPARE(clippedIn(*bench.panel), QString());
        QVERIFY(bench.find<BigText>("lessonText").isWhole());
        QVERIFY(bench.find<QLabel>("lessonTextLabel").font().pixelSize() >= 26);
    }
};

QTEST_MAIN(TestLessons)
#include "test_lessons.moc"

// The scene as a document: files that stay whole, unsaved changes, recovery after a crash.
#include "tests/ui/edit_bench.h"
#include "ui/bench/file_bar.h"
#include "ui/bench/recovery_bar.h"
#include "ui/panels/scene_chooser.h"

#include <QAction>
#include <QDir>
#include <QElapsedTimer>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>

#include <csignal>
#include <cstdio>
#include <sys/resource.h>
#include <unistd.h>

namespace thetalane {
namespace {

// What the tests start to kill it.
int saveForEver(const QString& path) {
    Scene scene;
    for (int k = 0; k < 3000; ++k)
        scene.bodies.push_back(
            {std::to_string(k), BodyKind::Ball, 1 + k / 7.0, 0.1, {k * 0.3, 0}, {1 / 3.0, 0}});
    for (int k = 0;; ++k) {
        scene.bodies[0].mass = 1 + k;
        saveWhole(path, writeScene(scene));
        if (k == 0) {
            std::puts("saved");
            std::fflush(stdout);
        }
    }
}

int crash(const QString& directory) {
    Session session;
    Desk desk(session);
    desk.keepRecoveriesIn(directory, 5);
    session.openBuiltin("two-balls");
    desk.save(QFileInfo(directory).dir().filePath("lesson.json"));
    Scene scene = session.scene();
    scene.bodies[A].mass = 7.25;
    session.setScene(scene);
    QElapsedTimer clock;
    clock.start();
    while (QDir(directory).entryList({"*.recovery"}).isEmpty() && clock.elapsed() < 30'000)
        QCoreApplication::processEvents();
    return kill(getpid(), SIGKILL);
}

int other(const QStringList& arguments) {
    return arguments[0] == "--crash" ? crash(arguments[1]) : saveForEver(arguments[1]);
}

} // namespace

class TestDesk : public QObject {
    Q_OBJECT

    Language m_language;
    QTemporaryDir m_dir;

    QString place(const QString& name) const { return m_dir.filePath(name); }

private slots:
    void init() {
        m_language.use(Language::Code::English);
        QSettings().clear();
    }

    void whatIsSavedOpensAgain() {
        EditBench b;
        b.drag(b.body(A).position, {0.123, 0.2});
        QVERIFY(b.desk.isModified());
        const QByteArray bytes = b.bytes();
        QVERIFY(b.desk.save(place("a.json")));
        QVERIFY(!b.desk.isModified());
        QCOMPARE(b.desk.documentName(), QString("a"));
        b.desk.undo();
        QVERIFY(b.desk.isModified());
        b.desk.redo();
        QVERIFY(!b.desk.isModified());
        b.desk.openNew();
        QVERIFY(b.desk.file().isEmpty() && !b.desk.canUndo());
        QVERIFY(validate(b.session.scene()).empty());
        QVERIFY(b.desk.open(place("a.json")));
        QCOMPARE(b.bytes(), bytes);
        QVERIFY(!b.desk.isModified() && !b.desk.canUndo());
    }

    void aSaveThatFailsLeavesTheFileWhole() {
        EditBench b;
        const QString path = place("whole.json");
        QVERIFY(b.desk.save(path));
        const auto read = [&] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray saved = read();
        while (b.session.scene().bodies.size() < 12)
            click(b.panel, "addBody");
        QString said;
        connect(&b.desk, &Desk::failed, &b.desk, [&](const Words& why) { said = why(); });
        // No byte more than a few hundred may be written: as on a full disk.
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit usual{};
        getrlimit(RLIMIT_FSIZE, &usual);
        rlimit little = usual;
        little.rlim_cur = 300;
        setrlimit(RLIMIT_FSIZE, &little);
        const bool done = b.desk.save(path);
        setrlimit(RLIMIT_FSIZE, &usual);
        QVERIFY(!done);
        QVERIFY(said.contains("whole.json"));
        QCOMPARE(read(), saved);
        QVERIFY(b.desk.isModified());
        QCOMPARE(QDir(m_dir.path()).entryList({"whole.json*"}, QDir::Files | QDir::Hidden).size(), 1);

        said.clear();
        QVERIFY(!b.desk.save(place("nowhere/at/all.json"))); // a directory that is not there
        QVERIFY(!said.isEmpty());
        QCOMPARE(b.desk.file(), path); // it is still the old one's
    }

    void aKillInTheMiddleOfSavingLosesNothing() {
        const QString path = place("killed.json");
        for (int round = 0; round < 8; ++round) {
            QProcess saver;
            saver.start(QCoreApplication::applicationFilePath(), {"--save-for-ever", path});
            QVERIFY(saver.waitForStarted());
            QVERIFY(saver.waitForReadyRead(60'000)); // it has saved once
            QTest::qWait(7 + 13 * round);
            saver.kill();
            QVERIFY(saver.waitForFinished());
            QVERIFY(std::holds_alternative<Scene>(readSceneFile(path)));
        }
    }

    void wrongFilesAreAnswered() {
        EditBench b;
        b.drag(b.body(A).position, {0, 0.3});
        const Subject before = b.session.subject();
        QFile wrong(place("wrong.json"));
        QVERIFY(wrong.open(QIODevice::WriteOnly));
        wrong.write("{\"format\": \"thetalane-scene\", \"version\": 1, \"bodies\": []}");
        wrong.close();
        QStringList said;
        connect(&b.desk, &Desk::failed, &b.desk, [&](const Words& why) { said << why(); });
        QVERIFY(!b.desk.open(place("wrong.json")));
        QVERIFY(!b.desk.open(place("missing.json")));
        QCOMPARE(said.size(), 2);
        QVERIFY(said[0].startsWith("wrong.json: ") && said[1].startsWith("missing.json: "));
        QVERIFY(b.session.subject() == before && b.desk.canUndo());
        QVERIFY(b.desk.recentFiles().isEmpty());
    }

    void tenRecentFiles() {
        EditBench b;
        for (int k = 0; k < 12; ++k)
            QVERIFY(b.desk.save(place(QString("r%1.json").arg(k))));
        QVERIFY(b.desk.open(place("r5.json")));
        const QStringList recent = b.desk.recentFiles();
        QCOMPARE(recent.size(), 10);
        QCOMPARE(QFileInfo(recent[0]).fileName(), QString("r5.json"));
        QCOMPARE(QFileInfo(recent[1]).fileName(), QString("r11.json"));
        QFile::remove(place("r11.json"));
        FileFlow flow(b.desk, b.panel);
        FileBar bar(b.context, flow);
        auto* menu = bar.findChild<QMenu*>("recentMenu");
        emit menu->aboutToShow();
        QVERIFY(menu->actions()[0]->isEnabled());
        QVERIFY(!menu->actions()[1]->isEnabled());
        menu->actions()[2]->trigger();
        QCOMPARE(b.desk.documentName(), QString("r10"));
        bar.findChild<QAction*>("clearRecentAction")->trigger();
        QVERIFY(b.desk.recentFiles().isEmpty());
    }

    void unsavedChangesAreAskedAbout() {
        EditBench b;
        QWidget window;
        showPanel(window, {300, 200});
        FileFlow flow(b.desk, window);
        const auto answer = [&](const char* button) {
            auto* box = window.findChild<QMessageBox*>("unsavedQuestion");
            QVERIFY(box && box->isVisible());
            QTest::mouseClick(box->findChild<QPushButton*>(QLatin1String(button)), Qt::LeftButton);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QCoreApplication::processEvents();
        };
        int done = 0;
        flow.whenSafe([&] { ++done; });
        QCOMPARE(done, 1); // nothing to ask about
        QVERIFY(b.desk.save(place("asked.json")));
        b.drag(b.body(A).position, {0, 0.3});
        const QByteArray edited = b.bytes();

        flow.openNew();
        QVERIFY(b.bytes() == edited); // until it is answered
        answer("keepEditing");
        QVERIFY(b.bytes() == edited && b.desk.isModified());
        flow.whenSafe([&] { ++done; });
        answer("saveChanges");
        QCOMPARE(done, 2);
        QVERIFY(!b.desk.isModified());
        QCOMPARE(writeScene(std::get<Scene>(readSceneFile(place("asked.json")))), edited);
        b.drag(b.body(A).position, {-0.3, 0.3});
        flow.openNew();
        answer("discardChanges");
        QVERIFY(b.desk.file().isEmpty() && !b.desk.isModified());

        // The chooser asks by the same way; a throw is no unsaved change.
        SceneChooser chooser(b.context);
        chooser.setGuard([&](std::function<void()> open) { flow.whenSafe(std::move(open)); });
        b.drag(b.body(A).position, {-0.3, 0.3});
        chooser.findChild<QAction*>("scene-bowling")->trigger();
        QVERIFY(!b.session.currentThrow());
        answer("discardChanges");
        QVERIFY(b.session.currentThrow());
        Throw t = *b.session.currentThrow();
        t.speed = 9;
        b.session.setThrow(t, 0.75);
        QVERIFY(b.desk.canUndo() && !b.desk.isModified());
    }

    void aSceneOpenedOverChangesCanBeTakenBack() {
        EditBench b;
        QVERIFY(b.desk.save(place("mine.json")));
        b.drag(b.body(A).position, {0, 0.3});
        const Subject mine = b.session.subject();
        b.session.openBuiltin("cradle");  // nobody asked
        QVERIFY(b.desk.file().isEmpty()); // saving does not write the cradle over it
        b.desk.undo();
        QVERIFY(b.session.subject() == mine);
        QVERIFY(b.desk.file().endsWith("mine.json"));
        b.session.openBuiltin("cradle");
        b.session.openBuiltin("bowling");
        b.desk.undo();
        b.desk.undo();
        QVERIFY(b.session.subject() == mine);
    }

    void aResetCanBeUndone() {
        EditBench b;
        b.drag(b.body(A).position, {0, 0.3});
        const Subject edited = b.session.subject();
        b.session.reset();
        QVERIFY(!(b.session.subject() == edited));
        QCOMPARE(b.desk.undoText(), QString("reset the scene"));
        b.desk.undo();
        QVERIFY(b.session.subject() == edited);
    }

    void aGameIsNotRecorded() {
        EditBench b;
        b.desk.setRecording(false);
        b.session.openBuiltin("bowling");
        b.session.setDelivery(Throw{}, PinSet(5), {});
        QVERIFY(!b.desk.canUndo() && !b.desk.isModified());
        b.desk.setRecording(true);
        QVERIFY(!b.desk.canUndo());
        b.session.setThrow({.speed = 7}, 0.75);
        QCOMPARE(b.desk.undoCount(), 1);
    }

    void aCrashLosesNothing() {
        const QString kept = place("recovery");
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(), {"--crash", kept});
        QVERIFY(program.waitForFinished(60'000));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        EditBench b;
        b.desk.keepRecoveriesIn(kept);
        QCOMPARE(b.desk.recoverable().size(), std::size_t(1));
        Session secondSession;
        Desk second(secondSession); // two at once: it is ours to offer
        second.keepRecoveriesIn(kept);
        QVERIFY(second.recoverable().empty());

        QWidget window;
        FileFlow flow(b.desk, window);
        RecoveryBar bar(b.context, flow, &window);
        showPanel(window, {900, 60});
        QVERIFY(bar.isVisible());
        QVERIFY(bar.findChild<QLabel*>("recoveryText")->text().contains("lesson"));
        click(bar, "recoverButton");
        QVERIFY(!bar.isVisible());
        QCOMPARE(b.body(A).mass, 7.25);
        QVERIFY(b.desk.isModified());
        QCOMPARE(b.desk.documentName(), QString("lesson"));
        QVERIFY(b.desk.recoverable().empty());
    }

    void aLivingProgramKeepsItsOwn() {
        const QString kept = place("living");
        {
            EditBench first;
            first.desk.keepRecoveriesIn(kept, 1);
            first.drag(first.body(A).position, {0, 0.3});
            QTRY_COMPARE(QDir(kept).entryList({"*.recovery"}).size(), 1);
            EditBench second;
            second.desk.keepRecoveriesIn(kept, 1);
            QVERIFY(second.desk.recoverable().empty());
            second.drag(second.body(A).position, {0.1, 0.3});
            QTRY_COMPARE(QDir(kept).entryList({"*.recovery"}).size(), 2);
            first.desk.undo(); // nothing unsaved any more
            QTRY_COMPARE(QDir(kept).entryList({"*.recovery"}).size(), 1);
        }
        QCOMPARE(QDir(kept).entryList(QDir::Files).size(), 0); // an orderly end leaves nothing
    }
};

} // namespace thetalane

int main(int argc, char** argv) {
    return thetalane::runWithOwnSettings<thetalane::TestDesk>(argc, argv, &thetalane::other);
}

#include "test_desk.moc"

// The rooms of the repository, and which way things flow between them.
#include "tests/architecture/include_rules.h"

#include <QDirIterator>
#include <QFile>
#include <QTest>

using namespace thetalane::architecture;

namespace {

QStringList sourceFiles() {
    const QDir root(THETALANE_SOURCE_DIR);
    QStringList files;
    for (const char* top : {"core", "ui", "app"}) {
        QDirIterator it(root.filePath(top), {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext())
            files << root.relativeFilePath(it.next());
    }
    files.sort();
    return files;
}

QString textOf(const QString& path) {
    QFile file(QDir(THETALANE_SOURCE_DIR).filePath(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

class TestArchitecture : public QObject {
    Q_OBJECT

private slots:
    void includesRunOneWay() {
        const QStringList files = sourceFiles();
        QVERIFY(files.size() > 30);
        QVERIFY(files.contains("core/collision/pair_collision.h"));
        QStringList broken;
        int includes = 0;
        for (const QString& path : files) {
            const QString text = textOf(path);
            QVERIFY2(!text.isEmpty(), qPrintable(path));
            includes += int(includesOf(text).size());
            broken << violations(path, text);
        }
        QVERIFY(includes > 100);
        QVERIFY2(broken.isEmpty(), qPrintable("\n" + broken.join('\n')));
    }

    // The checker itself: one row a rule, a file that breaks it and one beside it that does not.
    void theCheckerCanFail_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("line");
        QTest::addColumn<bool>("allowed");
        const auto row = [](const char* path, const char* line, bool allowed) {
            QTest::addRow("%s: %s", path, line) << QString(path) << QString(line) << allowed;
        };
        row("core/math/vec2.h", "#include <cmath>", true);
        row("core/math/vec2.h", "#include \"core/scene/scene.h\"", false);
        row("core/collision/a.h", "#include \"core/math/vec2.h\"", true);
        row("core/collision/a.h", "#include \"core/motion/impact.h\"", false);
        row("core/motion/a.h", "#include \"core/collision/pair_collision.h\"", false);
        row("core/motion/a.h", "#include \"core/motion/impact.h\"", true);
        row("core/timeline/a.cpp", "#include \"core/scene/scene.h\"", true);
        row("core/timeline/a.cpp", "#include \"core/engine/engine.h\"", false);
        row("core/engine/a.cpp", "  #  include \"core/bowling/pinfall.h\"", false);
        row("core/bowling/a.cpp", "#include \"core/engine/engine.h\"", true);
        row("core/engine/a.cpp", "#include <QString>", false);
        row("core/engine/a.cpp", "#include <QtCore/qglobal.h>", false);
        row("core/format/a.cpp", "#include <QString>", true);
        row("core/format/a.cpp", "#include \"ui/words/language.h\"", false);
        row("core/engine/a.cpp", "// #include \"ui/session.h\"", true);
        row("core/engine/a.cpp", "/* #include \"ui/session.h\"\n*/", true);
        row("core/engine/a.cpp", "#include \"vec2.h\"", false);
        row("ui/words/a.cpp", "#include \"core/engine/engine.h\"", true);
        row("ui/words/a.cpp", "#include \"ui/session.h\"", false);
        row("ui/session.cpp", "#include \"ui/words/language.h\"", true);
        row("ui/session.cpp", "#include \"core/engine/models.h\"", true);
        row("ui/session.cpp", "#include \"ui/panels/ball_panel.h\"", false);
        row("ui/session.cpp", "#include \"ui/window/main_window.h\"", false);
        row("ui/window/main_window.cpp", "#include \"ui/panels/ball_panel.h\"", true);
        row("ui/window/main_window.h", "#include \"app/main.h\"", false);
        row("ui/panels/a.cpp", "#include \"ui/session.h\"", true);
        row("ui/panels/a.cpp", "#include \"core/engine/engine.h\"", true);
        row("ui/panels/a.cpp", "#include \"core/engine/engines.h\"", false);
        row("ui/lane/a.cpp", "#include \"core/engine/next_event_engine.h\"", false);
        row("ui/steps/a.cpp", "#include \"core/engine/models.h\"", false);
        row("ui/panels/a.cpp", "#include \"ui/lane/lane_view.h\"", false);
        row("ui/lane/a.cpp", "#include \"ui/steps/step_panel.h\"", false);
        row("ui/steps/a.cpp", "#include \"ui/window/main_window.h\"", false);
        row("ui/panels/a_panel.cpp", "#include \"ui/panels/a_panel.h\"", true);
        row("ui/panels/a_panel.cpp", "#include \"ui/panels/b_panel.h\"", false);
        row("app/main.cpp", "#include \"ui/window/main_window.h\"", true);
        row("lost/a.cpp", "#include <cmath>", false);
    }
    void theCheckerCanFail() {
        QFETCH(QString, path);
        QFETCH(QString, line);
        QFETCH(bool, allowed);
        const QStringList found = violations(path, "#pragma once\n\n" + line + "\n");
        QCOMPARE(int(found.size()), allowed ? 0 : 1);
        if (!allowed && !path.startsWith("lost"))
            QVERIFY2(found[0].startsWith(path + ":3: "), qPrintable(found[0]));
    }

    // A warning, not a failure: long files are read less.
    void sizes() {
        for (const QString& path : sourceFiles()) {
            const int lines = int(textOf(path).count('\n'));
            const int limit = path.endsWith(".h") ? 120 : 350;
            if (lines > limit)
                qWarning("%s has %d lines; %d read well", qPrintable(path), lines, limit);
        }
    }
};

QTEST_GUILESS_MAIN(TestArchitecture)
#include "test_architecture.moc"

// The worksheet as a file: pages, and the text that other programs find in it.
#include "core/engine/engine.h"
#include "core/scene/builtin.h"
#include "panel_bench.h"
#include "ui/tables/tables_panel.h"
#include "ui/words/number_text.h"
#include "ui/worksheet/worksheet.h"

#include <QFile>
#include <QFileDialog>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace thetalane;

namespace {

Run runOf(const char* name) {
    EngineSettings settings;
    settings.maxCollisions = 60;
    return std::get<Run>(simulate(*builtinScene(name), settings));
}

qsizetype pagesOf(const QByteArray& pdf) {
    static const QRegularExpression page("/Type\\s*/Page\\b(?!s)");
    qsizetype count = 0;
    for (auto it = page.globalMatch(QString::fromLatin1(pdf)); it.hasNext(); it.next())
        ++count;
    return count;
}

// As a reader would copy it out of a page; nothing where there is no pdftotext.
QString textOf(const QString& path, int page) {
    const QString program = QStandardPaths::findExecutable("pdftotext");
    if (program.isEmpty())
        return {};
    QProcess process;
    process.start(program, {"-layout", "-enc", "UTF-8", "-f", QString::number(page), "-l",
                            QString::number(page), path, "-"});
    process.waitForFinished();
    return QString::fromUtf8(process.readAllStandardOutput());
}

} // namespace

class TestWorksheet : public QObject {
    Q_OBJECT

private:
    Language m_language;

private slots:
    void cleanup() { useLanguage(m_language, false); }

    void everySceneHasTwoPages_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<bool>("korean");
        for (const char* scene : {"two-balls", "head-on", "right-angle", "heavy-light", "glancing",
                                  "inelastic", "cradle", "rack"})
            for (const bool korean : {false, true})
                QTest::addRow("%s %s", scene, korean ? "ko" : "en") << scene << korean;
    }
    void everySceneHasTwoPages() {
        QFETCH(QString, scene);
        QFETCH(bool, korean);
        useLanguage(m_language, korean);
        const Run run = runOf(qPrintable(scene));
        const auto all = run.timeline.collisions();
        QVERIFY(!all.empty());
        for (const std::size_t index : {std::size_t(0), all.size() - 1}) {
            const QByteArray pdf =
                worksheetPdf({run.scene, all, index, std::int64_t(index) + 1, m_language.code()});
            QVERIFY(pdf.startsWith("%PDF-"));
            QCOMPARE(pagesOf(pdf), 2);
            QVERIFY(pdf.size() > 15'000 && pdf.size() < 400'000);
        }
    }

    void asksOnOnePageAndAnswersOnTheOther_data() { addLanguages(); }
    void asksOnOnePageAndAnswersOnTheOther() {
        QFETCH(bool, korean);
        useLanguage(m_language, korean);
        const Run run = runOf("glancing");
        QTemporaryDir dir;
        const QString path = dir.filePath("sheet.pdf");
        QCOMPARE(writeWorksheet(path, {run.scene, run.timeline.collisions(), 0, 1, m_language.code()}),
                 QString());
        if (QStandardPaths::findExecutable("pdftotext").isEmpty())
            return; // its size and pages are looked at above
        const QString asked = textOf(path, 1), answered = textOf(path, 2);
        // What comes of it, by the test's own arithmetic from the states just before.
        const double t = run.timeline.collisions()[0].time;
        const BodyState a = run.timeline.bodyAt(0, std::nextafter(t, 0.0)),
                        b = run.timeline.bodyAt(1, std::nextafter(t, 0.0));
        const double ma = run.scene.bodies[0].mass, mb = run.scene.bodies[1].mass, e = run.scene.restitution;
        const Vec2d apart = a.position - b.position, n = apart * (1 / norm(apart));
        const double impulse = (1 + e) * ma * mb / (ma + mb) * dot(b.velocity - a.velocity, n);
        const Vec2d after = a.velocity + n * (impulse / ma);
        const double degrees = std::atan2(n.y, n.x) * 180 / 3.14159265358979324;
        for (const double answer : {after.x, after.y, degrees}) {
            QVERIFY2(answered.contains(numberText(answer)), qPrintable(answered));
            QVERIFY2(!asked.contains(numberText(answer)), qPrintable(asked));
        }
        for (const double given : {ma, mb, e, a.velocity.x})
            QVERIFY(asked.contains(numberText(given)));
        const QStringList words =
            korean ? QStringList{"활동지",  "이름",      "빈칸",   "충돌 전",
                                 "충돌 후", "반발 계수", "운동량", "비스듬히 스치는 충돌"}
                   : QStringList{"Worksheet",   "Name",     "blanks",  "Before the collision",
                                 "restitution", "momentum", "Glancing"};
        for (const QString& word : words)
            QVERIFY2(asked.contains(word), qPrintable(word + "\n" + asked));
        QVERIFY(answered.contains(korean ? "정답" : "Answers"));
        static const QRegularExpression english("\\b[A-Za-z]{4,}\\b");
        if (korean)
            QVERIFY2(!asked.contains(english), qPrintable(asked));
    }

    void saysWhyItCannotBeWritten() {
        const Run run = runOf("head-on");
        QTemporaryDir dir;
        QVERIFY(!writeWorksheet(dir.path(), {run.scene, run.timeline.collisions(), 0, 1}).isEmpty());
        QVERIFY(!QFile::exists(dir.filePath("no/sheet.pdf")));
        QVERIFY(!writeWorksheet(dir.filePath("no/sheet.pdf"), {run.scene, run.timeline.collisions(), 0, 1})
                     .isEmpty());
    }

    void thePanelWritesOne() {
        PanelBench bench;
        TablesPanel panel(bench.context);
        showPanel(panel, {480, 600});
        QTemporaryDir dir;
        click(panel, "saveWorksheet");
        auto* dialog = panel.findChild<QFileDialog*>("worksheetDialog");
        QVERIFY(dialog); // and this goes on: it does not wait
        dialog->setDirectory(dir.path());
        dialog->close();
        QVERIFY(panel.saveWorksheet(dir.filePath("sheet.pdf")));
        QFile file(dir.filePath("sheet.pdf"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(pagesOf(file.readAll()), 2);
        QVERIFY(message(panel, "tablesMessage").contains("sheet.pdf"));
    }
};

QTEST_MAIN(TestWorksheet)
#include "test_worksheet.moc"

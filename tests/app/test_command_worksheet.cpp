// thetalane worksheet: the file it writes, and what it says of a call that will not do.
#include "tests/app/program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

class TestCommandWorksheet : public QObject {
    Q_OBJECT

private slots:
    void writesAPdf_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("ko") << "ko";
        QTest::newRow("en") << "en";
    }
    void writesAPdf() {
        QFETCH(QString, language);
        QTemporaryDir dir;
        const QString path = dir.filePath("sheet.pdf");
        const Outcome o =
            call({"worksheet", "rack", "--collision", "2", "--output", path, "--language", language});
        QCOMPARE(o.error, QString());
        QCOMPARE(o.status, 0);
        QCOMPARE(QDir(dir.path()).entryList(QDir::Files), QStringList("sheet.pdf"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray pdf = file.readAll();
        QVERIFY(pdf.startsWith("%PDF-"));
        QVERIFY(pdf.size() > 15'000);
        const QString program = QStandardPaths::findExecutable("pdftotext");
        if (program.isEmpty())
            return;
        QProcess process;
        process.start(program, {"-enc", "UTF-8", path, "-"});
        QVERIFY(process.waitForFinished());
        const QString text = QString::fromUtf8(process.readAllStandardOutput());
        QVERIFY(text.contains(language == "ko" ? QString("충돌 전") : QString("Before the collision")));
        QVERIFY(text.contains(language == "ko" ? QString("정답") : QString("Answers")));
    }

    void saysWhatIsWrong_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("told");
        const auto row = [](const char* arguments, const char* told) {
            QTest::newRow(arguments) << QString(arguments) << QString(told);
        };
        row("worksheet two-balls", "--output: is missing; say where the worksheet goes, FILE.pdf");
        row("worksheet two-balls --output x.png", "--output: must end in .pdf, is \"x.png\"");
        row("worksheet head-on --output x.pdf --collision 2",
            "--collision: must be from 1 to 1, the number of collisions, is 2");
        row("worksheet head-on --output x.pdf --until 0.1",
            "head-on: nothing collides in this scene in the time asked for");
        row("worksheet head-on --output no/such/x.pdf", "no/such/x.pdf: cannot be written: ");
    }
    void saysWhatIsWrong() {
        QFETCH(QString, arguments);
        QFETCH(QString, told);
        const Outcome o = call(arguments.split(' ') << "--language"
                                                    << "en");
        QVERIFY(o.status == 1 || o.status == 2);
        QVERIFY2(o.error.contains(told), qPrintable(o.error));
        QVERIFY(!QFile::exists("x.pdf"));
    }
};

QTEST_GUILESS_MAIN(TestCommandWorksheet)
#include "test_command_worksheet.moc"

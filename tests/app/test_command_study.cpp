// thetalane study throws and SCENE, and the choice by measurement: what they print and write.
#include "tests/app/program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <cmath>
#include <csignal>

namespace {

struct Table {
    QStringList names;
    QList<QStringList> rows;

    double at(const QStringList& row, const QString& name) const {
        return row.value(names.indexOf(name)).toDouble();
    }
    QString text(const QStringList& row, const QString& name) const { return row.value(names.indexOf(name)); }
    QStringList find(const QString& engine, const QString& precision, const QString& variant,
                     double step = 0) const {
        for (const QStringList& row : rows)
            if (text(row, "engine") == engine && text(row, "precision") == precision &&
                text(row, "variant") == variant && std::abs(at(row, "step_s") - step) < 1e-12)
                return row;
        return {};
    }
};

Table tableOf(const QString& path) {
    QFile file(path);
    Table table;
    if (!file.open(QIODevice::ReadOnly))
        return table;
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
    for (const QString& line : lines)
        (table.names.isEmpty() ? table.names : table.rows.emplaceBack()) = line.split(',');
    return table;
}

} // namespace

class TestCommandStudy : public QObject {
    Q_OBJECT

private slots:
    void throwsAreATableAndAFile() {
        const QTemporaryDir folder;
        const QString csv = folder.filePath("t.csv");
        const Outcome o = call(
            {"study", "throws", "--throws", "60", "--methods", "quick", "--csv", csv, "--language", "ko"});
        QCOMPARE(o.status, 0);
        const QString out = QString::fromUtf8(o.out);
        QVERIFY2(out.contains("씨앗값 2026") && out.contains("논문의 반복 계산, 1/60 s"), o.out.constData());
        QVERIFY2(o.error.contains("60"), qPrintable(o.error));

        const Table t = tableOf(csv);
        QVERIFY(t.names.join(',').startsWith(
            "engine,precision,step_s,cost_us,error_m,same_pins_percent,collisions,"));
        for (const QStringList& row : t.rows) {
            QCOMPARE(row.size(), t.names.size());
            QCOMPARE(t.at(row, "cases"), 60.0);
            QVERIFY(t.at(row, "cost_us") > 0);
            QCOMPARE(t.text(row, "call"), QString("thetalane study throws --throws 60 --methods quick"));
        }
        const QStringList exact = t.find("event", "double", "");
        QCOMPARE(t.at(exact, "same_pins_percent"), 100.0);
        QVERIFY(t.at(exact, "error_m") < 1e-12 && t.at(exact, "error_m") > 0);
        QCOMPARE(t.at(t.find("event", "quad", ""), "error_m"), 0.0);
        QVERIFY(t.at(t.find("stepped", "double", "", 1.0 / 60), "same_pins_percent") < 20);
        QVERIFY(!t.find("swept", "double", "passes=4", 1.0 / 60).isEmpty());
    }

    // A build without the window says so.
    void throwsAreAPicture() {
        const QTemporaryDir folder;
        const QString png = folder.filePath("t.png");
        const Outcome o = call({"study", "throws", "--throws", "60", "--methods", "quick", "--picture", png,
                                "--language", "en"});
        if (o.error.contains("without the window")) {
            QCOMPARE(o.status, 1);
            return;
        }
        QCOMPARE(o.status, 0);
        QFile picture(png);
        QVERIFY(picture.open(QIODevice::ReadOnly));
        const QByteArray bytes = picture.readAll();
        QVERIFY(bytes.startsWith("\x89PNG\r\n") && bytes.size() > 20'000);
        QVERIFY(qFromBigEndian<quint32>(bytes.constData() + 16) >= 800); // the width, in IHDR
    }

    void theSameSeedFindsTheSame() {
        const QTemporaryDir folder;
        QStringList texts[2];
        for (int k = 0; k < 2; ++k) {
            const QString csv = folder.filePath("a.csv");
            const QStringList threads{"--threads", k == 0 ? "1" : "3"};
            QCOMPARE(call(QStringList{"study", "throws", "--throws", "20", "--seed", "9", "--methods",
                                      "quick", "--csv", csv} +
                          threads)
                         .status,
                     0);
            const Table t = tableOf(csv);
            for (const QStringList& row : t.rows)
                for (const char* name : {"engine", "step_s", "variant", "error_m", "error_rms_m",
                                         "same_pins_percent", "collisions", "missed", "repeated"})
                    texts[k] << t.text(row, name);
        }
        QVERIFY(!texts[0].isEmpty());
        QCOMPARE(texts[0], texts[1]);
    }

    void theWholeLaneSaysWhatItsModelsCost() {
        const QTemporaryDir folder;
        const QString csv = folder.filePath("lane.csv");
        const Outcome o = call({"study", "throws", "--scene", "bowling", "--throws", "30", "--methods",
                                "quick", "--csv", csv, "--language", "en"});
        QCOMPARE(o.status, 0);
        QVERIFY(o.out.contains("its share of the cost"));
        const Table t = tableOf(csv);
        for (const char* model : {"friction", "spin", "oil", "restitution", "wall-restitution", "ties"}) {
            const QStringList row = t.find("event", "double", QString("without-") + model);
            QVERIFY2(!row.isEmpty(), model);
            QVERIFY(t.at(row, "cost_ratio") > 0);
        }
        QVERIFY(t.at(t.find("event", "double", "without-friction"), "same_down_percent") < 50);
        QCOMPARE(t.at(t.find("event", "double", ""), "same_pins_percent"), 100.0);
    }

    void oneSceneIsAStudyToo() {
        const Outcome o =
            call({"study", "two-balls", "--until", "3", "--methods", "quick", "--language", "en"});
        QCOMPARE(o.status, 0);
        QVERIFY2(o.out.startsWith("Two balls in a frame\n"), o.out.constData());
        QVERIFY(o.out.contains("paper's loop, approaching only, 1/240 s"));
    }

    void theMarkdownTableComesFromTheFile() {
        const QTemporaryDir folder;
        const QString csv = folder.filePath("t.csv");
        QFile file(csv);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("engine,precision,step_s,cost_us,error_m,same_pins_percent,collisions,variant,machine\n"
                   "event,double,,4.5,1.25e-14,100,10,,\"one, two\"\n"
                   "stepped,double,0.016666666666666666,16,5.5,4.025,70,approaching-only,x\n");
        file.close();
        const Outcome o = call({"study", "--table", csv, "--language", "ko"});
        QCOMPARE(o.status, 0);
        const QString out = QString::fromUtf8(o.out);
        QVERIFY2(out.contains("| `event`, double | 4.5 |"), o.out.constData());
        QVERIFY2(out.contains("| `stepped`, approaching only, 1/60 s | 16 |"), o.out.constData());
        QVERIFY(out.contains("100.00 %") && out.contains("1.25·10⁻¹⁴ m"));
    }

    // Ctrl+C: the table of what there is, the file whole, and a status that says so.
    void anInterruptedStudyKeepsWhatItHas() {
        const QTemporaryDir folder;
        const QString csv = folder.filePath("t.csv");
        QProcess process;
        process.setEnvironment({"PATH=/usr/bin:/bin"});
        process.start(THETALANE_PROGRAM, {"study", "throws", "--throws", "100000", "--methods", "quick",
                                          "--csv", csv, "--language", "en"});
        QVERIFY(process.waitForStarted());
        process.setReadChannel(QProcess::StandardError);
        QByteArray said;
        while (!said.contains("costs: round 2")) {
            QVERIFY2(process.waitForReadyRead(60'000), said.constData());
            said += process.readAllStandardError();
        }
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardOutput().contains("Cancelled: "));
        const Table t = tableOf(csv);
        QVERIFY(t.rows.size() > 10);
        const double cases = t.at(t.rows.first(), "cases");
        QVERIFY(cases > 0 && cases < 100'000);
    }

    void noFileIsLeftHalfWritten() {
        QCOMPARE(call({"study", "throws", "--throws", "2", "--csv", "/nowhere/at/all.csv"}).status, 1);
        const QTemporaryDir folder;
        const Outcome o = call({"study", "rack", "--picture", folder.filePath("no/such/folder.png")});
        QCOMPARE(o.status, 1);
        QVERIFY(o.out.isEmpty());
    }

    void autoChoosesTheCheapestAndSaysWhy() {
        const Outcome strict = call({"run", "rack", "--until", "2", "--engine", "auto", "--tolerance", "1e-9",
                                     "--summary", "--language", "en"});
        QCOMPARE(strict.status, 0);
        QVERIFY2(strict.error.startsWith("auto: next event, double (53 bits) is the cheapest"),
                 qPrintable(strict.error));
        QVERIFY(strict.error.contains("paper's loop"));
        // Nothing is as good as that, and it says so.
        const Outcome hopeless =
            call({"run", "break", "--engine", "auto", "--tolerance", "1e-30", "--summary"});
        QCOMPARE(hopeless.status, 0);
        QVERIFY2(hopeless.error.startsWith("auto: nothing stays within"), qPrintable(hopeless.error));
        const Outcome plain = call({"run", "rack", "--engine", "auto", "--json"});
        QCOMPARE(plain.error, QString());
        QCOMPARE(plain.out, call({"run", "rack", "--json"}).out);
    }
};

QTEST_GUILESS_MAIN(TestCommandStudy)
#include "test_command_study.moc"

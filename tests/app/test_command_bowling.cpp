// score and map, as they are called: what they print, write and refuse.
#include "tests/app/program.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

namespace {

QJsonObject jsonOf(const Outcome& o) {
    return QJsonDocument::fromJson(o.out).object();
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool isOneLine(const QString& text) {
    return text.endsWith('\n') && text.count('\n') == 1 && text.size() > 1;
}

} // namespace

class TestCommandBowling : public QObject {
    Q_OBJECT

private slots:
    void scores_data() {
        QTest::addColumn<QString>("rolls");
        QTest::addColumn<QString>("rules");
        QTest::addColumn<QString>("totals");
        const auto row = [](const QString& rolls, const char* rules, const char* totals) {
            QTest::newRow(qPrintable(rolls + ' ' + rules)) << rolls << rules << totals;
        };
        row("X X X 72 8/ F9 X 7/ 9- XX8", "traditional", "30 57 76 85 95 104 124 143 152 180");
        row("XXX 72 8/ F9 X 7/ 9- XX8", "traditional", "30 57 76 85 95 104 124 143 152 180");
        row("X X X X X X X X X XXX", "traditional", "30 60 90 120 150 180 210 240 270 300");
        row("-- -- -- -- -- -- -- -- -- --", "traditional", "0 0 0 0 0 0 0 0 0 0");
        row("--", "traditional", "0");
        row("-/ -/", "current-frame", "10 20");
        row("X 9/ 72", "traditional", "20 37 46");
        row("X 9/", "traditional", "20 null");
        row("X X X X X X X X X X", "current-frame", "30 60 90 120 150 180 210 240 270 300");
        row("", "traditional", "");
    }
    void scores() {
        QFETCH(QString, rolls);
        QFETCH(QString, rules);
        QFETCH(QString, totals);
        for (const QStringList& arguments : {QStringList{"score", rolls, "--rules", rules, "--json"},
                                             {"score", "--json", "--rules=" + rules, rolls}}) {
            const Outcome o = call(arguments);
            QCOMPARE(o.error, QString());
            QCOMPARE(o.status, 0);
            const QJsonObject json = jsonOf(o);
            QCOMPARE(json["rules"].toString(), rules);
            QStringList got;
            for (const QJsonValue& frame : json["frames"].toArray())
                got << (frame["total"].isNull() ? "null" : QString::number(frame["total"].toInt()));
            QCOMPARE(got.join(' '), totals);
            const bool whole = got.size() == 10;
            QCOMPARE(json["complete"].toBool(), whole);
            QCOMPARE(json["total"].isNull(), !whole);
            if (whole)
                QCOMPARE(QString::number(json["total"].toInt()), got.last());
        }
    }

    void scoresForPeople() {
        const Outcome english = call({"score", "X 9/ 72"}),
                      korean = call({"score", "X 9/ 72", "--language", "ko"});
        QVERIFY(english.out.contains("The game goes on: frame 4, ball 1, 10 pins stand."));
        QVERIFY(QString::fromUtf8(korean.out).contains("스트라이크 1, 스페어 1, 오픈 프레임 1"));
        QVERIFY(call({"score", "XXXXXXXXXXXX"}).out.contains("a perfect game"));
    }

    void wrongScores_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        const auto row = [](const QStringList& arguments, const char* says) {
            QTest::newRow(qPrintable(arguments.join(' '))) << arguments << says;
        };
        row({"X 8A"}, "frame 2: \"A\" is no roll; rolls are X, /, -, F and the digits 1 to 9");
        row({"72 10"}, "frame 2: 0 is no roll");
        row({"X X 56"}, "frame 3: 6 is more than the pins that stand, 5; here it must be a digit up to 4");
        row({"55"}, "frame 1: 5 takes all pins that stand; a spare is written /");
        row({"7X"}, "frame 1: X stands for all ten at the first ball");
        row({"/7"}, "frame 1: / needs a ball before it");
        row({"7 8/"}, "frame 1: the second ball is missing; after 7 there must be a digit up to 2");
        row({"729/"}, "frame 1: the frame is over before \"729/\" ends");
        row({"XXXXXXXXXXXXX"}, "frame 10: X is one roll too many");
        row({"-- -- -- -- -- -- -- -- -- X56"}, "frame 10: 6 is more than the pins that stand, 5");
        row({"X X X X X X X X X XXX", "--rules", "current-frame"}, "frame 10: X is one roll too many");
        row({"-a"}, "-a: there is no such option");
        row({}, "ROLLS is missing");
        row({"X", "9/"}, "9/: one argument too many");
        row({"X", "--rules", "old"}, "--rules: must be one of traditional, current-frame");
    }
    void wrongScores() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        const Outcome o = call(QStringList{"score"} + arguments);
        QCOMPARE(o.status, 2);
        QVERIFY2(isOneLine(o.error) && o.error.startsWith(says), qPrintable(o.error));
        QCOMPARE(o.out, QByteArray());
        const Outcome korean = call(QStringList{"score", "--language", "ko"} + arguments);
        QCOMPARE(korean.status, 2);
        QVERIFY(isOneLine(korean.error));
    }

    void maps() {
        QTemporaryDir dir;
        const QString csv = dir.filePath("map.csv"), png = dir.filePath("map.png");
        const Outcome o = call({"map", "--offsets", "9", "--angles", "5", "--csv", csv});
        QCOMPARE(o.error, QString());
        QCOMPARE(o.status, 0);
        const QList<QByteArray> lines = contents(csv).trimmed().split('\n');
        QCOMPARE(lines.size(), 46);
        QVERIFY(lines[0].startsWith("offset_m,angle_deg,pins_down,strike,"));
        QVERIFY(lines[1].startsWith("-0.16,0,"));
        QVERIFY(lines[45].startsWith("0.16,8,"));
        QVERIFY(o.out.contains("Throws: 45, strikes: "));
        const Outcome korean = call({"map", "--offsets", "4", "--angles", "4", "--language", "ko"});
        QVERIFY(QString::fromUtf8(korean.out).contains("실제 핀은 넘어지면서"));
        QCOMPARE(QDir(dir.path()).entryList(QDir::Files),
                 QStringList("map.csv")); // nothing half-written beside
        const Outcome drawn = call({"map", "--offsets", "9", "--angles", "5", "--picture", png});
        if (drawn.error.contains("without the window"))
            return; // nothing can draw
        QCOMPARE(drawn.error, QString());
        QCOMPARE(drawn.status, 0);
        const QByteArray picture = contents(png);
        QVERIFY(picture.startsWith("\x89PNG"));
        QCOMPARE(qFromBigEndian<quint32>(picture.constData() + 16), quint32(1380)); // of the header: width
    }

    void mapsInParts_data() {
        QTest::addColumn<QString>("scene");
        QTest::newRow("rack") << "rack";
        QTest::newRow("bowling") << "bowling";
    }
    void mapsInParts() {
        QFETCH(QString, scene);
        QTemporaryDir dir;
        const auto file = [&](const char* name) { return dir.filePath(name); };
        const QStringList base{"map", "--scene", scene, "--offsets", "12", "--angles", "9"};
        QCOMPARE(call(base + QStringList{"--csv", file("whole.csv"), "--threads", "1"}).status, 0);
        QCOMPARE(call(base + QStringList{"--rows", "1-4", "--csv", file("a.csv"), "--threads", "2"}).status,
                 0);
        QCOMPARE(call(base + QStringList{"--rows", "5-9", "--csv", file("b.csv"), "--threads", "5"}).status,
                 0);
        const Outcome o = call({"map", "--merge", file("b.csv"), file("a.csv"), "--csv", file("all.csv")});
        QCOMPARE(o.error, QString());
        QCOMPARE(o.status, 0);
        QCOMPARE(contents(file("all.csv")), contents(file("whole.csv")));

        const auto refused = [&](const QStringList& files, const char* says) {
            const Outcome r =
                call(QStringList{"map", "--merge"} + files + QStringList{"--csv", file("none.csv")});
            QCOMPARE(r.status, 2);
            QVERIFY2(isOneLine(r.error) && r.error.contains(says), qPrintable(r.error));
            QVERIFY(!QFile::exists(file("none.csv")));
        };
        refused({file("a.csv")}, "--merge: rows 5 to 9 are in none of the files; make them with --rows 5-9");
        refused({file("a.csv"), file("b.csv"), file("a.csv")}, "row 1 is in");
        QCOMPARE(call(base + QStringList{"--rows", "5-9", "--mass", "5", "--csv", file("c.csv")}).status, 0);
        refused({file("a.csv"), file("c.csv")}, "mass_kg: is 5, but 6.8 in");
        refused({file("a.csv"), file("gone.csv")}, "gone.csv: cannot be read");
        refused({file("a.csv"), QString(THETALANE_PROGRAM)}, "is no part of a strike map");
    }

    void wrongMaps_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* arguments, const char* says) {
            QTest::newRow(arguments) << QString(arguments) << QString(says);
        };
        row("--scene alley", "--scene: must be one of rack, bowling, is \"alley\"");
        row("--offsets 0", "--offsets: must be a whole number greater than 0");
        row("--angles many", "--angles: must be a whole number greater than 0, is \"many\"");
        row("--offsets 99999999999", "--offsets: must be at most 16777216");
        row("--offsets 16777216 --angles 16777216",
            "--offsets, --angles: 281474976710656 cells are too many");
        row("--angles 8 --rows 0-3", "--rows: must be A-B with 1 <= A <= B <= 8, is \"0-3\"");
        row("--angles 8 --rows 5-9", "--rows: must be A-B with 1 <= A <= B <= 8, is \"5-9\"");
        row("--angles 8 --rows 5", "--rows: must be A-B");
        row("--angles 8 --rows 6-5", "--rows: must be A-B");
        row("--threads 0", "--threads: must be a whole number greater than 0");
        row("--threads 100000", "--threads: must be at most 1024");
        row("--spin 300", "--spin: has no meaning on the rack; add --scene bowling");
        row("--mass 9", "--mass: must be from 0.1 to 7.26, is 9");
        row("--angle-to 60", "--angle-from, --angle-to: must be from −30 to 30, is 60");
        row("--angle-from 5 --angle-to 4", "--angle-to: must not be less than --angle-from");
        row("--picture map.jpg", "--picture: must end in .png, is \"map.jpg\"");
        row("--csv /nowhere/at/all/map.csv", "/nowhere/at/all/map.csv: cannot be written");
        row("--merge", "--merge: needs a value");
        row("--merge a.csv --offsets 3", "--offsets: has no meaning with --merge");
        row("rack", "rack: one argument too many");
    }
    void wrongMaps() {
        QFETCH(QString, arguments);
        QFETCH(QString, says);
        const Outcome o = call(QStringList{"map"} + arguments.split(' '));
        QVERIFY(o.status == 2 || (says.contains("cannot be written") && o.status == 1));
        QVERIFY2(isOneLine(o.error) && o.error.startsWith(says), qPrintable(o.error));
        QCOMPARE(o.out, QByteArray());
    }
};

QTEST_GUILESS_MAIN(TestCommandBowling)
#include "test_command_bowling.moc"

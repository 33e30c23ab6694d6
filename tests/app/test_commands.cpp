// The program as it is called: exit statuses, and one line for every fault.
#include "core/format/scene_file.h"
#include "core/scene/builtin.h"
#include "tests/app/program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

using namespace thetalane;

namespace {

bool isOneLine(const QString& text) {
    return text.endsWith('\n') && text.count('\n') == 1 && text.size() > 1;
}

bool hasHangul(const QString& text) {
    return std::any_of(text.begin(), text.end(),
                       [](QChar c) { return c.unicode() >= 0xAC00 && c.unicode() <= 0xD7A3; });
}

} // namespace

class TestCommands : public QObject {
    Q_OBJECT

private slots:
    void goodCalls_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("contains");
        const auto row = [](const QString& line, const char* contains) {
            QTest::newRow(qPrintable(line)) << line.split(' ') << contains;
        };
        row("--help", "thetalane explain");
        row("-h", "thetalane explain");
        row("--version", "ThetaLane ");
        for (const char* command : {"run", "explain", "throw", "scenes", "scene", "study"}) {
            row(QString(command) + " --help", "Usage: thetalane ");
            row(QString(command) + " --help --language ko", "사용법: thetalane ");
        }
        row("scenes", "right-angle  Equal masses part at 90°");
        row("scenes --language ko", "right-angle  질량이 같으면 90°로 갈라진다");
        row("scene bowling", "\"foul_line\": -18.288");
        row("run two-balls", "Energy loss [J]");
        row("run two-balls --language ko", "에너지 손실 [J]");
        row("--language ko scenes", "");
        row("run two-balls --until=2", "Collisions: 5");
        row("run two-balls --summary", "Collisions: 17");
        row("run two-balls --summary --json", "\"collision_count\": 17");
        row("run two-balls --max-collisions 3", "Collisions: 3");
        row("run two-balls --csv", "contact.cos");
        row("run two-balls --engine auto --json", "\"engine\": \"event\"");
        row("run two-balls --engine stepped --step 0.01 --approaching-only --json",
            "\"approaching_only\": true");
        row("run two-balls --engine swept --step 0.01 --passes 3 --json",
            "\"engine\": \"swept\", \"precision\": \"double\", \"step\": 0.01, \"passes\": 3,");
        row("run bowling --engine swept --json", "\"phase\": \"rest\"");
        row("run two-balls --engine swept", "swept engine, step 0.01667 s, passes: 1, double");
        row("run break --one-at-a-time --max-collisions 5 --json", "\"one_at_a_time\": true");
        row("run break --one-at-a-time --max-collisions 5 --language ko", "접촉을 하나씩 계산");
        row("throw --engine swept --step 1e-3 --passes 8 --language ko", "쓰러진 핀:");
        row("run two-balls --precision quad --json", "\"precision\": \"quad\"");
        row("run two-balls --precision float --json", "\"precision\": \"float\"");
        row("run head-on --until +2e0", "Ended at 2 s");
        row("explain right-angle", "Collision 1: A – B, at 0.6267");
        row("explain right-angle --language ko", "충돌 1: A – B");
        row("explain two-balls --collision 4", "Collision 4: B – ");
        row("explain two-balls --engine stepped --step 0.001", "Collision 1: A – B");
        row("throw", "Pins down:");
        row("throw --language ko", "쓰러진 핀:");
        row("throw --direction -0.5 --position 0.1 --mass 7.26", "Pins down:");
        row("throw", "At its first pin: x = 0.");
        row("throw --spin 300 --no-friction", "Without friction the spin has no effect.");
        row("throw --spin 300 --no-friction --language ko", "마찰이 없으면");
        row("throw --no-friction", "heading 1.5°");
        row("throw", "Energy of rotation [J]");
        row("throw --language ko", "회전 운동 에너지 [J]");
        row("throw --friction 0.3 --oil 0.05 --oil-length 10 --restitution 0.6 --json",
            "\"restitution\": 0.6");
        row("throw --oil-length 0 --contact-time 1e-5 --json", "\"contact_time\": 1e-05");
        row("scene bowling", "\"kickbacks\": {\"from\": -0.1, \"restitution\": 0.5}");
        row("scene bowling", "\"friction\": {\"ball\": 0.2, ");
        row("throw --help", "positive hooks to the left");
        row("throw --position 0.527", "Pins down: ");
    }

    void goodCalls() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, contains);
        if (arguments.first() == "--language")
            return; // told among the wrong calls
        const Outcome o = call(arguments);
        QCOMPARE(o.error, QString());
        QCOMPARE(o.status, 0);
        QVERIFY2(QString::fromUtf8(o.out).contains(contains), o.out.constData());
    }

    void wrongCalls_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("contains");
        const auto row = [](const QString& line, const char* contains) {
            QStringList arguments = line.split(' ');
            arguments.replaceInStrings("EMPTY", "");
            QTest::newRow(qPrintable(line)) << arguments << contains;
        };
        row("rnu", "did you mean \"run\"?");
        row("fly", "there is no such command; thetalane --help");
        row("--langauge ko", "did you mean --language?");
        row("--language fr", "--language: must be ko or en, is \"fr\"");
        row("--language ko scenes", "scenes");
        row("--scene nowhere", "--scene: nowhere: there is no such scene or file");
        row("scenes extra", "extra: one argument too many");
        row("scenes --language", "--language: needs a value");
        row("scenes --language fr", "must be ko or en");
        row("scene", "NAME is missing");
        row("scene two-bals", "did you mean \"two-balls\"? thetalane scenes lists");
        row("scene /dev/null", "there is no such built-in scene");
        row("study", "STUDY is missing");
        row("study strikes", "strikes: there is no such scene or file");
        row("study throws --throws 0", "--throws: must be a whole number greater than 0, is \"0\"");
        row("study throws --throws 9999999", "--throws: must be at most 1000000, is 9999999");
        row("study throws --seed -1", "--seed: must be a whole number, is \"-1\"");
        row("study throws --threads 0", "--threads: must be a whole number greater than 0");
        row("study throws --methods some", "--methods: must be one of quick, standard, all, is \"some\"");
        row("study throws --scene alley", "--scene: must be one of rack, bowling, is \"alley\"");
        row("study throws --until 3", "--until: study throws does not take this");
        row("study throws --quick", "--quick: study throws does not take this");
        row("study rack --throws 3", "--throws: study rack does not take this");
        row("study rack --until 0", "--until: must be greater than 0, is 0");
        row("study extremes --picture x.png", "--picture: study extremes does not take this");
        row("study rack --picture x.jpg", "--picture: must end in .png, is \"x.jpg\"");
        row("study --table", "--table: needs a value");
        row("study rack --table x.csv", "rack: one argument too many");
        row("study --table /nowhere/at/all.csv", "/nowhere/at/all.csv: cannot be read: ");
        row("study --table /dev/null", "/dev/null: is not a table that thetalane study --csv wrote");
        for (const char* bad : {"0", "-1", "nan", "1e999"})
            row(QString("run rack --engine auto --tolerance ") + bad, "--tolerance: must be ");
        row("run rack --tolerance 0.001", "--tolerance: only with --engine auto");
        row("run rack --engine auto --tolerance 1 --precision float",
            "--precision: is chosen by --tolerance");
        row("study extremes --csv EMPTY", "--csv: needs");
        row("run", "SCENE is missing; the call is: thetalane run SCENE");
        row("run two-balls head-on", "head-on: one argument too many");
        row("run rihgt-angle", "did you mean \"right-angle\"?");
        row("run /nowhere/at/all.json", "/nowhere/at/all.json: there is no such scene or file");
        row("run EMPTY", "there is no such scene or file");
        row("run /", "/: cannot be read: ");
        row("run /dev/zero", "/dev/zero: cannot be read: it is larger than 64 MiB");
        row("run /dev/null", "/dev/null: line 1, column 1: not valid JSON: the file is empty");
        row("run -", "standard input: line 1, column 1: not valid JSON");
        row("run two-balls --bogus", "--bogus: there is no such option; thetalane run --help");
        row("run two-balls --unti 3", "--unti: there is no such option; did you mean --until?");
        row("run two-balls --json=3", "--json: takes no value");
        for (const char* bad : {"1x", "nan", "inf", "EMPTY", "1e400", "0x10", "1,5", "--json"})
            row(QString("run two-balls --until ") + bad, "--until: must be a number, is ");
        row("run two-balls --until 0", "--until: must be greater than 0, is 0");
        row("run two-balls --until -3", "--until: must be greater than 0, is -3");
        row("run two-balls --until", "--until: needs a value");
        for (const char* bad : {"0", "-1", "2.5", "many", "99999999999999999999"})
            row(QString("run two-balls --max-collisions ") + bad,
                "--max-collisions: must be a whole number greater than 0, is ");
        row("run two-balls --engine sweep",
            "--engine: must be one of event, swept, stepped, auto, is \"sweep\"");
        for (const char* bad : {"0", "-1", "2.5", "many", ""})
            row(QString("run two-balls --engine swept --passes=") + bad,
                "--passes: must be a whole number greater than 0, is ");
        row("run two-balls --engine swept --passes 1000001", "--passes: must be at most 1000000, is 1000001");
        row("run two-balls --passes 2", "--passes: only with --engine swept");
        row("run two-balls --engine stepped --passes 2", "--passes: only with --engine swept");
        row("run two-balls --engine swept --approaching-only",
            "--approaching-only: only with --engine stepped");
        row("run two-balls --engine swept --one-at-a-time", "--one-at-a-time: only with --engine event");
        row("run two-balls --engine swept --contact-time 1e-4", "--contact-time: only with --engine event");
        row("run two-balls --engine swept --step 1e-9", "--step: takes 1e+10 steps, more than the 100000000");
        row("run two-balls --precision half", "--precision: must be one of float, double, quad");
        row("run two-balls --step 0.01",
            "--step: only with --engine stepped|swept; choose it, or leave this out");
        row("run two-balls --engine auto --approaching-only",
            "--approaching-only: only with --engine stepped");
        row("run two-balls --engine stepped --step 0", "--step: must be greater than 0, is 0");
        row("run two-balls --engine stepped --step 1e-9",
            "--step: takes 1e+10 steps, more than the 100000000");
        row("run two-balls --json --csv", "choose either --json or --csv");
        row("run two-balls --csv --summary", "--summary: ");
        row("explain", "SCENE is missing");
        row("explain right-angle --collision 2", "--collision: must be from 1 to 1");
        row("explain right-angle --collision 0", "--collision: must be a whole number greater than 0");
        row("explain right-angle --until 0.1", "right-angle: nothing collides");
        row("throw down", "down: one argument too many");
        row("throw --mass 0", "--mass: must be greater than 0 and at most 7.26, is 0");
        row("throw --mass 7.27", "--mass: must be greater than 0 and at most 7.26, is 7.27");
        row("throw --speed -1", "--speed: must be greater than 0 and at most 100, is -1");
        row("throw --speed 101", "--speed: must be greater than 0 and at most 100, is 101");
        row("throw --direction 90", "--direction: must be greater than -90 and less than 90, is 90");
        row("throw --position 0.6", "--position: must be from -0.52705 to 0.52705, is 0.6");
        row("throw --spin inf", "--spin: must be a number");
        row("throw --axis 1x", "--axis: must be a number");
        row("throw --spin 10001", "--spin: must be from -10000 to 10000, is 10001");
        row("throw --friction -0.1", "--friction: must be from 0 to 10, is -0.1");
        row("throw --oil 11", "--oil: must be from 0 to 10, is 11");
        row("throw --oil-length 20", "--oil-length: must be from 0 to 19.156, is 20");
        row("throw --restitution 1.1", "--restitution: must be from 0 to 1, is 1.1");
        for (const char* option : {"friction", "oil", "oil-length"})
            row(QString("throw --no-friction --%1 0.1").arg(option), "has no meaning with --no-friction");
        row("run two-balls --contact-time 0", "--contact-time: must be greater than 0, is 0");
        row("run two-balls --contact-time soon", "--contact-time: must be a number");
        row("run two-balls --engine stepped --contact-time 1e-4", "--contact-time: only with --engine event");
        row("picture two-balls --output x.png --at -1", "--at: must be at least 0, is -1");
    }

    void wrongCalls() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, contains);
        const Outcome o = call(arguments);
        QCOMPARE(o.status, 2);
        QVERIFY2(isOneLine(o.error), qPrintable(o.error));
        QVERIFY2(o.error.contains(contains), qPrintable(o.error));
        QVERIFY(o.out.isEmpty());

        if (contains.contains("ko or en"))
            return; // which language, when it is the language that is wrong?
        const Outcome korean = call(arguments + QStringList{"--language=ko"});
        const bool swallowed = korean.error.contains("--language=ko"); // as the value of the last option
        QVERIFY2(korean.status == 2 && isOneLine(korean.error), qPrintable(korean.error));
        QVERIFY2(hasHangul(korean.error) || swallowed, qPrintable(korean.error));
    }

    void theStudyOfExtremesIsATableAndAFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("extremes.csv");
        const Outcome o = call({"study", "extremes", "--quick", "--csv", path, "--language", "ko"});
        const QString out = QString::fromUtf8(o.out);
        QVERIFY2(out.contains("3141592") && out.contains("질량비"), o.out.constData());
        QVERIFY(o.error.contains("14/14 거울 대칭"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.first(), QString("row,case,asked,exact,got,error,bound,within"));
        int beyond = 0;
        for (const QString& line : lines) {
            QCOMPARE(line.count(','), 7);
            beyond += line.endsWith(",no");
        }
        QVERIFY(lines.contains("pi,masses 1e+12,collisions,3141592,3141592,0,0,yes"));
        QCOMPARE(o.status, beyond == 0 ? 0 : 1); // one beyond its bound is told by the status
        QCOMPARE(o.error.contains("한계를 벗어난 것"), beyond > 0);
        QCOMPARE(call({"study", "extremes", "--quick", "--csv", "/nowhere/at/all.csv"}).status, 1);
    }

    void theSystemsLanguageIsTheDefault() {
        const Outcome o = call({"run", "head-on"}, {}, {"LANG=ko_KR.UTF-8"});
        QCOMPARE(o.error, QString());
        QVERIFY(QString::fromUtf8(o.out).contains("정면충돌"));
        QVERIFY(QString::fromUtf8(call({"run", "head-on", "--language", "en"}, {}, {"LANG=ko_KR.UTF-8"}).out)
                    .contains("Head-on"));
    }

    void aSceneComesFromAFileOrStandardInput() {
        const QByteArray text = call({"scene", "glancing"}).out;
        QTemporaryDir dir;
        const QString path = dir.filePath("장면 1.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        const Outcome builtin = call({"run", "glancing", "--json"});
        QCOMPARE(builtin.status, 0);
        QCOMPARE(call({"run", path, "--json"}).out, builtin.out);
        QCOMPARE(call({"run", "-", "--json"}, text).out, builtin.out);
    }

    void faultsOfAFileNameThePlace() {
        QByteArray text = writeScene(*builtinScene("two-balls"));
        text.replace("\"mass\": 1,", "\"mass\": -3,");
        QTemporaryDir dir;
        QFile file(dir.filePath("scene.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        const Outcome o = call({"run", file.fileName()});
        QCOMPARE(o.status, 2);
        QCOMPARE(o.error, file.fileName() + ": bodies[1].mass: must be greater than 0, is -3\n");
        const Outcome korean = call({"run", file.fileName(), "--language", "ko"});
        QVERIFY2(korean.error.contains(": bodies[1].mass: 0보다 커야 합니다"), qPrintable(korean.error));
    }

    void faultsOfALaneAreTold_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("english");
        QTest::addColumn<QString>("korean");
        QTest::newRow("oil")
            << QByteArray("\"to\": -6.096") << QByteArray("\"to\": -20")
            << "friction.oil[0].to: must be greater than -18.288, where the oil begins, is -20"
            << "friction.oil[0].to: 오일이 시작하는 -18.288보다 커야 하는데 -20입니다";
        QTest::newRow("oils") << QByteArray("\"oil\": [")
                              << QByteArray("\"oil\": [{\"from\": -19, \"to\": -18, \"friction\": 0},")
                              << "friction.oil[1].from: must be at least -18, where friction.oil[0] ends, is "
                                 "-18.288"
                              << "friction.oil[1].from: friction.oil[0]의 끝 -18 이상이어야 하는데";
        QTest::newRow("kickbacks")
            << QByteArray("{\"from\": -0.1") << QByteArray("{\"from\": 1")
            << "lane.kickbacks.from: must be from -18.288, the foul line, to 0.868, the "
               "end of the lane, is 1"
            << "lane.kickbacks.from: 파울 라인 -18.288부터 레인의 끝 0.868까지여야 하는데 1입니다";
        QTest::newRow("gravity") << QByteArray("\"ball\": 0.2")
                                 << QByteArray("\"ball\": 0.2, \"gravity\": -1")
                                 << "friction.gravity: must be greater than 0, is -1"
                                 << "friction.gravity: 0보다 커야 합니다";
        QTest::newRow("inertia") << QByteArray("\"velocity\"") << QByteArray("\"inertia\": 2, \"velocity\"")
                                 << "bodies[0].inertia: must be greater than 0 and at most 1, is 2"
                                 << "bodies[0].inertia: 0보다 크고 1 이하여야 하는데 2입니다";
        QTest::newRow("spin") << QByteArray("\"velocity\"") << QByteArray("\"spin\": [1], \"velocity\"")
                              << "bodies[0].spin: must be three numbers: [x, y, z]"
                              << "bodies[0].spin: 세 수 [x, y, z]여야 합니다";
        QTest::newRow("id") << QByteArray("\"ball\", \"kind\"") << QByteArray("\"wall:top\", \"kind\"")
                            << "bodies[0].id: \"wall:top\" begins with \"wall:\""
                            << "bodies[0].id: \"wall:top\" id는 쓸 수 없습니다";
        QTest::newRow("number") << QByteArray("\"ball\": 0.2,") << QByteArray("\"ball\": .2,")
                                << "not valid JSON: a number needs a digit on each side of its point"
                                << "소수점의 앞뒤";
        QTest::newRow("tab") << QByteArray("the whole lane") << QByteArray("the\twhole lane")
                             << "not valid JSON: a control character in a text must be escaped"
                             << "제어 문자";
    }

    void faultsOfALaneAreTold() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, english);
        QFETCH(QString, korean);
        QByteArray text = writeScene(*builtinScene("bowling"));
        const qsizetype at = text.indexOf(from);
        QVERIFY(at > 0);
        text.replace(at, from.size(), to);
        const Outcome o = call({"run", "-", "--language", "en"}, text);
        QCOMPARE(o.status, 2);
        QVERIFY2(isOneLine(o.error) && o.error.contains(english), qPrintable(o.error));
        const Outcome k = call({"run", "-", "--language", "ko"}, text);
        QVERIFY2(isOneLine(k.error) && k.error.contains(korean), qPrintable(k.error));
    }

    void severalFaultsAreOneLine() {
        const Outcome o = call({"run", "-"}, R"({"format": "thetalane-scene", "version": 1, "bodies":
            [{"id": "a\nb", "id": "c"}], "restitution": 2, "color": 3})");
        QCOMPARE(o.status, 2);
        QVERIFY2(isOneLine(o.error), qPrintable(o.error));
        QVERIFY2(o.error.contains("more)"), qPrintable(o.error));
    }

    void namesCannotBreakALine() {
        Scene scene = *builtinScene("two-balls");
        scene.bodies[0].id = "two\nlines\x1b[31m";
        scene.bodies[1].position = scene.bodies[0].position;
        const Outcome o = call({"run", "-"}, writeScene(scene));
        QCOMPARE(o.status, 2);
        QVERIFY2(isOneLine(o.error), qPrintable(o.error));
        QVERIFY(!o.error.contains(QChar(0x1b)));
    }

    void aFullDiskIsAFailure() {
        if (!QFile::exists("/dev/full"))
            return;
        for (const QStringList& arguments : {QStringList{"run", "two-balls"},
                                             {"run", "two-balls", "--json"},
                                             {"run", "two-balls", "--csv"},
                                             {"explain", "head-on"},
                                             {"throw"},
                                             {"scenes"},
                                             {"scene", "rack"},
                                             {"--help"},
                                             {"--version"}}) {
            QProcess process;
            process.setEnvironment({"PATH=/usr/bin:/bin"});
            process.setStandardOutputFile("/dev/full");
            process.start(THETALANE_PROGRAM, arguments);
            QVERIFY(process.waitForFinished());
            QCOMPARE(process.exitCode(), 1);
            const QString error = QString::fromUtf8(process.readAllStandardError());
            QVERIFY2(isOneLine(error) && error.contains("cannot be written"), qPrintable(error));
        }
    }

    void withoutADisplayTheWindowSaysSoInOneLine() {
        for (const QStringList& environment : {QStringList{},
                                               {"DISPLAY=:4077"},
                                               {"WAYLAND_DISPLAY=none", "DISPLAY=:4077"},
                                               {"QT_QPA_PLATFORM=xcb", "DISPLAY=:4077"},
                                               {"QT_QPA_PLATFORM="},
                                               {"QT_QPA_PLATFORM=nonsense"}}) {
            const Outcome o = call({"--language", "en"}, {}, environment);
            const QByteArray where = environment.join(' ').toUtf8() + ": " + o.error.toUtf8();
            QVERIFY2(o.status == 1 && isOneLine(o.error), where.constData());
            QVERIFY(o.out.isEmpty());
        }
    }

    void columnsLineUpWithKoreanNames() {
        Scene scene = *builtinScene("two-balls");
        scene.bodies[0].id = "빨간 공";
        const QString out =
            QString::fromUtf8(call({"run", "-", "--language", "ko", "--until", "3"}, writeScene(scene)).out);
        // The column after the names is right-aligned: what precedes it is equally wide in every row.
        const QStringList lines = out.split('\n');
        QList<int> ends;
        for (const QString& line : lines)
            if (line.contains(" – "))
                ends << cells(line);
        QVERIFY(ends.size() >= 3);
        for (const int end : ends)
            QCOMPARE(end, ends.first());
    }

private:
    static int cells(const QString& line) {
        int n = 0;
        for (const QChar c : line)
            n += c.unicode() >= 0x1100 && c.unicode() <= 0xD7A3 &&
                         !(c.unicode() >= 0x2000 && c.unicode() < 0x2E80)
                     ? 2
                     : 1;
        return n;
    }
};

QTEST_APPLESS_MAIN(TestCommands)
#include "test_commands.moc"

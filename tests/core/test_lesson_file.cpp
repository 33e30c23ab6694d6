// Lesson files: every fault named by its place, and what the built-in lessons say is what the engine finds.
#include "core/bowling/pinfall.h"
#include "core/format/lesson_file.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <cmath>
#include <numbers>
#include <set>

using namespace thetalane;
using Fault = LessonFault;

namespace {

const QByteArray good = R"({
  "format": "thetalane-lesson", "version": 1,
  "title": {"en": "Title", "ko": "제목"},
  "summary": {"en": "Summary"},
  "scene": "head-on",
  "engine": {"kind": "event", "until": 5},
  "stops": [
    {"at": "start", "text": {"en": "One"}},
    {"at": 0.25, "text": {"en": "Two"}, "show": "lab"},
    {"collision": 1, "stage": 3, "restitution": 0.5, "text": {"en": "Three"}}
  ],
  "question": {
    "before": 3, "kind": "number", "quantity": "speed", "body": "A", "after": 1, "tolerance": 0.05,
    "text": {"en": "How fast?"}, "answer": {"en": "So."}
  }
})";

QByteArray with(QByteArray what, const QByteArray& instead) {
    QByteArray json = good;
    if (!json.contains(what))
        qFatal("not in the good lesson: %s", what.constData());
    return json.replace(what, instead);
}

std::vector<LessonError> errorsOf(const QByteArray& json) {
    const auto read = readLesson(json);
    const auto* errors = std::get_if<std::vector<LessonError>>(&read);
    return errors ? *errors : std::vector<LessonError>{};
}

Lesson builtIn(const QString& name) {
    QFile file(QStringLiteral(THETALANE_SOURCE_DIR "/ui/lessons/data/%1.json").arg(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no lesson %s", qPrintable(name));
    const auto read = readLesson(file.readAll());
    if (const auto* errors = std::get_if<std::vector<LessonError>>(&read))
        qFatal("%s: %s %s %g", qPrintable(name), errors->front().path.c_str(), errors->front().text.c_str(),
               errors->front().high);
    return std::get<Lesson>(read);
}

Run runOf(const Lesson& lesson, std::size_t stop) {
    const LessonSetting& s = lesson.settings[lesson.stops[stop].setting];
    return std::get<Run>(simulate(s.scene, s.engine));
}

const Collision& at(const Run& run, int number) {
    return run.timeline.collisions()[std::size_t(number - 1)];
}

QString pairOf(const Run& run, int number) {
    const Collision& c = at(run, number);
    return QString::fromStdString(run.scene.bodies[std::size_t(c.first)].id + '-' +
                                  run.scene.bodies[std::size_t(c.second)].id);
}

// From straight down the lane, to the left [°].
double leftOf(const Vec2d& v) {
    return std::atan2(-v.x, v.y) * 180 / std::numbers::pi;
}

double angle(const Run& run, int body, int other, int collision) {
    return measure(run, {QuantityKind::AngleBetween, body, other, collision})->x;
}

} // namespace

#define NEAR(a, b, tolerance)                                                                                \
    QVERIFY2(std::abs((a) - (b)) <= (tolerance),                                                             \
             qPrintable(QString::number(a, 'g', 15) + " is not " + QString::number(b, 'g', 15)))

class TestLessonFile : public QObject {
    Q_OBJECT

private slots:
    void goodFileIsRead() {
        const auto read = readLesson(good);
        QVERIFY(std::holds_alternative<Lesson>(read));
        const Lesson& l = std::get<Lesson>(read);
        QCOMPARE(l.title.ko, std::string("제목"));
        QCOMPARE(l.summary.en, std::string("Summary"));
        QCOMPARE(l.settings.size(), 2u);
        QCOMPARE(l.settings[0].sceneId, std::string("head-on"));
        QCOMPARE(l.settings[0].engine.until, 5.0);
        QCOMPARE(l.settings[1].sceneId, std::string());
        QCOMPARE(l.settings[1].scene.restitution, 0.5);
        QCOMPARE(l.settings[1].engine.until, 5.0);
        QCOMPARE(l.stops.size(), 3u);
        QVERIFY(l.stops[0].at == StopAt::Start);
        QVERIFY(l.stops[1].at == StopAt::Time && l.stops[1].time == 0.25);
        QVERIFY(l.stops[1].show == LessonShow::Lab);
        QVERIFY(l.stops[2].at == StopAt::Collision && l.stops[2].collision == 1 && l.stops[2].stage == 3);
        QCOMPARE(l.question->before, 2u);
        QCOMPARE(l.question->setting, 1u);
        QCOMPARE(l.question->tolerance, 0.05);
        // 1 and -0.5 m/s, equal masses, e = 0.5: A leaves with (0.5·1 + 1.5·(-0.5))/2 = -0.125 m/s.
        NEAR(truthOf(l)->x, 0.125, 1e-15);
    }

    void faultsNameTheirPlace_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("fault");
        const auto row = [](const char* name, const QByteArray& json, const char* path, Fault fault) {
            QTest::newRow(name) << json << path << int(fault);
        };
        row("empty", "", "line 1, column 1", Fault::Shape);
        row("no JSON", "{\"format\": \"thetalane-lesson\",", "line 1, column 31", Fault::Shape);
        row("a list", "[]", "", Fault::Shape);
        row("another format", with("thetalane-lesson", "thetalane-scene"), "format", Fault::WrongFormat);
        row("another version", with("\"version\": 1", "\"version\": 2"), "version", Fault::WrongVersion);
        row("twice", with("\"version\": 1,", "\"version\": 1, \"version\": 1,"), "version", Fault::Shape);
        row("no title", with("\"title\": {\"en\": \"Title\", \"ko\": \"제목\"},", ""), "title", Fault::Shape);
        row("no words", with("{\"en\": \"Summary\"}", "{\"en\": \" \"}"), "summary", Fault::NoWords);
        row("words as text", with("{\"en\": \"One\"}", "\"One\""), "stops[0].text", Fault::Shape);
        row("a language that is not there", with("{\"en\": \"One\"}", "{\"en\": \"One\", \"fr\": \"Un\"}"),
            "stops[0].text.fr", Fault::Shape);
        row("misspelt key", with("\"stage\": 3", "\"stgae\": 3"), "stops[2].stgae", Fault::Shape);
        row("unknown scene", with("\"head-on\"", "\"headon\""), "scene", Fault::UnknownWord);
        row("scene as number", with("\"head-on\"", "5"), "scene", Fault::Shape);
        row("scene without bodies", with("\"head-on\"", "{\"restitution\": 1, \"bodies\": []}"),
            "scene.bodies", Fault::Shape);
        row("a body without mass",
            with("\"head-on\"", R"({"restitution": 1, "bodies": [{"id": "A", "kind": "ball", "mass": 0,
                 "radius": 1, "position": [0, 0], "velocity": [0, 0]}]})"),
            "scene.bodies[0].mass", Fault::Shape);
        row("unknown engine", with("\"event\"", "\"events\""), "engine.kind", Fault::UnknownWord);
        row("approaching as text", with("\"until\": 5", "\"approaching_only\": \"no\""),
            "engine.approaching_only", Fault::UnknownWord);
        row("refused", with("\"until\": 5", "\"until\": -5"), "engine", Fault::Refused);
        row("no stops",
            with(R"("stops": [
    {"at": "start", "text": {"en": "One"}},
    {"at": 0.25, "text": {"en": "Two"}, "show": "lab"},
    {"collision": 1, "stage": 3, "restitution": 0.5, "text": {"en": "Three"}}
  ])",
                 "\"stops\": []"),
            "stops", Fault::NoStops);
        row("stop as text", with(R"({"at": "start", "text": {"en": "One"}})", "\"start\""), "stops[0]",
            Fault::Shape);
        row("no place", with("\"at\": \"start\", ", ""), "stops[0]", Fault::NoPlace);
        row("two places", with("\"at\": 0.25", "\"at\": 0.25, \"collision\": 1"), "stops[1]", Fault::NoPlace);
        row("at somewhere", with("\"start\"", "\"begin\""), "stops[0].at", Fault::UnknownWord);
        row("before the start", with("0.25", "-0.25"), "stops[1].at", Fault::OutOfRange);
        row("after the end", with("0.25", "25"), "stops[1].at", Fault::BeyondTheEnd);
        row("half a collision", with("\"collision\": 1", "\"collision\": 1.5"), "stops[2].collision",
            Fault::NotWhole);
        row("collision 0", with("\"collision\": 1", "\"collision\": 0"), "stops[2].collision",
            Fault::OutOfRange);
        row("no such collision", with("\"collision\": 1", "\"collision\": 2"), "stops[2].collision",
            Fault::NoSuchCollision);
        row("stage 6", with("\"stage\": 3", "\"stage\": 6"), "stops[2].stage", Fault::OutOfRange);
        row("e above 1", with("\"restitution\": 0.5", "\"restitution\": 1.5"), "stops[2].restitution",
            Fault::OutOfRange);
        row("shows what there is not", with("\"lab\"", "\"labs\""), "stops[1].show", Fault::UnknownWord);
        row("no question kind", with("\"kind\": \"number\"", "\"kind\": \"numbers\""), "question.kind",
            Fault::UnknownWord);
        row("before stop 9", with("\"before\": 3", "\"before\": 9"), "question.before", Fault::OutOfRange);
        row("unknown quantity", with("\"speed\"", "\"sped\""), "question.quantity", Fault::UnknownWord);
        row("a vector asked as a number", with("\"speed\"", "\"velocity\""), "question.quantity",
            Fault::UnknownWord);
        row("a number asked as a vector", with("\"kind\": \"number\"", "\"kind\": \"vector\""),
            "question.quantity", Fault::UnknownWord);
        row("unknown body", with("\"body\": \"A\"", "\"body\": \"Z\""), "question.body", Fault::UnknownBody);
        row("no body", with("\"body\": \"A\", ", ""), "question.body", Fault::Shape);
        row("after collision 2", with("\"after\": 1", "\"after\": 2"), "question.after",
            Fault::NoSuchCollision);
        row("tolerance 0", with("0.05", "0"), "question.tolerance", Fault::OutOfRange);
        row("nothing to measure",
            with(R"("quantity": "speed", "body": "A", "after": 1)", R"("quantity": "theta")"),
            "question.quantity", Fault::NothingToMeasure);
        row("one option",
            with(R"("kind": "number", "quantity": "speed", "body": "A", "after": 1)",
                 R"("kind": "choice", "options": [{"en": "Yes"}], "right": 1)"),
            "question.options", Fault::TooFewOptions);
        row("option 3 of 2",
            with(R"("kind": "number", "quantity": "speed", "body": "A", "after": 1)",
                 R"("kind": "choice", "options": [{"en": "1"}, {"en": "2"}], "right": 3)"),
            "question.right", Fault::OutOfRange);
    }
    void faultsNameTheirPlace() {
        QFETCH(QByteArray, json);
        QFETCH(QString, path);
        QFETCH(int, fault);
        const auto errors = errorsOf(json);
        QVERIFY(!errors.empty());
        QCOMPARE(QString::fromStdString(errors.front().path), path);
        QCOMPARE(int(errors.front().fault), fault);
    }

    void whatWouldBeRightIsSaid() {
        QCOMPARE(errorsOf(with("\"head-on\"", "\"headon\"")).front().other, std::string("head-on"));
        QCOMPARE(errorsOf(with("\"body\": \"A\"", "\"body\": \"Z\"")).front().allowed,
                 (std::vector<std::string>{"A", "B"}));
        QCOMPARE(errorsOf(with("\"collision\": 1", "\"collision\": 7")).front().high, 1.0);
        QCOMPARE(errorsOf(with("\"speed\"", "\"velocity\"")).front().allowed.size(), 8u);
    }

    void faultsComeInTheOrderOfTheFile() {
        QByteArray json = with("\"stage\": 3", "\"stage\": 7");
        json.replace("\"lab\"", "\"labs\"")
            .replace("\"Title\"", "5")
            .replace("\"body\": \"A\"", "\"body\": 1");
        QStringList paths;
        for (const LessonError& e : errorsOf(json))
            paths << QString::fromStdString(e.path);
        QCOMPARE(paths, (QStringList{"title.en", "stops[1].show", "stops[2].stage", "question.body"}));
    }

    void nonsenseIsAnswered() {
        for (qsizetype cut = 0; cut < good.size(); cut += 3)
            QVERIFY(!errorsOf(good.left(cut)).empty());
    }

    void everyBuiltInLessonIsWhole() {
        const QStringList names =
            QDir(QStringLiteral(THETALANE_SOURCE_DIR "/ui/lessons/data")).entryList({"*.json"}, QDir::Files);
        QVERIFY(names.size() >= 8 && names.size() <= 10);
        for (const QString& name : names) {
            const Lesson l = builtIn(name.chopped(5));
            QVERIFY(l.question.has_value());
            QVERIFY(l.stops.size() >= 3);
            std::vector<Title> texts{l.title, l.summary, l.question->text, l.question->answer};
            texts.insert(texts.end(), l.question->options.begin(), l.question->options.end());
            for (const LessonStop& s : l.stops)
                texts.push_back(s.text);
            for (const Title& t : texts)
                QVERIFY2(!t.en.empty() && !t.ko.empty(), qPrintable(name));
        }
    }

    void headOn() {
        const Lesson l = builtIn("01-head-on");
        const Run run = runOf(l, 0);
        NEAR(at(run, 1).steps.after.first.x, -0.5, 1e-15);
        NEAR(at(run, 1).steps.after.second.x, 1.0, 1e-15);
        NEAR(truthOf(l)->x, 0.5, 1e-15);
        NEAR(measure(run, {QuantityKind::TotalMomentum, 0, 1, 1})->x, 0.5, 1e-15);
        NEAR(at(run, 1).steps.energyLoss, 0.0, 1e-15);
    }

    void heavyAndLight() {
        const Lesson l = builtIn("02-heavy-and-light");
        const PairCollision<double> heavy = at(runOf(l, 0), 1).steps, light = at(runOf(l, 2), 1).steps;
        NEAR(heavy.after.second.x, 16.0 / 9, 1e-14); // 2·4/(4 + 0.5)
        NEAR(heavy.after.first.x, 7.0 / 9, 1e-14);
        QVERIFY(heavy.after.second.x > 1 && heavy.after.second.x < 2);
        QCOMPARE(l.question->right, 1u);
        NEAR(light.after.first.x, -7.0 / 9, 1e-14);
        NEAR(light.after.second.x, 2.0 / 9, 1e-14);
        QVERIFY(4 * light.after.second.x > 0.5); // more momentum than A brought
    }

    void lostEnergy() {
        const Lesson l = builtIn("03-lost-energy");
        NEAR(at(runOf(l, 0), 1).steps.after.first.x, 0.0, 1e-15);
        NEAR(at(runOf(l, 0), 1).steps.energyLoss, 0.0, 1e-15);
        NEAR(at(runOf(l, 1), 1).steps.energyLoss, 0.375, 1e-15);
        NEAR(truthOf(l)->x, 0.5, 1e-15);
        NEAR(totals(runOf(l, 0).scene, runOf(l, 0).timeline.stateAt(0)).energy, 1.0, 1e-15);
    }

    void theta() {
        const Run run = runOf(builtIn("04-theta"), 0);
        const PairCollision<double>& s = at(run, 1).steps;
        QCOMPARE(s.exchanged.first.y, s.rotated.first.y);
        QVERIFY(std::abs(s.exchanged.first.x - s.rotated.first.x) > 0.1);
    }

    void rightAngle() {
        const Lesson l = builtIn("05-right-angle");
        NEAR(angle(runOf(l, 0), 0, 1, 1), 90.0, 1e-12);
        NEAR(truthOf(l)->x, 90.0, 1e-12);
        // 90° − atan[((1 − e)/2) cot φ], with sin φ = 0.1/0.2: they meet at φ = 30°.
        const double degrees = 180 / std::numbers::pi;
        NEAR(angle(runOf(l, 2), 0, 1, 1), 90 - std::atan(0.25 * std::sqrt(3.0)) * degrees, 1e-9);
        NEAR(angle(runOf(l, 2), 0, 1, 1), 66.6, 0.05);
    }

    void pinsSideways() {
        const Lesson l = builtIn("06-pins-sideways");
        const Run run = runOf(l, 0);
        QCOMPARE(pairOf(run, 1), "ball-1");
        QCOMPARE(pairOf(run, 2), "1-2");
        QCOMPARE(pairOf(run, 5), "4-7");
        NEAR(leftOf(at(run, 1).steps.after.second), 23.58, 0.01);
        NEAR(leftOf(at(run, 2).steps.after.second), 39.93, 0.01);
        NEAR(leftOf(at(run, 5).steps.after.second), 57.48, 0.02);
    }

    void cradle() {
        const Lesson l = builtIn("07-cradle");
        for (const std::size_t stop : {1u, 2u}) {
            const Run run = runOf(l, stop);
            QCOMPARE(run.timeline.collisionCount(), 4);
            const auto end = run.timeline.stateAt(run.timeline.endTime());
            for (int k = 0; k < 4; ++k)
                NEAR(end[std::size_t(k)].velocity.x, 0.0, 1e-15);
            NEAR(end[4].velocity.x, 1.0, 1e-15);
            QCOMPARE(at(run, 4).group > 0, stop == 2); // of one instant
            QCOMPARE(at(run, 4).together, 1);
        }
        const Run two = runOf(l, 3);
        QCOMPARE(at(two, 1).together, 2);
        const auto end = two.timeline.stateAt(two.timeline.endTime());
        NEAR(end[0].velocity.x, -0.2, 1e-14);
        NEAR(norm(end[1].velocity), 0.4 * std::sqrt(3.0), 1e-14);
        QCOMPARE(end[1].velocity.x, end[2].velocity.x);
        QCOMPARE(end[1].velocity.y, -end[2].velocity.y);
    }

    void programsGoWrong() {
        const Lesson l = builtIn("08-programs-wrong");
        QCOMPARE(runOf(l, 0).timeline.collisionCount(), 1);
        NEAR(at(runOf(l, 0), 1).time, 0.0355, 1e-12);
        QCOMPARE(runOf(l, 1).timeline.collisionCount(), 0);
        QVERIFY(runOf(l, 1).timeline.bodyAt(0, 0.1).position.x > 0.12); // and yet it is behind
        QVERIFY(runOf(l, 2).timeline.collisionCount() >= 200);
        const Run mended = runOf(l, 3);
        QCOMPARE(mended.timeline.collisionCount(), 1);
        const double exact = 0.605;
        QVERIFY(at(mended, 1).time > exact && at(mended, 1).time <= exact + 1.0 / 60);
    }

    void countingPi() {
        const Lesson l = builtIn("09-counting-pi");
        QCOMPARE(runOf(l, 0).timeline.collisionCount(), 3);
        QCOMPARE(runOf(l, 1).timeline.collisionCount(), 31);
        QCOMPARE(runOf(l, 2).timeline.collisionCount(), 314);
        QCOMPARE(truthOf(l)->x, 314.0);
    }

    void perfectStrike() {
        const Lesson l = builtIn("10-perfect-strike");
        const Run run = runOf(l, 0);
        std::set<QString> byBall;
        for (int k = 1; k <= int(run.timeline.collisions().size()); ++k)
            if (pairOf(run, k).startsWith("ball-"))
                byBall.insert(pairOf(run, k));
        QCOMPARE(byBall, (std::set<QString>{"ball-1", "ball-3", "ball-5", "ball-9"}));
        QCOMPARE(pairOf(run, 2), "1-2");
        QCOMPARE(pairOf(run, 3), "2-4");
        QCOMPARE(pairOf(run, 5), "4-7");
        QCOMPARE(pairOf(run, 7), "6-10");
        QCOMPARE(pairOf(run, 8), "ball-5");
        QCOMPARE(pairOf(run, 10), "5-8");
        QCOMPARE(pairOf(run, 12), "ball-9");
        QCOMPARE(measure(run, {QuantityKind::PinsDown})->x, 10.0);
    }
};

QTEST_GUILESS_MAIN(TestLessonFile)
#include "test_lesson_file.moc"

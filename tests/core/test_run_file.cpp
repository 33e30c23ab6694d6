// What a run writes: the shape that is promised, and numbers that come back to the last bit.
#include "core/format/json_text.h"
#include "core/format/run_file.h"
#include "core/scene/builtin.h"

#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <bit>
#include <cmath>
#include <limits>

using namespace thetalane;

namespace {

// Qt's JSON reader takes -0.0 for 0; every other double must come back to the bit.
bool sameBits(double a, double b) {
    return (a == 0 && b == 0) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameBits(const Vec2d& a, const Vec2d& b) {
    return sameBits(a.x, b.x) && sameBits(a.y, b.y);
}

Run runOf(const char* name, EngineSettings settings = {}) {
    return std::get<Run>(simulate(*builtinScene(name), settings));
}

QByteArray jsonOf(const Run& run, const QJsonObject& extra = {}) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeRunJson(run, buffer, extra);
    return buffer.data();
}

QByteArray csvOf(const Run& run) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeRunCsv(run, buffer);
    return buffer.data();
}

// A ball that slides and a pin that slides until it rests, as an engine would have written it; they stay in
// touch for a while, and so do the pin and a wall. Two contacts of one pass, then one alone at the same
// instant.
Run handMadeRun() {
    Scene scene;
    scene.bodies = {{"A", BodyKind::Ball, 7, 0.11, {0, 0}, {3, 0}, {1, -2, 5}, 0.35},
                    {"1", BodyKind::Pin, 1.5, 0.06, {1, 0}, {0, 1}, {9, 9, 9}}};
    scene.friction = Friction{};
    scene.friction->ball = 0.2;
    TimelineRecord record;
    record.segments = {{0, {0, {0, 0}, {3, 0}, {-2, 0}}},
                       {1, {0, {1, 0}, {0, 1}, {0, -4}}},
                       {1, {0.25, {1, 0.125}, {}, {}}}};
    record.rotations = {
        {{1, -2, 5}, {0.5, 4, 0}, FloorPhase::Sliding}, {{9, 9, 9}, {}, FloorPhase::Sliding}, {}};
    Collision c;
    c.time = 0.125;
    c.second = 1;
    c.pass = 7; // an engine's passes are any numbers
    record.collisions = {c, c, c, c};
    record.collisions[1].second = -1;
    record.collisions[1].side = Side::Top;
    record.collisions[2].pass = 0;
    record.collisions[3].time = 0.25;
    record.collisions[3].pass = 0;
    record.collisionCount = 4;
    record.lasting = {{0.125, 0.2, 0, 1, Side::Left}, {0.15, 0.25, 1, -1, Side::Bottom}};
    record.endTime = 0.5;
    EngineSettings settings{.until = 0.5, .contactTime = 2e-4};
    return {scene, settings, Timeline(2, std::move(record))};
}

Vec2d vec(const QJsonValue& pair) {
    return {pair[0].toDouble(), pair[1].toDouble()};
}

} // namespace

class TestRunFile : public QObject {
    Q_OBJECT

private slots:
    void numbersAreShortest() {
        QCOMPARE(jsonNumber(0.1), QByteArray("0.1"));
        QCOMPARE(jsonNumber(-0.0), QByteArray("-0.0"));
        QCOMPARE(jsonNumber(1), QByteArray("1"));
        QCOMPARE(jsonNumber(1e300), QByteArray("1e+300"));
        QCOMPARE(jsonNumber(0.1 + 0.2), QByteArray("0.30000000000000004"));
        QCOMPARE(jsonNumber(std::numeric_limits<double>::infinity()), QByteArray("null"));
        QCOMPARE(jsonNumber(std::nan("")), QByteArray("null"));
    }

    void runJsonHasItsShape() {
        const Run run = runOf("two-balls", {.until = 2});
        const QJsonObject o = QJsonDocument::fromJson(jsonOf(run, {{"throw", 7}})).object();
        QCOMPARE(o.keys(), (QStringList{"collision_count", "collisions", "end", "engine", "format",
                                        "precision", "step", "throw", "totals", "until", "version"}));
        QCOMPARE(o["format"].toString(), QString("thetalane-run"));
        QCOMPARE(o["version"].toInt(), 1);
        QCOMPARE(o["engine"].toString(), QString("event"));
        QCOMPARE(o["precision"].toString(), QString("double"));
        QVERIFY(o["step"].isNull());
        QCOMPARE(o["until"].toDouble(), 2.0);
        QCOMPARE(o["throw"].toInt(), 7);
        const QJsonObject end = o["end"].toObject();
        QCOMPARE(end["reason"].toString(), QString("until"));
        QCOMPARE(end["time"].toDouble(), 2.0);
        QCOMPARE(end["bodies"].toArray().size(), 2);
        QCOMPARE(end["bodies"][0]["id"].toString(), QString("A"));
        QVERIFY(sameBits(vec(end["bodies"][1]["position"]), run.timeline.bodyAt(1, 2).position));
        QCOMPARE(o["totals"]["start"]["energy"].toDouble(), 0.5 * 2 * (1 + 0.2 * 0.2));
        QCOMPARE(vec(o["totals"]["start"]["momentum"]), (Vec2d{2, 0.4}));
    }

    void runJsonReadsBackToTheSameDoubles() {
        const Run run = runOf("rack");
        const QJsonObject o = QJsonDocument::fromJson(jsonOf(run)).object();
        const QJsonArray list = o["collisions"].toArray();
        const auto collisions = run.timeline.collisions();
        QCOMPARE(std::size_t(list.size()), collisions.size());
        QVERIFY(collisions.size() > 5);
        for (std::size_t i = 0; i < collisions.size(); ++i) {
            const QJsonValue item = list[qsizetype(i)];
            const PairCollision<double>& s = collisions[i].steps;
            QCOMPARE(item["number"].toInt(), int(i) + 1);
            QVERIFY(sameBits(item["time"].toDouble(), collisions[i].time));
            QVERIFY(sameBits(item["contact"]["Z"].toDouble(), s.contact.Z));
            QVERIFY(sameBits(item["contact"]["sin"].toDouble(), s.contact.sinTheta));
            QVERIFY(sameBits(vec(item["before"]["first"]), s.before.first));
            QVERIFY(sameBits(vec(item["rotated"]["second"]), s.rotated.second));
            QVERIFY(sameBits(vec(item["exchanged"]["first"]), s.exchanged.first));
            QVERIFY(sameBits(vec(item["after"]["second"]), s.after.second));
            QVERIFY(sameBits(item["impulse"].toDouble(), s.impulse));
            QVERIFY(sameBits(item["energy_loss"].toDouble(), s.energyLoss));
        }
    }

    void wallsHaveNoSecond() {
        const Run run = runOf("two-balls", {.until = 2});
        const QJsonArray list = QJsonDocument::fromJson(jsonOf(run))["collisions"].toArray();
        int walls = 0;
        for (const QJsonValue& item : list) {
            const bool wall = item["second"].toString().startsWith("wall:");
            walls += wall;
            for (const char* stage : {"before", "rotated", "exchanged", "after"})
                QCOMPARE(item[QLatin1String(stage)].toObject().contains("second"), !wall);
        }
        QVERIFY(walls > 0 && walls < list.size());
    }

    void groupsAreNamedWhereThereAreAny() {
        Scene scene; // two pairs that meet at the same instant
        for (int i = 0; i < 2; ++i) {
            const double y = i;
            scene.bodies.push_back({"A" + std::to_string(i), BodyKind::Ball, 1, 0.1, {0, y}, {1, 0}});
            scene.bodies.push_back({"B" + std::to_string(i), BodyKind::Ball, 1, 0.1, {1, y}, {0, 0}});
        }
        const Run run = std::get<Run>(simulate(scene, {}));
        const QJsonArray list = QJsonDocument::fromJson(jsonOf(run))["collisions"].toArray();
        QCOMPARE(list.size(), 2);
        QCOMPARE(list[0]["group"].toInt(), 1);
        QCOMPARE(list[1]["group"].toInt(), 1);
        QCOMPARE(list[0]["pass"].toInt(), 1);
        const QJsonArray alone = QJsonDocument::fromJson(jsonOf(runOf("head-on")))["collisions"].toArray();
        for (const char* key : {"group", "pass", "together"})
            QVERIFY(!alone[0].toObject().contains(QLatin1String(key)));
    }

    void passesAreNamedWhereThereAreAny() {
        const QJsonArray list = QJsonDocument::fromJson(jsonOf(handMadeRun()))["collisions"].toArray();
        const int pass[] = {1, 1, 2}, together[] = {2, 2, 1};
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(list[i]["group"].toInt(), 1);
            QCOMPARE(list[i]["pass"].toInt(), pass[i]);
            QCOMPARE(list[i]["together"].toInt(), together[i]);
        }
        QVERIFY(!list[3].toObject().contains("pass") && !list[3].toObject().contains("together"));
        const QList<QByteArray> lines = csvOf(handMadeRun()).trimmed().split('\n');
        const QList<QByteArray> names = lines[0].split(',');
        for (int i = 0; i < 3; ++i) {
            const QList<QByteArray> cells = lines[i + 1].split(',');
            QCOMPARE(cells[names.indexOf("pass")].toInt(), pass[i]);
            QCOMPARE(cells[names.indexOf("together")].toInt(), together[i]);
        }
        QVERIFY(lines[4].endsWith(",,"));
    }

    void contactsThatLastAreListed() {
        const Run run = handMadeRun();
        const QJsonArray lasting = QJsonDocument::fromJson(jsonOf(run))["lasting"].toArray();
        const QJsonArray expected{
            QJsonObject{{"from", 0.125}, {"to", 0.2}, {"first", "A"}, {"second", "1"}},
            QJsonObject{{"from", 0.15}, {"to", 0.25}, {"first", "1"}, {"second", "wall:bottom"}}};
        QCOMPARE(lasting, expected);
        QVERIFY(!QJsonDocument::fromJson(jsonOf(runOf("rack"))).object().contains("lasting"));
        Run summary = run;
        summary.settings.keepDetail = false;
        QVERIFY(!QJsonDocument::fromJson(jsonOf(summary)).object().contains("lasting"));
    }

    void turningIsTold() {
        const Run run = handMadeRun();
        const QJsonObject o = QJsonDocument::fromJson(jsonOf(run)).object();
        QCOMPARE(o["contact_time"].toDouble(), 2e-4);
        const QJsonValue ball = o["end"]["bodies"][0], pin = o["end"]["bodies"][1];
        QCOMPARE(ball["spin"].toArray(), (QJsonArray{1.25, 0, 5})); // + (0.5, 4, 0) · 0.5 s
        QCOMPARE(ball["phase"].toString(), QString("sliding"));
        QCOMPARE(pin["spin"].toArray(), (QJsonArray{0, 0, 0}));
        QCOMPARE(pin["phase"].toString(), QString("rest"));
        // ½ β m R² ω², of the ball alone; the other energy is of translation.
        const double half = 0.5 * 0.35 * 7 * 0.11 * 0.11;
        QCOMPARE(o["totals"]["start"]["rotational_energy"].toDouble(), half * (1 + 4 + 25));
        QCOMPARE(o["totals"]["end"]["rotational_energy"].toDouble(), half * (1.25 * 1.25 + 25));
        QCOMPARE(o["totals"]["start"]["energy"].toDouble(), 0.5 * 7 * 9 + 0.5 * 1.5);
        QCOMPARE(o["totals"]["end"]["energy"].toDouble(), 0.5 * 7 * 4);
    }

    void nothingTurnsWithoutFriction() {
        Run run = handMadeRun();
        run.scene.friction.reset();
        const QJsonObject o = QJsonDocument::fromJson(jsonOf(run)).object();
        QVERIFY(!o.contains("lasting") && !o.contains("contact_time"));
        QCOMPARE(o["end"]["bodies"][0].toObject().keys(), (QStringList{"id", "position", "velocity"}));
        QCOMPARE(o["totals"]["start"].toObject().keys(), (QStringList{"energy", "momentum"}));
    }

    void summaryCountsWithoutAList() {
        const Run whole = runOf("two-balls");
        const Run summary = runOf("two-balls", {.keepDetail = false});
        const QJsonObject o = QJsonDocument::fromJson(jsonOf(summary)).object();
        QVERIFY(!o.contains("collisions"));
        QCOMPARE(o["collision_count"].toInt(), int(whole.timeline.collisionCount()));
        const QJsonObject told = QJsonDocument::fromJson(jsonOf(whole)).object();
        QCOMPARE(o["end"], told["end"]);
        // The walls have changed the momentum: a start that were the end's would show.
        QVERIFY(told["totals"]["start"] != told["totals"]["end"]);
        QCOMPARE(o["totals"], told["totals"]);
    }

    void steppedRunsSaySo() {
        const Run run =
            runOf("head-on", {.kind = EngineKind::Stepped, .step = 0.125, .approachingOnly = true});
        const QJsonObject o = QJsonDocument::fromJson(jsonOf(run)).object();
        QCOMPARE(o["engine"].toString(), QString("stepped"));
        QCOMPARE(o["step"].toDouble(), 0.125);
        QCOMPARE(o["approaching_only"].toBool(), true);
    }

    void lanesTellDepartures() {
        const Run run = runOf("bowling");
        const QJsonArray departures = QJsonDocument::fromJson(jsonOf(run))["departures"].toArray();
        QCOMPARE(std::size_t(departures.size()), run.timeline.departures().size());
        QVERIFY(!departures.isEmpty());
        for (const QJsonValue& d : departures)
            QVERIFY(d["place"] == "gutter" || d["place"] == "pit");
        QVERIFY(!QJsonDocument::fromJson(jsonOf(runOf("rack"))).object().contains("departures"));
    }

    void csvReadsBackToTheSameDoubles() {
        const Run run = runOf("two-balls", {.until = 2});
        const QList<QByteArray> lines = csvOf(run).trimmed().split('\n');
        const QList<QByteArray> names = lines[0].split(',');
        QCOMPARE(names.size(), 31);
        // Programs may count columns: what is new comes last.
        QCOMPARE(names.mid(0, 6).join(','), QByteArray("number,time,first,second,group,restitution"));
        QCOMPARE(names.mid(27).join(','), QByteArray("impulse,energy_loss,pass,together"));
        const auto collisions = run.timeline.collisions();
        QCOMPARE(std::size_t(lines.size()), collisions.size() + 1);
        for (std::size_t i = 0; i < collisions.size(); ++i) {
            const QList<QByteArray> cells = lines[qsizetype(i) + 1].split(',');
            QCOMPARE(cells.size(), names.size());
            const auto cell = [&](const char* name) { return cells[names.indexOf(name)]; };
            const Collision& c = collisions[i];
            QCOMPARE(cell("number").toInt(), int(i) + 1);
            QVERIFY(sameBits(cell("time").toDouble(), c.time));
            QVERIFY(sameBits(cell("contact.cos").toDouble(), c.steps.contact.cosTheta));
            QVERIFY(sameBits(cell("before.first.x").toDouble(), c.steps.before.first.x));
            QVERIFY(sameBits(cell("after.first.y").toDouble(), c.steps.after.first.y));
            QCOMPARE(cell("after.second.y").isEmpty(), c.isWall());
            QVERIFY(sameBits(cell("energy_loss").toDouble(), c.steps.energyLoss));
        }
    }

    void csvQuotesNames() {
        Scene scene = *builtinScene("head-on");
        scene.bodies[0].id = "a, \"b\"\nc";
        QVERIFY(csvOf(std::get<Run>(simulate(scene, {}))).contains("\"a, \"\"b\"\"\nc\""));
    }

    void aFullDeviceIsTold() {
        QByteArray nothing;
        QBuffer closed(&nothing);
        closed.open(QIODevice::ReadOnly);
        QTest::ignoreMessage(QtWarningMsg, "QIODevice::write (QBuffer): ReadOnly device");
        QVERIFY(!writeRunJson(runOf("head-on"), closed));
        QTest::ignoreMessage(QtWarningMsg, "QIODevice::write (QBuffer): ReadOnly device");
        QVERIFY(!writeRunCsv(runOf("head-on"), closed));
    }
};

QTEST_APPLESS_MAIN(TestRunFile)
#include "test_run_file.moc"

// The numbers that the program prints, against formulas that it did not compute.
#include "core/format/scene_file.h"
#include "core/scene/builtin.h"
#include "tests/app/program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace thetalane;

namespace {

QJsonObject jsonOf(const QStringList& arguments) {
    const Outcome o = call(arguments);
    return o.status == 0 ? QJsonDocument::fromJson(o.out).object() : QJsonObject();
}

double at(const QJsonValue& pair, int i) {
    return pair[i].toDouble();
}

} // namespace

class TestCommandPhysics : public QObject {
    Q_OBJECT

private slots:
    void equalMassesPartAtNinetyDegrees() {
        const QJsonValue c = jsonOf({"run", "right-angle", "--json"})["collisions"][0];
        const QJsonValue a = c["after"]["first"], b = c["after"]["second"];
        const double dot = at(a, 0) * at(b, 0) + at(a, 1) * at(b, 1);
        const double lengths = std::hypot(at(a, 0), at(a, 1)) * std::hypot(at(b, 0), at(b, 1));
        QVERIFY(lengths > 0.1);
        QVERIFY(std::abs(std::acos(dot / lengths) - std::numbers::pi / 2) < 1e-12);
    }

    void headOnFollowsTheFormula() {
        // Equal masses, e = 1: they exchange 1.0 and -0.5. Centres 1.2 apart, reach 0.2, closing at 1.5.
        const QJsonObject o = jsonOf({"run", "head-on", "--json"});
        QCOMPARE(o["collision_count"].toInt(), 1);
        const QJsonValue c = o["collisions"][0];
        QVERIFY(std::abs(c["time"].toDouble() - 1.0 / 1.5) < 1e-14);
        QVERIFY(std::abs(at(c["after"]["first"], 0) + 0.5) < 1e-14);
        QVERIFY(std::abs(at(c["after"]["second"], 0) - 1.0) < 1e-14);
        QVERIFY(std::abs(c["impulse"].toDouble() - 1.5) < 1e-14);
        QCOMPARE(o["end"]["reason"].toString(), QString("no more collisions"));
    }

    void unequalMassesFollowTheFormula() {
        const double ma = 3, mb = 0.7, e = 0.6, v = 2;
        Scene scene = *builtinScene("head-on");
        scene.restitution = e;
        scene.bodies[0].mass = ma;
        scene.bodies[1].mass = mb;
        scene.bodies[0].velocity = {v, 0};
        scene.bodies[1].velocity = {0, 0};
        const Outcome o = call({"run", "-", "--json"}, writeScene(scene));
        const QJsonValue c = QJsonDocument::fromJson(o.out)["collisions"][0];
        QVERIFY(std::abs(at(c["after"]["first"], 0) - (ma - e * mb) * v / (ma + mb)) < 1e-14);
        QVERIFY(std::abs(at(c["after"]["second"], 0) - (1 + e) * ma * v / (ma + mb)) < 1e-14);
        const double reduced = ma * mb / (ma + mb);
        QVERIFY(std::abs(c["energy_loss"].toDouble() - reduced * (1 - e * e) * v * v / 2) < 1e-13);
    }

    void momentumIsKept() {
        for (const char* name : {"heavy-light", "light-heavy", "glancing", "inelastic", "cradle", "rack"}) {
            const QJsonObject o = jsonOf({"run", name, "--json"});
            QVERIFY2(o["collision_count"].toInt() > 0, name);
            const QJsonValue start = o["totals"]["start"], end = o["totals"]["end"];
            for (int i = 0; i < 2; ++i)
                QVERIFY2(std::abs(at(start["momentum"], i) - at(end["momentum"], i)) < 1e-12, name);
            double lost = 0;
            for (const QJsonValue& c : o["collisions"].toArray())
                lost += c["energy_loss"].toDouble();
            const double change = start["energy"].toDouble() - end["energy"].toDouble();
            QVERIFY2(std::abs(change - lost) < 1e-10, name);
        }
    }

    void throwTellsWhatWasAsked() {
        const QJsonObject o = jsonOf({"throw", "--mass", "7", "--speed", "7.5", "--direction", "4",
                                      "--position", "-0.3", "--spin", "300", "--axis", "45", "--json"});
        const QJsonObject expected{{"mass", 7},        {"speed", 7.5}, {"direction", 4},
                                   {"position", -0.3}, {"spin", 300},  {"axis", 45}};
        QCOMPARE(o["throw"].toObject(), expected);
        QCOMPARE(o["format"].toString(), QString("thetalane-run"));
        QVERIFY(o.contains("departures"));
        int before = 0;
        for (const QJsonValue& pin : o["pins_down"].toArray()) {
            QVERIFY(pin.toInt() > before && pin.toInt() <= 10);
            before = pin.toInt();
        }
        QVERIFY(before > 0);
    }

    // 6.5° to the left: a sliding ball ends on v₀ - β/(1 + β) u₀, whatever the oil.
    void spinHooks() {
        const auto headingAtTheFirstPin = [](const char* spin) {
            const QJsonObject o = jsonOf({"throw", "--direction", "4", "--position", "-0.3", "--spin", spin,
                                          "--axis", "45", "--json"});
            const QJsonArray v = o["collisions"][0]["before"]["first"].toArray();
            return std::atan2(v[0].toDouble(), v[1].toDouble()) * 180 / std::numbers::pi;
        };
        QVERIFY(headingAtTheFirstPin("300") < -1);
        QVERIFY(headingAtTheFirstPin("150") < 2);
    }

    void aGutterBallTouchesNothing() {
        const QJsonObject o = jsonOf({"throw", "--direction", "10", "--position", "0.5", "--json"});
        QCOMPARE(o["collision_count"].toInt(-1), 0);
        QVERIFY(o["pins_down"].isArray() && o["pins_down"].toArray().isEmpty());
        QCOMPARE(o["departures"][0]["place"].toString(), QString("gutter"));
    }
};

QTEST_APPLESS_MAIN(TestCommandPhysics)
#include "test_command_physics.moc"

// Scene files: every fault named by its place, nothing crashes, and numbers come back to the last
// bit.
#include "core/format/json_strict.h"
#include "core/format/nearest.h"
#include "core/format/scene_file.h"
#include "core/scene/builtin.h"

#include <QElapsedTimer>
#include <QTest>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace thetalane;
using Code = SceneErrorCode;

namespace {

const QByteArray good = R"({
  "format": "thetalane-scene", "version": 1,
  "title": {"en": "Two balls", "ko": "두 공"},
  "restitution": 1.0,
  "bodies": [
    {"id": "A", "kind": "ball", "mass": 2.0, "radius": 0.10, "position": [-0.5, 0.0], "velocity": [1.0, 0.2]},
    {"id": "B", "kind": "pin", "mass": 1.0, "radius": 0.08, "position": [0.4, 0.05], "velocity": [0.0, 0.0]}
  ],
  "frame": {"left": -1.0, "right": 1.0, "bottom": -0.6, "top": 0.6, "restitution": 0.9}
})";

const QByteArray laneMember =
    R"("lane": {"left": -2, "right": 2, "foul_line": -1, "end": 2, "gutter_width": 0.2, "pit_depth": 0.5})";

const QByteArray frictionMember =
    R"("friction": {"ball": 0.2, "rolling": 0.01, "pin": 0.4, "gravity": 1.62,
    "oil": [{"from": -1, "to": 0, "friction": 0.04}, {"from": 0.5, "to": 1, "friction": 0.1}]})";

// Qt's JSON reader takes -0.0 for 0; every other double must come back to the bit.
bool sameBits(double a, double b) {
    return (a == 0 && b == 0) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameBits(const Vec2d& a, const Vec2d& b) {
    return sameBits(a.x, b.x) && sameBits(a.y, b.y);
}

std::vector<SceneError> errorsOf(const QByteArray& json) {
    const auto result = readScene(json);
    const auto* errors = std::get_if<std::vector<SceneError>>(&result);
    return errors ? *errors : std::vector<SceneError>{};
}

} // namespace

class TestFormat : public QObject {
    Q_OBJECT

private slots:
    void goodFileIsRead() {
        const auto result = readScene(good);
        QVERIFY(std::holds_alternative<Scene>(result));
        const Scene& scene = std::get<Scene>(result);
        QCOMPARE(scene.title.ko, std::string("두 공"));
        QCOMPARE(scene.restitution, 1.0);
        QCOMPARE(scene.bodies.size(), std::size_t(2));
        const Body expected{"B", BodyKind::Pin, 1.0, 0.08, {0.4, 0.05}, {0, 0}};
        QVERIFY(scene.bodies[1] == expected);
        QVERIFY((scene.frame == Frame{-1.0, 1.0, -0.6, 0.6, 0.9}));
        QVERIFY(!scene.lane);
    }

    void faults_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("other");
        const auto row = [](const char* name, const QByteArray& json, Code code, const char* path,
                            const char* other = "") {
            QTest::newRow(name) << json << int(code) << path << other;
        };
        // The good file with one thing changed.
        const auto changed = [&row](const char* name, const char* from, const char* to, Code code,
                                    const char* path, const char* other = "") {
            QByteArray json = good;
            const auto at = json.indexOf(from);
            Q_ASSERT(at >= 0);
            row(name, json.replace(at, qsizetype(strlen(from)), to), code, path, other);
        };
        notJsonRows(row, changed);
        keyRows(changed);
        typeRows(row, changed);
        valueRows(changed);
        const auto added = [&changed](const char* name, const QByteArray& member, Code code, const char* path,
                                      const char* other = "") {
            changed(name, "\"frame\"", (member + ", \"frame\"").constData(), code, path, other);
        };
        frictionRows(added);
        laneRows(changed, added);
    }

    void faults() {
        QFETCH(QByteArray, json);
        QFETCH(int, code);
        QFETCH(QString, path);
        QFETCH(QString, other);
        const auto errors = errorsOf(json);
        QVERIFY(!errors.empty());
        QCOMPARE(QString::fromStdString(errors[0].path), path);
        QCOMPARE(int(errors[0].code), code);
        if (!other.isEmpty())
            QCOMPARE(QString::fromStdString(errors[0].other), other);
    }

    void everyFaultIsToldInTheOrderOfTheFile() {
        const auto errors = errorsOf(R"({"format": "thetalane-scene", "version": 1,
            "bodies": [{"kind": "cube", "mass": -3, "colour": 1, "id": "A", "radius": "wide",
                        "velocity": [0, 0]}, 7],
            "zoom": 2, "restitution": 4, "frame": {"left": null}})");
        QStringList paths;
        for (const SceneError& e : errors)
            paths << QString::fromStdString(e.path);
        const QStringList expected{
            "bodies[0].position", "bodies[0].kind", "bodies[0].mass", "bodies[0].colour", "bodies[0].radius",
            "bodies[1]",          "zoom",           "restitution",    "frame.left"};
        QCOMPARE(paths, expected);
    }

    void everythingOfALaneIsRead() {
        QByteArray json = good;
        json.replace("\"velocity\": [1.0, 0.2]",
                     "\"velocity\": [1.0, 0.2], \"spin\": [-3, 4.5, 1e-3], \"inertia\": 0.37");
        json.replace("\"frame\"", withKickbacks("{\"from\": 1.5, \"restitution\": 0.5}") + ", " +
                                      frictionMember + ", \"frame\"");
        const auto result = readScene(json);
        QVERIFY(std::holds_alternative<Scene>(result));
        const Scene& scene = std::get<Scene>(result);
        QVERIFY((scene.bodies[0].spin == Spin<double>{-3, 4.5, 1e-3}));
        QCOMPARE(scene.bodies[0].inertia, 0.37);
        QVERIFY(scene.bodies[1].spin == Spin<double>{});
        QCOMPARE(scene.bodies[1].inertia, 0.4);
        QVERIFY((scene.lane->kickbacks == Kickbacks{1.5, 0.5}));
        const Friction expected{0.2, 0.01, 0.4, 1.62, {{-1, 0, 0.04}, {0.5, 1, 0.1}}};
        QVERIFY(scene.friction == expected);
        QVERIFY(std::get<Scene>(readScene(writeScene(scene))) == scene);
    }

    void theWriterLeavesDefaultsOut() {
        Scene scene = std::get<Scene>(readScene(good));
        scene.friction = Friction{};
        scene.friction->ball = 0.25;
        QByteArray text = writeScene(scene);
        QVERIFY(text.contains("\"friction\": {\"ball\": 0.25}\n"));
        for (const char* key : {"spin", "inertia", "rolling", "pin\":", "gravity", "oil", "kickbacks"})
            QVERIFY2(!text.contains(key), key);
        QVERIFY(std::get<Scene>(readScene(text)) == scene);
        scene.friction.reset();
        QVERIFY(!writeScene(scene).contains("friction"));
        // One thing that is not as usual, alone.
        const auto only = [](auto&& change, const char* key) {
            Scene s = std::get<Scene>(readScene(good));
            s.friction = Friction{};
            change(s);
            const QByteArray written = writeScene(s);
            return written.contains(key) && std::get<Scene>(readScene(written)) == s;
        };
        QVERIFY(only([](Scene& s) { s.bodies[1].spin.z = -1e-300; }, "\"spin\": [0, 0, -1e-300]"));
        QVERIFY(only([](Scene& s) { s.bodies[1].inertia = 0.41; }, "\"inertia\": 0.41"));
        QVERIFY(only([](Scene& s) { s.friction->rolling = 0.01; }, "\"rolling\": 0.01"));
        QVERIFY(only([](Scene& s) { s.friction->pin = 0.4; }, "\"pin\": 0.4"));
        QVERIFY(only([](Scene& s) { s.friction->gravity = 9.8; }, "\"gravity\": 9.8"));
        QVERIFY(only([](Scene& s) { s.friction->oil = {{-1, 1, 0}}; }, "\"oil\": ["));
    }

    void byteOrderMarksAreRead() { QVERIFY(std::holds_alternative<Scene>(readScene("\xef\xbb\xbf" + good))); }

    void openSidesAndDefaults() {
        QByteArray json = good;
        json.replace(R"("left": -1.0, "right": 1.0, "bottom": -0.6, "top": 0.6, "restitution": 0.9)",
                     R"("top": 0.6)");
        const Scene scene = std::get<Scene>(readScene(json));
        QVERIFY(!scene.frame->left && !scene.frame->right && !scene.frame->bottom);
        QCOMPARE(*scene.frame->top, 0.6);
        QCOMPARE(scene.frame->restitution, 1.0);
    }

    void truncationsNeverCrash() {
        for (qsizetype n = 0; n < good.size(); ++n)
            QVERIFY2(!errorsOf(good.left(n)).empty(), qPrintable(QString::number(n)));
    }

    void randomBytesNeverCrash() {
        std::mt19937 random(7);
        for (int trial = 0; trial < 20'000; ++trial) {
            QByteArray json = good;
            for (int flips = 1 + int(random() % 3); flips > 0; --flips)
                json[qsizetype(random() % std::size_t(json.size()))] = char(random() % 256);
            const auto result = readScene(json);
            if (const auto* scene = std::get_if<Scene>(&result))
                QVERIFY(validate(*scene).empty());
            else
                QVERIFY(!std::get<std::vector<SceneError>>(result).empty());
        }
    }

    void structuralNoiseNeverCrashes() {
        const QByteArray alphabet = "{}[],:\"\\ue1-.0n ";
        std::mt19937 random(11);
        for (int trial = 0; trial < 20'000; ++trial) {
            QByteArray json;
            for (std::size_t n = random() % 40; n > 0; --n)
                json += alphabet[qsizetype(random() % std::size_t(alphabet.size()))];
            QVERIFY(!errorsOf(json).empty());
        }
    }

    void largeInputsEndSoon() {
        QElapsedTimer clock;
        clock.start();
        QVERIFY(!errorsOf(QByteArray(5'000'000, '[')).empty());
        QVERIFY(!errorsOf(QByteArray(5'000'000, '\0')).empty());
        QVERIFY(!errorsOf(QByteArray("{\"a\":").repeated(1'000'000)).empty());
        QByteArray keys = "{";
        for (int i = 0; i < 200'000; ++i)
            keys += "\"k" + QByteArray::number(i) + "\":0,";
        keys.back() = '}';
        QVERIFY(errorsOf(keys).size() >= 1000); // each is unknown; the reader has had enough at some point
        QCOMPARE(errorsOf("{\"" + QByteArray(1'000'000, 'x') + "\": 1}").size(), std::size_t(5));
        QByteArray crowd = R"({"format": "thetalane-scene", "version": 1, "restitution": 1, "bodies": [)";
        crowd += QByteArray("{},").repeated(100'001);
        crowd.chop(1);
        QCOMPARE(errorsOf(crowd + "]}").size(), std::size_t(1));
        QCOMPARE(errorsOf(crowd + "]}")[0].code, Code::TooManyBodies);
        QVERIFY2(clock.elapsed() < 20'000, qPrintable(QString::number(clock.elapsed())));
    }

    void mostBodiesGoRound() {
        Scene scene;
        for (int i = 0; i < int(maxBodies); ++i)
            scene.bodies.push_back({std::to_string(i),
                                    BodyKind::Ball,
                                    1,
                                    0.1,
                                    {0.3 * (i % 317), 0.3 * (i / 317)},
                                    {0.1 * i, -0.7}});
        QVERIFY(std::get<Scene>(readScene(writeScene(scene))) == scene);
    }

    void builtinScenesGoRound() {
        for (const BuiltinScene& entry : builtinScenes()) {
            const Scene scene = entry.make();
            const QByteArray text = writeScene(scene);
            const auto back = readScene(text);
            QVERIFY2(std::holds_alternative<Scene>(back), entry.id.data());
            QVERIFY2(std::get<Scene>(back) == scene, entry.id.data());
            QCOMPARE(writeScene(std::get<Scene>(back)), text);
            QCOMPARE(text.contains("\"frame\""), scene.frame.has_value());
            QCOMPARE(text.contains("\"lane\""), scene.lane.has_value());
            QCOMPARE(text.contains("\"friction\""), scene.friction.has_value());
        }
    }

    void everyBitOfANumberGoesRound() {
        std::mt19937_64 random(3);
        for (int trial = 0; trial < 20'000; ++trial) {
            const auto number = [&random] {
                for (;;)
                    if (const double v = std::bit_cast<double>(random()); std::isfinite(v))
                        return v;
            };
            Scene scene;
            scene.bodies = {{"A",
                             BodyKind::Pin,
                             std::abs(number()),
                             std::abs(number()),
                             {number(), number()},
                             {number(), -0.0},
                             {number(), number(), number()}}};
            scene.friction = Friction{std::abs(std::remainder(number(), 10)), 0, 0, std::abs(number()), {}};
            const Scene back = std::get<Scene>(readScene(writeScene(scene)));
            QVERIFY(sameBits(back.bodies[0].mass, scene.bodies[0].mass));
            QVERIFY(sameBits(back.bodies[0].radius, scene.bodies[0].radius));
            QVERIFY(sameBits(back.bodies[0].position, scene.bodies[0].position));
            QVERIFY(sameBits(back.bodies[0].velocity, scene.bodies[0].velocity));
            QVERIFY(sameBits(back.bodies[0].spin.x, scene.bodies[0].spin.x));
            QVERIFY(sameBits(back.bodies[0].spin.y, scene.bodies[0].spin.y));
            QVERIFY(sameBits(back.bodies[0].spin.z, scene.bodies[0].spin.z));
            QVERIFY(sameBits(back.friction->ball, scene.friction->ball));
            QVERIFY(sameBits(back.friction->gravity, scene.friction->gravity));
        }
    }

    void awkwardTextGoesRound() {
        Scene scene;
        scene.title = {"a \"quoted\" \\ title\n\t", "제목 \u2028 🎳"};
        scene.bodies = {{"공 \"하나\"\n", BodyKind::Ball, 1, 0.1, {0, 0}, {}},
                        {std::string("nul\0inside", 10), BodyKind::Ball, 1, 0.1, {1, 0}, {}}};
        QVERIFY(std::get<Scene>(readScene(writeScene(scene))) == scene);
    }

    void nearestKnowsSlips() {
        constexpr std::string_view known[] = {"mass", "radius", "position"};
        QCOMPARE(nearest("mas", known), std::string("mass"));
        QCOMPARE(nearest("raduis", known), std::string("radius"));
        QCOMPARE(nearest("Mass", known), std::string("mass"));
        QCOMPARE(nearest("colour", known), std::string());
        QCOMPARE(nearest("", known), std::string());
    }

private:
    static QByteArray withKickbacks(const QByteArray& kickbacks) {
        QByteArray lane = laneMember;
        return lane.insert(lane.size() - 1, ", \"kickbacks\": " + kickbacks);
    }

    // The friction of the good file with one thing changed.
    template <class Added> static void frictionRows(const Added& added) {
        const auto changed = [&added](const char* from, const char* to, Code code, const char* path,
                                      const char* other = "") {
            QByteArray member = frictionMember;
            Q_ASSERT(member.contains(from));
            member.replace(from, to);
            added((QByteArray("friction: ") + to).constData(), member, code, path, other);
        };
        const auto whole = [&added](const char* value, Code code, const char* path) {
            added((QByteArray("friction ") + value).constData(), QByteArray("\"friction\": ") + value, code,
                  path);
        };
        whole("0.2", Code::WrongType, "friction");
        whole("null", Code::WrongType, "friction");
        whole("{}", Code::MissingKey, "friction.ball");
        whole("{\"bal\": 0.2}", Code::UnknownKey, "friction.bal");
        changed("\"rolling\"", "\"roling\"", Code::UnknownKey, "friction.roling", "rolling");
        changed("\"gravity\"", "\"weight\"", Code::UnknownKey, "friction.weight");
        changed("\"oil\"", "\"oill\"", Code::UnknownKey, "friction.oill", "oil");
        changed("\"friction\": 0.04", "\"fricton\": 0.04", Code::UnknownKey, "friction.oil[0].fricton",
                "friction");
        changed("\"to\": 1, ", "", Code::MissingKey, "friction.oil[1].to");
        changed("\"ball\": 0.2", "\"ball\": \"0.2\"", Code::WrongType, "friction.ball");
        changed("1.62", "[1.62]", Code::WrongType, "friction.gravity");
        changed("{\"from\": -1, \"to\": 0, \"friction\": 0.04}", "7", Code::NotAnObject, "friction.oil[0]");
        changed("\"from\": -1", "\"from\": null", Code::WrongType, "friction.oil[0].from");
        changed("\"ball\": 0.2", "\"ball\": -0.2", Code::OutOfRange, "friction.ball");
        changed("\"pin\": 0.4", "\"pin\": 40", Code::OutOfRange, "friction.pin");
        changed("1.62", "0", Code::NotPositive, "friction.gravity");
        changed("\"to\": 0,", "\"to\": -2,", Code::OilReversed, "friction.oil[0].to");
        changed("\"from\": 0.5", "\"from\": -0.5", Code::OilOverlap, "friction.oil[1].from",
                "friction.oil[0]");
        changed("0.1}", "11}", Code::OutOfRange, "friction.oil[1].friction");
        added("oil an object", "\"friction\": {\"ball\": 0, \"oil\": {}}", Code::WrongType, "friction.oil");
    }

    template <class Changed, class Added> static void laneRows(const Changed& changed, const Added& added) {
        const auto body = [&changed](const char* member, Code code, const char* path,
                                     const char* other = "") {
            changed(member, "\"mass\": 1.0", (QByteArray(member) + ", \"mass\": 1.0").constData(), code, path,
                    other);
        };
        body("\"spin\": [1, 2]", Code::WrongType, "bodies[1].spin");
        body("\"spin\": [1, 2, 3, 4]", Code::WrongType, "bodies[1].spin");
        body("\"spin\": 3", Code::WrongType, "bodies[1].spin");
        body("\"spin\": [1, 2, \"3\"]", Code::WrongType, "bodies[1].spin[2]");
        body("\"spn\": [1, 2, 3]", Code::UnknownKey, "bodies[1].spn", "spin");
        body("\"inertia\": {}", Code::WrongType, "bodies[1].inertia");
        body("\"inertia\": 0", Code::OutOfOpenRange, "bodies[1].inertia");
        body("\"inertia\": 1.1", Code::OutOfOpenRange, "bodies[1].inertia");
        const auto kickbacks = [&added](const char* value, Code code, const char* path,
                                        const char* other = "") {
            added((QByteArray("kickbacks ") + value).constData(), withKickbacks(value), code, path, other);
        };
        kickbacks("[]", Code::WrongType, "lane.kickbacks");
        kickbacks("{\"from\": 1}", Code::MissingKey, "lane.kickbacks.restitution");
        kickbacks("{\"form\": 1, \"restitution\": 0.5}", Code::UnknownKey, "lane.kickbacks.form", "from");
        kickbacks("{\"from\": \"1\", \"restitution\": 0.5}", Code::WrongType, "lane.kickbacks.from");
        kickbacks("{\"from\": 1, \"restitution\": 1.5}", Code::OutOfRange, "lane.kickbacks.restitution");
        kickbacks("{\"from\": 2.1, \"restitution\": 0.5}", Code::KickbacksOffTheLane, "lane.kickbacks.from");
    }

    template <class Row, class Changed> static void notJsonRows(const Row& row, const Changed& changed) {
        row("empty", "", Code::NotJson, "line 1, column 1", emptyFileReason);
        row("blank", " \n\n ", Code::NotJson, "line 1, column 1", emptyFileReason);
        row("binary",
            QByteArray("\x7f"
                       "ELF\x02\x01\x01\0\0\0\xff\xfe",
                       12),
            Code::NotJson, "line 1, column 2");
        row("a list", "[]", Code::NotAnObject, "");
        row("nested too deeply", QByteArray(3000, '['), Code::NotJson, "line 1, column 1026");
        changed("cut", "\"restitution\": 0.9}\n}", "", Code::NotJson, "line 9, column 69");
        changed("not a number", "2.0", "NaN", Code::NotJson, "line 6, column 41");
        changed("infinite", "2.0", "Infinity", Code::NotJson, "line 6, column 41");
        changed("beyond double", "2.0", "1e400", Code::NotJson, "line 6, column 41");
        changed("trailing text", "0.9}\n}", "0.9}\n} x", Code::NotJson, "line 10, column 3");
        changed("comma lost", "\"A\",", "\"A\"", Code::NotJson, "line 6, column 16", missingCommaReason);
        changed("comma lost in a list", "-0.5, 0.0", "-0.5 0.0", Code::NotJson, "line 6, column 80",
                missingCommaReason);
        changed("colon lost", "\"id\": \"A\"", "\"id\" \"A\"", Code::NotJson, "line 6, column 11",
                "missing name separator");
        changed("point without a digit after", "2.0", "2.", Code::NotJson, "line 6, column 41",
                bareNumberReason);
        changed("point without a digit before", "0.05", ".05", Code::NotJson, "line 7, column 79",
                bareNumberReason);
        changed("point without a digit before, negative", "-0.5", "-.5", Code::NotJson, "line 6, column 75",
                bareNumberReason);
        changed("point before an exponent", "2.0", "2.e3", Code::NotJson, "line 6, column 41",
                bareNumberReason);
        changed("a line break in a text", "Two balls", "Two\nballs", Code::NotJson, "line 3, column 23",
                rawControlReason);
        changed("an escape that is none", "Two balls", "Two\\balls \\q", Code::NotJson, "line 3, column 30",
                unknownEscapeReason);
        changed("key twice", "\"radius\"", "\"mass\": 3, \"radius\"", Code::NotJson, "bodies[0].mass",
                duplicateKeyReason);
        changed("key twice, escaped", "\"radius\"", "\"m\\u0061ss\": 3, \"radius\"", Code::NotJson,
                "bodies[0].mass", duplicateKeyReason);
        changed("bodies twice", "\"frame\"", "\"bodies\": [], \"frame\"", Code::NotJson, "bodies",
                duplicateKeyReason);
    }

    template <class Changed> static void keyRows(const Changed& changed) {
        changed("format missing", "\"format\": \"thetalane-scene\", ", "", Code::MissingKey, "format");
        changed("format other", "thetalane-scene", "thetalane-run", Code::WrongFormat, "format",
                "thetalane-run");
        changed("version missing", ", \"version\": 1", "", Code::MissingKey, "version");
        changed("version later", "\"version\": 1", "\"version\": 2", Code::WrongVersion, "version");
        changed("restitution missing", "\"restitution\": 1.0,", "", Code::MissingKey, "restitution");
        changed("id missing", "\"id\": \"B\", ", "", Code::MissingKey, "bodies[1].id");
        changed("kind missing", "\"kind\": \"pin\", ", "", Code::MissingKey, "bodies[1].kind");
        changed("mass missing", "\"mass\": 1.0, ", "", Code::MissingKey, "bodies[1].mass");
        changed("radius missing", "\"radius\": 0.08, ", "", Code::MissingKey, "bodies[1].radius");
        changed("velocity missing", ", \"velocity\": [0.0, 0.0]", "", Code::MissingKey, "bodies[1].velocity");
        changed("unknown at the top", "\"frame\"", "\"zzz\": 1, \"frame\"", Code::UnknownKey, "zzz");
        changed("misspelt", "\"restitution\": 1.0", "\"restitutoin\": 1.0, \"restitution\": 1.0",
                Code::UnknownKey, "restitutoin", "restitution");
        changed("misspelt for a required one", "\"mass\": 1.0", "\"mas\": -3", Code::UnknownKey,
                "bodies[1].mas", "mass");
        changed("misspelt in a body", "\"mass\": 1.0", "\"mas\": 1.0, \"mass\": 1.0", Code::UnknownKey,
                "bodies[1].mas", "mass");
        changed("unknown in the title", "\"ko\"", "\"kr\": \"\", \"ko\"", Code::UnknownKey, "title.kr");
        changed("unknown in the frame", "\"left\"", "\"lefft\": 0, \"left\"", Code::UnknownKey, "frame.lefft",
                "left");
    }

    template <class Row, class Changed> static void typeRows(const Row& row, const Changed& changed) {
        row("bodies missing", R"({"format": "thetalane-scene", "version": 1, "restitution": 1})",
            Code::MissingKey, "bodies");
        row("no bodies", R"({"format": "thetalane-scene", "version": 1, "restitution": 1, "bodies": []})",
            Code::NoBodies, "bodies");
        row("bodies an object",
            R"({"format": "thetalane-scene", "version": 1, "restitution": 1, "bodies": {}})", Code::WrongType,
            "bodies");
        changed("version a text", "\"version\": 1", "\"version\": \"1\"", Code::WrongType, "version");
        changed("format a number", "\"thetalane-scene\"", "3", Code::WrongType, "format");
        changed("mass a text", "\"mass\": 2.0", "\"mass\": \"2\"", Code::WrongType, "bodies[0].mass");
        changed("mass null", "\"mass\": 2.0", "\"mass\": null", Code::WrongType, "bodies[0].mass");
        changed("id a number", "\"id\": \"A\"", "\"id\": 1", Code::WrongType, "bodies[0].id");
        changed("kind unknown", "\"ball\"", "\"cube\"", Code::WrongType, "bodies[0].kind");
        changed("position of three", "[-0.5, 0.0]", "[-0.5, 0.0, 0]", Code::WrongType, "bodies[0].position");
        changed("position a number", "[-0.5, 0.0]", "1", Code::WrongType, "bodies[0].position");
        changed("position of texts", "[-0.5, 0.0]", "[-0.5, \"0\"]", Code::WrongType,
                "bodies[0].position[1]");
        changed("title a text", R"({"en": "Two balls", "ko": "두 공"})", "\"Two\"", Code::WrongType, "title");
        changed("title of numbers", "\"Two balls\"", "2", Code::WrongType, "title.en");
        changed("frame a list", "\"frame\": {", "\"lane\": [], \"frame\": {", Code::WrongType, "lane");
        changed("wall a text", "\"left\": -1.0", "\"left\": \"-1\"", Code::WrongType, "frame.left");
        changed("lane incomplete", "\"frame\"", "\"lane\": {\"left\": -2}, \"frame\"", Code::MissingKey,
                "lane.right");
    }

    template <class Changed> static void valueRows(const Changed& changed) {
        changed("mass negative", "\"mass\": 1.0", "\"mass\": -3", Code::NotPositive, "bodies[1].mass");
        changed("mass underflows", "\"mass\": 1.0", "\"mass\": 0e5", Code::NotPositive, "bodies[1].mass");
        changed("radius zero", "0.08", "0", Code::NotPositive, "bodies[1].radius");
        changed("restitution", "\"restitution\": 1.0", "\"restitution\": 1.5", Code::OutOfRange,
                "restitution");
        changed("wall restitution", "0.9", "-0.1", Code::OutOfRange, "frame.restitution");
        changed("id taken", "\"B\"", "\"A\"", Code::DuplicateId, "bodies[1].id", "A");
        changed("id of a wall", "\"B\"", "\"wall:B\"", Code::ReservedId, "bodies[1].id", "wall:B");
        changed("id empty", "\"B\"", "\"\"", Code::EmptyId, "bodies[1].id");
        changed("overlap", "[0.4, 0.05]", "[-0.35, 0]", Code::Overlap, "bodies[1].position", "B");
        changed("beyond a wall", "[0.4, 0.05]", "[0.4, 0.6]", Code::OverlapsWall, "bodies[1].position",
                "top");
        changed("walls crossed", "\"right\": 1.0", "\"right\": -1.0", Code::WallsCrossed, "frame.right");
        changed("off the lane", "\"frame\"",
                QByteArray(QByteArray(laneMember).replace("\"left\": -2", "\"left\": 0") + ", \"frame\"")
                    .constData(),
                Code::OffTheLane, "bodies[0].position");
    }
};

QTEST_APPLESS_MAIN(TestFormat)
#include "test_format.moc"

// The same scene and engine give the same bits on every build type and compiler: a replay is the scene and
// nothing else. A hash that changes means that results changed: look why before writing the new one here.
// (The two hashes of "bowling" rest on the C library's sin and cos of the throw's direction, too.)
#include "core/engine/engine.h"
#include "core/scene/builtin.h"
#include "tests/core/support.h"
#include "tests/core/timeline_hash.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Golden {
    const char* scene;
    std::uint64_t eventDouble, eventFloat, steppedDouble, steppedFloat;
};

constexpr Golden golden[] = {
    {"two-balls", 0x1a21c69f437d2240, 0x6e82bd715bfbabca, 0xba2ae43f7e11adae, 0x4b63c6054dfaa4ca},
    {"head-on", 0xcf2d885564948878, 0xd4046f2f18c223d5, 0x8adbe9c1bd20cfd4, 0x5f69c04d629044af},
    {"right-angle", 0x211262157032705b, 0x72729c3e9e6e1276, 0xa723d8e2321363da, 0x766a06f7b744a31c},
    {"heavy-light", 0x4f007123dd09d785, 0xf4dbf0784e17cba4, 0x5a19ff04c4c432ff, 0x5c30e2d79b065076},
    {"light-heavy", 0x5afa4f1ede523967, 0xa05dc11d89c43bf4, 0x7e9c24bda7e0c0f7, 0xbd69ffc7c344b9c3},
    {"glancing", 0xb57150daa7b16040, 0x75ff83fa04120440, 0x77dfd739e7093f2a, 0x4bbb8c26979fa6d0},
    {"inelastic", 0x71866f4a5953dbea, 0x2a90eb59443e3c0f, 0x7f5d5e9761bd250d, 0x9ce349789b0f5e0a},
    {"cradle", 0xda5de26ce3843801, 0x21f53a15976149b5, 0x63b0bb61212a839a, 0x2c36ecf29bc9256c},
    {"rack", 0x41e7961f3d4f4d0c, 0x8e6d0e1515b95a8f, 0xcea77120ab24b801, 0x92ddd62bd2364f0a},
    {"bowling", 0xbbeba91e75185003, 0x7031fcc3e4df8031, 0xf5015f327792572d, 0xf2725dfde114fdc1},
    {"break", 0x584e4f2b9de85335, 0xf70db0c22c3a16a7, 0xa6ee1ff0acb9a550, 0x96700a8c4b9d51d1},
    {"pi-4", 0xd8ad42e515bb7105, 0xdab332d3cb6a5a1c, 0x9d23d5fc67066a4d, 0x9424ad7bcb28a822},
    {"gas-100", 0xd88a1017ded83233, 0x5e8659541e46191c, 0xc5a9bb0d116765de, 0x44be3e7d35264cb5},
    {"gas-1000", 0x6938c2fcff29a485, 0x9956a425c718950f, 0xc7d3add23059a3ec, 0x56857b4b9d4ab37f},
    {"gas-10000", 0x56a81f1612ebd6b4, 0xe8d20e845dd67b94, 0xc3942aa2c0f43726, 0x64a06a2bd476a39a},
};

} // namespace

class TestDeterminism : public QObject {
    Q_OBJECT

private slots:
    void goldenHashes_data() {
        QTest::addColumn<QString>("id");
        for (const BuiltinScene& b : builtinScenes())
            QTest::newRow(b.id.data()) << QString::fromUtf8(b.id.data());
    }
    void goldenHashes() {
        QFETCH(QString, id);
        const Scene scene = *builtinScene(id.toStdString());
        // A crowd for a while, a few hundred collisions to a few thousand.
        const double until = scene.bodies.size() < 50 ? 5 : 0.2 / std::sqrt(double(scene.bodies.size()));
        const double step = scene.bodies.size() < 50 ? 1.0 / 60 : until / 10;
        const std::uint64_t got[] = {hashOf(runOf(scene, eventSettings(until))),
                                     hashOf(runOf(scene, eventSettings(until, Precision::Float))),
                                     hashOf(runOf(scene, steppedSettings(until, step))),
                                     hashOf(runOf(scene, steppedSettings(until, step, Precision::Float)))};
        const QString line = QString("{\"%1\", 0x%2, 0x%3, 0x%4, 0x%5},")
                                 .arg(id)
                                 .arg(got[0], 16, 16, QChar('0'))
                                 .arg(got[1], 16, 16, QChar('0'))
                                 .arg(got[2], 16, 16, QChar('0'))
                                 .arg(got[3], 16, 16, QChar('0'));
        for (const Golden& g : golden) {
            if (id != g.scene)
                continue;
            const bool same = got[0] == g.eventDouble && got[1] == g.eventFloat &&
                              got[2] == g.steppedDouble && got[3] == g.steppedFloat;
            QVERIFY2(same, qPrintable("these bits are new: " + line));
            return;
        }
        QFAIL(qPrintable("no golden hash: " + line));
    }

    // What runs before, and how often, leaves no trace.
    void noStateIsKeptBetweenRuns() {
        const Scene scene = *builtinScene("rack");
        const std::uint64_t once = hashOf(runOf(scene, eventSettings(5)));
        for (const BuiltinScene& b : builtinScenes())
            runOf(b.make(), eventSettings(0.1));
        QCOMPARE(hashOf(runOf(scene, eventSettings(5))), once);
    }
};

QTEST_GUILESS_MAIN(TestDeterminism)
#include "test_determinism.moc"

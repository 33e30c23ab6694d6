// Ten minutes of a gas of 1,000 in the window, off screen: how large the process gets, how long the window
// stands still while they are computed, and how long any moment takes until it is painted. Then frames of a
// break and of a throw, and aiming one.
//   QT_QPA_PLATFORM=offscreen bin/thetalane_window_bench [--quick] [--throw] [--map] [--pictures DIR]
// --throw: only frames and aiming. --map: only how the window answers while the strike map is computed.
#include "tests/benchmarks/waits.h"
#include "tests/benchmarks/window_map.h"
#include "tests/benchmarks/window_throw.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QStyleFactory>
#include <QThread>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>
#include <vector>

using namespace thetalane;
using namespace thetalane::benchmarks;

namespace {

// Of this process: the largest its memory ever was.
double peakMegabytes() {
    QFile status("/proc/self/status");
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmHWM:"))
            return line.mid(6).trimmed().split(' ').first().toDouble() / 1024;
    return 0;
}

struct Program {
    Language language;
    Session session;
    Appearance appearance;
    Playhead playhead{session};
    MainWindow window{Context{session, playhead, appearance}, language};
};

double threadTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

// The longest that the window did not answer until `done`, and the most that its own thread worked at one go.
template <class Done> Wait longestStall(Done&& done) {
    Wait longest;
    while (!done()) {
        QElapsedTimer clock;
        clock.start();
        const double before = threadTime();
        QCoreApplication::processEvents();
        longest.work = std::max(longest.work, threadTime() - before);
        longest.wall = std::max(longest.wall, double(clock.nsecsElapsed()) * 1e-9);
        QThread::usleep(500);
    }
    return longest;
}

void paint(Program& p) {
    QCoreApplication::processEvents();
    p.window.repaint();
}

// From the wish until every view knows, and until it is painted.
struct Seeks {
    std::vector<Wait> known, painted;
};
Seeks seeks(Program& p, double until, int count) {
    std::mt19937_64 random(1);
    Seeks waits;
    for (int k = 0; k < count; ++k) {
        const double t = until * double(random() >> 11) * 0x1p-53;
        waits.painted.push_back(waited([&] {
            waits.known.push_back(waited([&] {
                p.playhead.setTime(t);
                while (p.playhead.time() != t) // the window goes on meanwhile
                    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            }));
            paint(p);
        }));
    }
    return waits;
}

// Frames while it plays over a few borders of chapters.
std::vector<Wait> frames(Program& p, int count) {
    std::vector<Wait> waits;
    p.playhead.setPlaying(true);
    for (int k = 0; k < count; ++k)
        waits.push_back(waited([&] {
            p.playhead.advance(1.0 / 60);
            paint(p);
        }));
    p.playhead.setPlaying(false);
    return waits;
}

void pictures(Program& p, const QString& directory) {
    constexpr std::int64_t number = 3'000'000;
    p.playhead.selectNumber(number);
    while (p.playhead.selectedNumber() != number && number <= p.session.part().collisionCount)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    for (const auto& [code, name] :
         {std::pair{Language::Code::English, "en"}, {Language::Code::Korean, "ko"}})
        for (const bool projector : {false, true}) {
            p.language.use(code);
            p.appearance.setProjector(projector);
            QCoreApplication::processEvents();
            p.window.grab().save(QDir(directory).filePath(
                QString("gas-1000-%1%2.png").arg(name, projector ? "-projector" : "")));
        }
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    const QStringList arguments = QApplication::arguments();
    const bool quick = arguments.contains("--quick");
    if (arguments.contains("--throw")) {
        throwTables(quick);
        return 0;
    }
    if (arguments.contains("--map")) {
        mapTable(quick);
        return 0;
    }
    const double until = quick ? 5 : 600;

    Program p;
    p.language.use(Language::Code::English);
    p.appearance.setReducedMotion(true);
    p.window.show();
    QCoreApplication::processEvents();
    const Wait opened = waited([&] {
        p.session.openBuiltin("gas-1000");
        paint(p);
    });
    p.playhead.runUntil(until);
    paint(p);
    QElapsedTimer clock;
    clock.start();
    const Wait stall = longestStall([&] { return p.session.part().ended; });
    const double computed = double(clock.nsecsElapsed()) * 1e-9;
    const Seeks waits = seeks(p, until, quick ? 5 : 30);
    p.playhead.setTime(until / 2);
    const std::vector<Wait> painted = frames(p, quick ? 10 : 300);

    Table table(
        "**A long run in the window**, off screen: opened, computed to its end, then moments at random, "
        "each until every view knows it and until it is painted; then played over borders of chapters, frame "
        "by frame. In brackets: "
        "processor time, of all threads; of a "
        "stall, of the window's own.",
        {"scene", "simulated", "collisions", "opened in", "computed in", "longest stall meanwhile",
         "a moment, median", "a moment, worst", "painted, median", "painted, worst", "a frame, median",
         "a frame, worst", "peak"});
    table.row({"gas of 1,000", whole(until) + " s", whole(double(p.session.part().collisionCount)),
               text(opened), times(computed) + " s", text(stall), text(quantile(waits.known, 0.5)),
               text(quantile(waits.known, 1)), text(quantile(waits.painted, 0.5)),
               text(quantile(waits.painted, 1)), text(quantile(painted, 0.5)), text(quantile(painted, 1)),
               whole(peakMegabytes()) + " MB"});
    if (const auto at = arguments.indexOf("--pictures"); at > 0 && at + 1 < arguments.size())
        pictures(p, arguments[at + 1]);
    p.window.hide();
    throwTables(quick);
    return 0;
}

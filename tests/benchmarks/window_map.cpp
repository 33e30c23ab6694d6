#include "tests/benchmarks/window_map.h"

#include "tests/benchmarks/waits.h"
#include "ui/map/map_panel.h"
#include "ui/rail/rail.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QComboBox>
#include <QTimer>

#include <ctime>

namespace thetalane::benchmarks {
namespace {

// Of the thread of the window alone [s].
double threadTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

struct Answers {
    double first = 0; // until the first picture is painted [s]
    double all = 0;   // until the whole one is [s]
    Wait gap;         // the longest between two beats; work: of the window's thread, the most between two
    std::vector<double> gaps;
};

// start: asks for the map.
Answers answers(MapPanel& panel, const std::function<void()>& start) {
    Answers result;
    const auto before = panel.map();
    QElapsedTimer clock, beat;
    double work = threadTime();
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    timer.setInterval(1);
    QObject::connect(&timer, &QTimer::timeout, [&] {
        const double gap = double(beat.nsecsElapsed()) * 1e-9, now = threadTime();
        beat.start();
        result.gaps.push_back(gap);
        result.gap.wall = std::max(result.gap.wall, gap);
        result.gap.work = std::max(result.gap.work, now - std::exchange(work, now));
    });
    timer.start();
    clock.start();
    beat.start();
    start();
    while (panel.running() || panel.map() == before || !panel.map()->whole()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (panel.map() == before || result.first > 0)
            continue;
        QCoreApplication::processEvents(); // it is painted
        result.first = double(clock.nsecsElapsed()) * 1e-9;
    }
    QCoreApplication::processEvents();
    result.all = double(clock.nsecsElapsed()) * 1e-9;
    return result;
}

// As by hand: what the program sets itself asks for nothing.
void choose(QComboBox& box, MapScene scene) {
    const int index = box.findData(int(scene));
    box.setCurrentIndex(index);
    emit box.activated(index);
}

void row(Table& table, const std::string& name, std::vector<Answers> rounds) {
    std::vector<double> first, all, gaps;
    Wait longest;
    for (const Answers& a : rounds) {
        first.push_back(a.first);
        all.push_back(a.all);
        gaps.insert(gaps.end(), a.gaps.begin(), a.gaps.end());
        longest = {std::max(longest.wall, a.gap.wall), std::max(longest.work, a.gap.work)};
    }
    const auto at = [](std::vector<double>& values, double part) {
        std::sort(values.begin(), values.end());
        return values[std::size_t(part * double(values.size() - 1) + 0.5)];
    };
    table.row({name, whole(double(rounds.size())), seconds(at(first, 0.5)), seconds(at(all, 0.5)),
               whole(double(gaps.size())), seconds(at(gaps, 0.5)), seconds(at(gaps, 0.99)), text(longest)});
}

} // namespace

void mapTable(bool quick) {
    Language language;
    Session session;
    Appearance appearance;
    Playhead playhead{session};
    MainWindow window(Context{session, playhead, appearance}, language);
    language.use(Language::Code::English);
    appearance.setReducedMotion(true);
    window.resize(1920, 1080);
    session.openBuiltin("bowling");
    window.show();
    QCoreApplication::processEvents();
    Table table("**The strike map in the window** at 1920 × 1080, off screen, 256 × 256: until its first "
                "picture is painted, until it is whole, and how long a timer of 1 ms waited meanwhile. In "
                "brackets: the most that the window's own thread worked between two beats.",
                {"map", "rounds", "first picture", "whole", "beats", "median", "99th percentile", "longest"});
    auto& rail = *window.findChild<Rail*>();
    auto& panel = *static_cast<MapPanel*>(rail.panel(Room::Map));
    auto& scene = *panel.findChild<QComboBox*>("mapScene");
    choose(scene, MapScene::Rack);
    const auto measure = [&](MapScene of) {
        const auto other = of == MapScene::Rack ? MapScene::Bowling : MapScene::Rack;
        choose(scene, other);
        QCoreApplication::processEvents();
        panel.cancel();
        while (panel.running())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        return answers(panel, [&] { choose(scene, of); });
    };
    const int rounds = quick ? 1 : 9;
    rail.enter(Room::Map);
    std::vector<Answers> rack, lane, playing;
    for (int k = 0; k < rounds; ++k)
        rack.push_back(measure(MapScene::Rack));
    row(table, "rack", rack);
    for (int k = 0; k < (quick ? 1 : 3); ++k)
        lane.push_back(measure(MapScene::Bowling));
    row(table, "whole lane", lane);
    if (quick)
        return;
    QObject::connect(&playhead, &Playhead::playingChanged, &window, [&](bool on) {
        if (!on)
            QMetaObject::invokeMethod(&playhead, &Playhead::togglePlaying, Qt::QueuedConnection);
    });
    playhead.setPlaying(true);
    for (int k = 0; k < 3; ++k)
        playing.push_back(measure(MapScene::Bowling));
    row(table, "whole lane, while a throw plays", playing);
}

} // namespace thetalane::benchmarks

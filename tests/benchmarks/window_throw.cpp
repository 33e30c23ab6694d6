#include "tests/benchmarks/window_throw.h"

#include "core/bowling/ball_path.h"
#include "tests/benchmarks/waits.h"
#include "ui/aim/aim_tool.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_view.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QMouseEvent>

#include <cmath>

namespace thetalane::benchmarks {
namespace {

// All of a full-HD screen.
struct Screen {
    Language language;
    Session session;
    Appearance appearance;
    Playhead playhead{session};
    MainWindow window{Context{session, playhead, appearance}, language};
    LanePanel& lane = *window.findChild<LanePanel*>("lanePanel");
    LaneView& view = lane.view();

    Screen() {
        language.use(Language::Code::English);
        appearance.setReducedMotion(true);
        window.resize(1920, 1080);
        window.show();
        QCoreApplication::processEvents();
    }
    // What the change asked for, and no more.
    void paint() { QCoreApplication::processEvents(); }
};

// Where the most collisions are within a second [s].
double busiestSecond(const Timeline& timeline) {
    const auto all = timeline.collisions();
    std::size_t most = 0, last = 0;
    double from = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        while (last < all.size() && all[last].time < all[k].time + 1)
            ++last;
        if (last - k > most) {
            most = last - k;
            from = all[k].time;
        }
    }
    return std::max(0.0, from - 0.02);
}

std::vector<Wait> frames(Screen& screen, double from, int rounds) {
    std::vector<Wait> waits;
    for (int round = 0; round < rounds; ++round) {
        screen.playhead.setTime(from);
        screen.paint();
        for (int k = 0; k < 60; ++k)
            waits.push_back(waited([&] {
                screen.playhead.advance(1.0 / 60);
                screen.paint();
            }));
    }
    return waits;
}

std::vector<Wait> aiming(Screen& screen, AimPart part, int moves) {
    QWidget* port = screen.view.viewport();
    const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                          Qt::MouseButtons held) {
        QMouseEvent event(type, at, port->mapToGlobal(at), button, held, {});
        QCoreApplication::sendEvent(port, &event);
    };
    const Vec2d place = placeOf(part, *screen.session.currentThrow());
    const QPointF at =
        screen.view.viewportTransform().map(QPointF(place.x * 1000, -place.y * 1000)).toPoint();
    send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    std::vector<Wait> waits;
    for (int k = 1; k <= moves; ++k) {
        const QPointF now = at + QPointF(20 * std::sin(0.1 * k), -20 * std::cos(0.1 * k));
        waits.push_back(waited([&] {
            send(QEvent::MouseMove, now, Qt::NoButton, Qt::LeftButton);
            screen.paint();
        }));
    }
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton, {});
    return waits;
}

void row(Table& table, const std::string& name, const std::vector<Wait>& waits) {
    table.row({name, whole(double(waits.size())), text(quantile(waits, 0.5)), text(quantile(waits, 0.99)),
               text(quantile(waits, 1))});
}

Throw strikingThrow() {
    Throw base;
    base.spin = 300 * perRpm;
    constexpr double offset = 0.068, angle = 5.5; // m, °
    return throwArriving(base, offset, radians(angle), houseFriction()).value_or(base);
}

} // namespace

void throwTables(bool quick) {
    Screen screen;
    const int rounds = quick ? 1 : 20;
    Table table("**Frames**, the window at 1920 × 1080 off screen, while the busiest second plays: from the "
                "clock's tick until the window is painted. In brackets: processor time.",
                {"scene", "frames", "median", "99th percentile", "worst"});
    screen.session.openBuiltin("break");
    row(table, "the break", frames(screen, busiestSecond(screen.session.timeline()), rounds));
    screen.session.openBuiltin("bowling");
    screen.session.setDelivery(strikingThrow(), allPins, {});
    const double busiest = busiestSecond(screen.session.timeline());
    row(table, "ten pins, the rack in view", frames(screen, busiest, rounds));
    screen.view.setFollowing(true);
    row(table, "ten pins, the camera following", frames(screen, busiest - 0.5, rounds));

    Table preview("**Aiming**, the same window: from a move of the mouse until the new run is painted.",
                  {"dragged", "moves", "median", "99th percentile", "worst"});
    screen.playhead.setTime(0);
    screen.view.showFoulLine();
    AimTool own({screen.session, screen.playhead, screen.appearance});
    if (!screen.window.findChild<AimTool*>()) // which the window has itself
        screen.lane.addTool(own);
    const int moves = quick ? 10 : 600;
    for (const Foresight foresight : {Foresight::FirstContact, Foresight::Whole}) {
        screen.session.setForesight(foresight);
        const std::string how = foresight == Foresight::Whole ? ", run to the end" : ", to the first contact";
        row(preview, "ball" + how, aiming(screen, AimPart::Ball, moves));
        row(preview, "direction" + how, aiming(screen, AimPart::Direction, moves));
        row(preview, "rotation" + how, aiming(screen, AimPart::Rotation, moves));
    }
}

} // namespace thetalane::benchmarks

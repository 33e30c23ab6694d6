// thetalane throw: one ball down the regulation lane at a full rack
#include "app/commands.h"
#include "app/console.h"
#include "app/engine_options.h"
#include "app/options.h"
#include "app/run_report.h"
#include "core/bowling/pinfall.h"
#include "core/format/run_file.h"
#include "core/scene/bowling_scene.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <numbers>

namespace thetalane {
namespace {

struct ThrowCommandText {
    Q_DECLARE_TR_FUNCTIONS(ThrowCommandText)
};

constexpr double degree = std::numbers::pi / 180;       // rad
constexpr double perMinute = 2 * std::numbers::pi / 60; // rad/s

// The attributes in the units of the command line: degrees, revolutions per minute.
struct Asked {
    double mass = Throw{}.mass;
    double speed = Throw{}.speed;
    double direction = 1.5;
    double position = Throw{}.position;
    double spin = 0;
    double axis = 0;
};

constexpr double fastest = 100;      // m/s; a bowler's ball does 9
constexpr Range directions{-90, 90}; // down the lane, not back
constexpr double edge = regulation::laneWidth / 2;

void declare(Arguments& a) {
    a.takesValue("mass", "KG", ThrowCommandText::tr("of the ball, at most 7.26 kg; 6.8 unless said"));
    a.takesValue("speed", "M/S", ThrowCommandText::tr("at the foul line; 8 unless said"));
    a.takesValue("direction", "DEG",
                 ThrowCommandText::tr("from straight down the lane, positive to the right; 1.5 unless said"));
    a.takesValue(
        "position", "M",
        ThrowCommandText::tr("of the ball's centre at the foul line, from the middle, positive to the right; "
                             "-0.41 unless said"));
    a.takesValue("spin", "RPM", ThrowCommandText::tr("revolutions per minute; 0 unless said"));
    a.takesValue(
        "axis", "DEG",
        ThrowCommandText::tr("of the spin, from a forward roll, positive hooks to the left; 0 unless said"));
    takeEngineOptions(a);
    a.takesFlag("json", ThrowCommandText::tr("prints JSON for programs"));
}

Asked attributes(Arguments& a) {
    Asked t;
    t.mass = a.number("mass", t.mass, {.low = 0, .high = regulation::maxBallMass, .highOpen = false});
    t.speed = a.number("speed", t.speed, {.low = 0, .high = fastest, .highOpen = false});
    t.direction = a.number("direction", t.direction, directions);
    t.position =
        a.number("position", t.position, {.low = -edge, .high = edge, .lowOpen = false, .highOpen = false});
    t.spin = a.number("spin", t.spin);
    t.axis = a.number("axis", t.axis);
    return t;
}

Throw inRadians(const Asked& t) {
    return {t.mass, t.speed, t.direction * degree, t.position, t.spin * perMinute, t.axis * degree};
}

// Pin numbers in their order, out of body indices.
QList<int> pinNumbers(const Scene& scene, const std::vector<int>& bodies) {
    QList<int> numbers;
    for (const int body : bodies)
        numbers << QString::fromStdString(scene.bodies[std::size_t(body)].id).toInt();
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

struct Pins {
    QList<int> down;
    QList<int> touched;
};

Pins pinsOf(const Run& run) {
    const double end = run.timeline.endTime();
    return {pinNumbers(run.scene, pinsDown(run.scene, run.timeline, end)),
            pinNumbers(run.scene, pinsTouched(run.scene, run.timeline, end))};
}

QJsonArray jsonList(const QList<int>& numbers) {
    QJsonArray array;
    for (const int number : numbers)
        array.append(number);
    return array;
}

QJsonObject extraJson(const Asked& t, const Pins& pins) {
    return {{"throw", QJsonObject{{"mass", t.mass},
                                  {"speed", t.speed},
                                  {"direction", t.direction},
                                  {"position", t.position},
                                  {"spin", t.spin},
                                  {"axis", t.axis}}},
            {"pins_down", jsonList(pins.down)},
            {"pins_touched", jsonList(pins.touched)}};
}

QString pinsText(const QList<int>& numbers) {
    QStringList texts;
    for (const int number : numbers)
        texts << QString::number(number);
    return numbers.isEmpty()
               ? ThrowCommandText::tr("none")
               : ThrowCommandText::tr("%1 (%2)").arg(texts.join(' '), QString::number(numbers.size()));
}

void printForPeople(const Run& run, const Asked& asked, Language::Code language) {
    const Pins pins = pinsOf(run);
    printHeading(run, language);
    printLine(ThrowCommandText::tr("Pins down: %1").arg(pinsText(pins.down)));
    printLine(ThrowCommandText::tr("Pins touched: %1").arg(pinsText(pins.touched)));
    if (pins.down.size() == 10)
        printLine(ThrowCommandText::tr("Strike"));
    if (asked.spin != 0)
        printLine(ThrowCommandText::tr("The lane has no friction yet, so the spin has no effect."));
    printLine();
    printCollisions(run);
    printTotals(run);
}

} // namespace

int throwCommand(const Call& call) {
    Arguments a("throw [--mass KG] [--speed M/S] [--direction DEG] [--position M] …",
                commandSummary("throw"));
    declare(a);
    if (const auto status = a.read(call.arguments))
        return *status;
    const Asked asked = attributes(a);
    const EngineSettings settings = engineSettings(a);
    if (const auto status = a.faults())
        return *status;
    const auto outcome = simulateOrTell(bowlingScene(inRadians(asked)), settings);
    if (const auto* fault = std::get_if<QString>(&outcome))
        return wrongCall(*fault);

    const Run& run = std::get<Run>(outcome);
    if (a.has("json"))
        writeRunJson(run, standardOutput(), extraJson(asked, pinsOf(run)));
    else
        printForPeople(run, asked, call.language);
    return finishOutput();
}

} // namespace thetalane

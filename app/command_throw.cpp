// thetalane throw: one ball down the regulation lane at a full rack
#include "app/commands.h"
#include "app/console.h"
#include "app/engine_options.h"
#include "app/options.h"
#include "app/run_report.h"
#include "core/bowling/pinfall.h"
#include "core/format/run_file.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/validation.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace thetalane {
namespace {

struct ThrowCommandText {
    Q_DECLARE_TR_FUNCTIONS(ThrowCommandText)
};

constexpr double degree = std::numbers::pi / 180;       // rad
constexpr double smallestTurn = 0.005;                  // °; below, rounding
constexpr double perMinute = 2 * std::numbers::pi / 60; // rad/s

// The attributes in the units of the command line: degrees, revolutions per minute.
struct Asked {
    double mass = Throw{}.mass;
    double speed = Throw{}.speed;
    double direction = 1.5;
    double position = Throw{}.position;
    double spin = 0;
    double axis = 0;
    double restitution = defaultPinRestitution;
    std::optional<Friction> friction;
};

constexpr double fastest = 100;      // m/s; a bowler's ball does 9
constexpr double mostSpin = 10'000;  // per minute, a surface as fast as that; a bowler's ball does 300
constexpr Range directions{-90, 90}; // down the lane, not back
constexpr double edge = regulation::laneWidth / 2;
constexpr Range closed(double low, double high) {
    return {low, high, false, false};
}

void declareBall(Arguments& a) {
    a.takesValue("mass", "KG", ThrowCommandText::tr("of the ball, at most 7.26 kg; 6.8 unless said"));
    a.takesValue("speed", "M/S", ThrowCommandText::tr("at the foul line; 8 unless said"));
    a.takesValue("direction", "DEG",
                 ThrowCommandText::tr("from straight down the lane, positive to the right; 1.5 unless said"));
    a.takesValue(
        "position", "M",
        ThrowCommandText::tr("of the ball's centre at the foul line, from the middle, positive to the right; "
                             "-0.41 unless said"));
    a.takesValue("spin", "RPM",
                 ThrowCommandText::tr(
                     "revolutions per minute; on a lane with friction the ball hooks; 0 unless said"));
    a.takesValue(
        "axis", "DEG",
        ThrowCommandText::tr("of the spin, from a forward roll, positive hooks to the left; 0 unless said"));
}

void declareLane(Arguments& a) {
    a.takesValue("friction", "MU",
                 ThrowCommandText::tr("of a sliding ball on the dry lane; 0.2 unless said"));
    a.takesValue("oil", "MU", ThrowCommandText::tr("of a sliding ball on the oil; 0.04 unless said"));
    a.takesValue(
        "oil-length", "M",
        ThrowCommandText::tr("of the oil, from the foul line; 12.192 (40 ft) unless said, 0 for none"));
    a.takesFlag("no-friction", ThrowCommandText::tr("takes all friction away: nothing slows or hooks"));
    a.takesValue("restitution", "E", ThrowCommandText::tr("between bodies; 0.75 unless said"));
}

Asked ballAsked(Arguments& a) {
    Asked t;
    t.mass = a.number("mass", t.mass, {.low = 0, .high = regulation::maxBallMass, .highOpen = false});
    t.speed = a.number("speed", t.speed, {.low = 0, .high = fastest, .highOpen = false});
    t.direction = a.number("direction", t.direction, directions);
    t.position = a.number("position", t.position, closed(-edge, edge));
    t.spin = a.number("spin", t.spin, closed(-mostSpin, mostSpin));
    t.axis = a.number("axis", t.axis);
    return t;
}

// The house's, where nothing else was asked for.
std::optional<Friction> frictionAsked(Arguments& a) {
    Friction friction = houseFriction();
    OilZone& oil = friction.oil.front();
    friction.ball = a.number("friction", friction.ball, closed(0, maxFriction));
    oil.friction = a.number("oil", oil.friction, closed(0, maxFriction));
    const double length = a.number("oil-length", regulation::houseOilLength,
                                   closed(0, regulation::foulLineToHeadPin + regulation::headPinToEnd));
    oil.to = oil.from + length;
    if (!(oil.from < oil.to)) // also of a length that rounding swallows
        friction.oil.clear();
    if (!a.has("no-friction"))
        return friction;
    for (const char* option : {"friction", "oil", "oil-length"})
        if (a.has(option))
            a.note(QString("--%1: ").arg(option) +
                   ThrowCommandText::tr("has no meaning with --no-friction; leave one of the two out"));
    return std::nullopt;
}

Asked attributes(Arguments& a) {
    Asked t = ballAsked(a);
    t.friction = frictionAsked(a);
    t.restitution = a.number("restitution", t.restitution, closed(0, 1));
    return t;
}

Scene sceneOf(const Asked& t) {
    const Throw inRadians{t.mass,         t.speed, t.direction * degree, t.position, t.spin * perMinute,
                          t.axis * degree};
    return bowlingScene(inRadians, t.restitution, t.friction);
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

// Positive to the right, as --direction is.
double headingDegrees(Vec2d velocity) {
    return std::atan2(velocity.x, velocity.y) / degree;
}

// Where the ball was, how fast and which way it went when it met its first pin: the hook shows here.
void printFirstPin(const Run& run, const Asked& asked) {
    const auto collisions = run.timeline.collisions();
    const auto met =
        std::find_if(collisions.begin(), collisions.end(), [](const Collision& c) { return c.involves(0); });
    if (met == collisions.end())
        return;
    const Vec2d velocity = met->steps.before.first; // the ball is the first body
    const double heading = headingDegrees(velocity);
    printLine(ThrowCommandText::tr("At its first pin: x = %1 m, %2 m/s, heading %3°")
                  .arg(numberText(run.timeline.bodyAt(0, met->time).position.x), numberText(norm(velocity)),
                       numberText(heading)));
    const double turned = heading - asked.direction;
    if (std::abs(turned) >= smallestTurn)
        printLine((turned < 0 ? ThrowCommandText::tr("The lane turned its path %1° to the left")
                              : ThrowCommandText::tr("The lane turned its path %1° to the right"))
                      .arg(numberText(std::abs(turned))));
}

void printForPeople(const Run& run, const Asked& asked, Language::Code language) {
    const Pins pins = pinsOf(run);
    printHeading(run, language);
    printLine(ThrowCommandText::tr("Pins down: %1").arg(pinsText(pins.down)));
    printLine(ThrowCommandText::tr("Pins touched: %1").arg(pinsText(pins.touched)));
    if (pins.down.size() == 10)
        printLine(ThrowCommandText::tr("Strike"));
    printFirstPin(run, asked);
    if (asked.spin != 0 && !asked.friction)
        printLine(ThrowCommandText::tr("Without friction the spin has no effect."));
    printLine();
    printCollisions(run);
    printTotals(run);
}

} // namespace

int throwCommand(const Call& call) {
    Arguments a(
        "throw [--mass KG] [--speed M/S] [--direction DEG] [--position M] [--spin RPM] [--axis DEG] …",
        commandSummary("throw"));
    declareBall(a);
    declareLane(a);
    takeEngineOptions(a);
    a.takesFlag("json", ThrowCommandText::tr("prints JSON for programs"));
    if (const auto status = a.read(call.arguments))
        return *status;
    const Asked asked = attributes(a);
    const EngineSettings settings = engineSettings(a);
    if (const auto status = a.faults())
        return *status;
    const auto outcome = simulateOrTell(sceneOf(asked), settings);
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

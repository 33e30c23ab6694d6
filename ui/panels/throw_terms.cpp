#include "ui/panels/throw_terms.h"

#include "ui/words/number_text.h"

#include <QSettings>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double pound = 0.45359237; // kg
constexpr double mile = 1609.344;    // m
constexpr int boards = 39;

const char* const massKey = "throw/massUnit";
const char* const speedKey = "throw/speedUnit";

} // namespace

ThrowUnits rememberedThrowUnits() {
    const QSettings settings;
    const QString mass = settings.value(massKey).toString();
    const QString speed = settings.value(speedKey).toString();
    ThrowUnits units;
    if (mass == unitSymbol(MassUnit::Pound))
        units.mass = MassUnit::Pound;
    for (const SpeedUnit unit : {SpeedUnit::KilometresPerHour, SpeedUnit::MilesPerHour})
        if (speed == unitSymbol(unit))
            units.speed = unit;
    return units;
}

void rememberThrowUnits(const ThrowUnits& units) {
    QSettings settings;
    settings.setValue(massKey, unitSymbol(units.mass));
    settings.setValue(speedKey, unitSymbol(units.speed));
}

double inKilograms(MassUnit unit) {
    return unit == MassUnit::Pound ? pound : 1;
}

double inMetresPerSecond(SpeedUnit unit) {
    switch (unit) {
    case SpeedUnit::KilometresPerHour:
        return 1 / 3.6;
    case SpeedUnit::MilesPerHour:
        return mile / 3600;
    case SpeedUnit::MetresPerSecond:
        break;
    }
    return 1;
}

QString unitSymbol(MassUnit unit) {
    return unit == MassUnit::Pound ? QStringLiteral("lb") : QStringLiteral("kg");
}

QString unitSymbol(SpeedUnit unit) {
    switch (unit) {
    case SpeedUnit::KilometresPerHour:
        return QStringLiteral("km/h");
    case SpeedUnit::MilesPerHour:
        return QStringLiteral("mph");
    case SpeedUnit::MetresPerSecond:
        break;
    }
    return QStringLiteral("m/s");
}

ValueRow::Span massSpan(MassUnit unit) {
    if (unit == MassUnit::Pound)
        return {6, 16, 0.1, 6};
    return {2.7, regulation::maxBallMass, 0.01, 2.7};
}

ValueRow::Span speedSpan(SpeedUnit unit) {
    switch (unit) {
    case SpeedUnit::KilometresPerHour:
        return {14, 44, 0.5, 14};
    case SpeedUnit::MilesPerHour:
        return {9, 27, 0.25, 9};
    case SpeedUnit::MetresPerSecond:
        break;
    }
    return {4, 12, 0.1, 4};
}

QString speedText(double v, SpeedUnit in) {
    return numberText(v / inMetresPerSecond(in), 3) + ' ' + unitSymbol(in);
}

int boardAt(double position) {
    const double width = regulation::laneWidth / boards;
    return int(
        std::clamp(std::floor((regulation::laneWidth / 2 - position) / width) + 1, 1.0, double(boards)));
}

} // namespace thetalane

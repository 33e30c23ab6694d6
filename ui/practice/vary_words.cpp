#include "ui/practice/vary_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

struct VaryWords {
    Q_DECLARE_TR_FUNCTIONS(VaryWords)
};

constexpr double perMinute = 2 * std::numbers::pi / 60;

// Around the present value, cut off to a grid that reads well.
ShownRange around(double present, double reach, double step, double low, double high) {
    const double middle = std::round(present / step) * step;
    const auto tidy = [](double v) { return std::round(v * 1e9) / 1e9; };
    return {tidy(std::max(low, middle - reach)), tidy(std::min(high, middle + reach)), step};
}

} // namespace

QString throwQuantityName(ThrowQuantity quantity) {
    switch (quantity) {
    case ThrowQuantity::Mass:
        return VaryWords::tr("Weight");
    case ThrowQuantity::Speed:
        return VaryWords::tr("Speed");
    case ThrowQuantity::Direction:
        return VaryWords::tr("Direction");
    case ThrowQuantity::Position:
        return VaryWords::tr("Position");
    case ThrowQuantity::Spin:
        return VaryWords::tr("Rotation");
    case ThrowQuantity::Axis:
        break;
    }
    return VaryWords::tr("Axis of rotation");
}

const char* throwQuantityTerm(ThrowQuantity quantity) {
    switch (quantity) {
    case ThrowQuantity::Mass:
        return "mass";
    case ThrowQuantity::Speed:
        return "speed";
    case ThrowQuantity::Direction:
        return "direction";
    case ThrowQuantity::Position:
        return "board";
    case ThrowQuantity::Spin:
        return "angular-velocity";
    case ThrowQuantity::Axis:
        break;
    }
    return "axis";
}

QString throwQuantityUnit(ThrowQuantity quantity) {
    switch (quantity) {
    case ThrowQuantity::Mass:
        return QStringLiteral("kg");
    case ThrowQuantity::Speed:
        return QStringLiteral("m/s");
    case ThrowQuantity::Position:
        return QStringLiteral("cm");
    case ThrowQuantity::Spin:
        return QStringLiteral("rpm");
    case ThrowQuantity::Direction:
    case ThrowQuantity::Axis:
        break;
    }
    return QStringLiteral("°");
}

double shownQuantity(ThrowQuantity quantity, double value) {
    const auto tidy = [](double v) { return std::round(v * 1e9) / 1e9; };
    switch (quantity) {
    case ThrowQuantity::Position:
        return tidy(value * 100);
    case ThrowQuantity::Spin:
        return tidy(value / perMinute);
    case ThrowQuantity::Direction:
    case ThrowQuantity::Axis:
        return tidy(value * 180 / std::numbers::pi);
    default:
        return value;
    }
}

double quantityFromShown(ThrowQuantity quantity, double shown) {
    switch (quantity) {
    case ThrowQuantity::Position:
        return shown / 100;
    case ThrowQuantity::Spin:
        return shown * perMinute;
    case ThrowQuantity::Direction:
    case ThrowQuantity::Axis:
        return shown * std::numbers::pi / 180;
    default:
        return shown;
    }
}

ShownRange usualRange(ThrowQuantity quantity, double present) {
    switch (quantity) {
    case ThrowQuantity::Mass:
        return {3.2, 7.2, 0.1}; // a child's to the heaviest
    case ThrowQuantity::Speed:
        return {5, 11, 0.5};
    case ThrowQuantity::Direction:
        return around(present, 0.6, 0.1, -10, 10);
    case ThrowQuantity::Position:
        return around(present, 6, 1, -50, 50);
    case ThrowQuantity::Spin:
        return {0, 600, 50};
    case ThrowQuantity::Axis:
        break;
    }
    return {-90, 90, 15};
}

} // namespace thetalane

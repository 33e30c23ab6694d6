#include "core/format/map_csv.h"

#include "core/format/json_text.h"
#include "core/format/map_columns.h"

#include <cmath>
#include <numbers>

namespace thetalane {
namespace mapcolumns {

QByteArray header() {
    QByteArray text;
    for (const char* name : names)
        text += text.isEmpty() ? QByteArray(name) : ',' + QByteArray(name);
    return text;
}

QByteArray standingText(const PinSet& left) {
    QByteArray text;
    for (std::size_t k = 0; k < left.size(); ++k)
        if (left[k])
            text += (text.isEmpty() ? "" : "-") + QByteArray::number(int(k) + 1);
    return text;
}

} // namespace mapcolumns

namespace {

using namespace mapcolumns;

constexpr double degree = std::numbers::pi / 180;
constexpr double perMinute = 2 * std::numbers::pi / 60;

// In another unit, as it was asked for: 400 turns a minute and not 400.00000000000006, where both are the
// same in radians.
double inUnit(double value, double unit) {
    const double exact = value / unit, plain = std::round(exact * 1e9) / 1e9;
    return plain * unit == value ? plain : exact;
}

MapAxis inDegrees(MapAxis axis) {
    axis.from = inUnit(axis.from, degree);
    axis.to = inUnit(axis.to, degree);
    return axis;
}

QByteArray cellText(const MapCell& cell) {
    if (!cell.known())
        return ",,";
    return QByteArray::number(cell.pinsDown()) + (cell.strike() ? ",1," : ",0,") + standingText(cell.left());
}

// What is the same in every line.
QByteArray settingsText(const MapSettings& s) {
    QByteArray text = sceneNames[std::size_t(s.scene)];
    for (const double value :
         {s.base.speed, s.base.mass, inUnit(s.base.spin, perMinute), s.base.position, s.restitution})
        text += ',' + shortestDigits(value);
    return text;
}

} // namespace

QByteArray mapCsv(const StrikeMap& map) {
    const MapSettings& s = map.settings;
    const MapAxis angles = inDegrees(s.up);
    const QByteArray rest = ',' + QByteArray::number(s.up.count) + ',' + settingsText(s) + '\n';
    QByteArray text = header() + '\n';
    text.reserve(qsizetype(map.cells.size()) * 96);
    for (int row = 0; row < map.rows(); ++row) {
        const int number = s.firstRow + row;
        const QByteArray angle = ',' + shortestDigits(angles.at(number)) + ',';
        const QByteArray place = ',' + QByteArray::number(number + 1) + rest;
        for (int column = 0; column < map.columns(); ++column)
            text += shortestDigits(s.across.at(column)) + angle + cellText(map.at(column, row)) + place;
    }
    return text;
}

} // namespace thetalane

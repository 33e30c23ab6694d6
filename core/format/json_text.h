// The pieces of JSON that the writers lay out by hand.
#pragma once

#include "core/math/vec2.h"
#include "core/motion/floor_state.h"

#include <QByteArray>

#include <string_view>

namespace thetalane {

// The shortest digits that read back to the same double, the sign of zero included. JSON has no other word
// for what is not finite than null.
QByteArray jsonNumber(double value);

QByteArray jsonString(std::string_view utf8); // in quotes, escaped by Qt
QByteArray jsonPair(const Vec2<double>& v);   // [x, y]
QByteArray jsonTriple(const Spin<double>& w); // [x, y, z]
QByteArray shortestDigits(double value);      // as jsonNumber, for finite values

} // namespace thetalane

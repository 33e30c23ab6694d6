// Numbers as people read them: a true minus, a middle dot before a power of ten, significant digits.
#pragma once

#include <QString>

#include <optional>

namespace thetalane {

// Significant digits as a teacher would write them: 0.1562, 12.30, −3.200·10⁻⁵ where digits were rounded
// away; a number that is exact with fewer stays short: 0.5, 2, 1.25. Powers of ten below 10⁻⁴ and from 10⁶.
// Zero is 0, and a value is never rounded to it. Not a number, infinite: "—", "∞".
QString numberText(double value, int significant = 4);

// All digits: reads back to the same double. ASCII, for copying and files.
QString exactText(double value);

// The one way a number is read: all of the text, finite, with a true minus or an ASCII one. "-3", "−3", ".5",
// "1e-3"; not "abc", "0x1", "inf", "1,5", "".
std::optional<double> parseNumber(const QString& text);

} // namespace thetalane

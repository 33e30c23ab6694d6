// Where JSON that QJsonDocument has accepted is not JSON: its reader lets some things pass.
#pragma once

#include <QByteArray>

#include <optional>

namespace thetalane {

struct Laxness {
    qsizetype offset = 0; // of the byte that is wrong, or where the number begins
    const char* reason = nullptr;
};

inline constexpr const char* bareNumberReason = "a number needs a digit on each side of its point";
inline constexpr const char* rawControlReason = "a control character in a text must be escaped";
inline constexpr const char* unknownEscapeReason = "invalid escape sequence"; // Qt's own words for others

// The first number without a digit before or after its point (.5, 1.), control character in a string or
// escape that JSON does not have (\q); a byte order mark is let pass, as RFC 8259 allows.
std::optional<Laxness> firstLaxness(const QByteArray& json);

} // namespace thetalane

#include "core/format/json_strict.h"

#include <string_view>

namespace thetalane {
namespace {

bool isDigit(const QByteArray& json, qsizetype at) {
    return at >= 0 && at < json.size() && json[at] >= '0' && json[at] <= '9';
}

// Leaves `at` on the closing quote.
std::optional<Laxness> inString(const QByteArray& json, qsizetype& at) {
    for (++at; json[at] != '"'; ++at) {
        if (static_cast<unsigned char>(json[at]) < 0x20)
            return Laxness{at, rawControlReason};
        if (json[at] != '\\')
            continue;
        ++at;
        if (std::string_view("\"\\/bfnrtu").find(json[at]) == std::string_view::npos)
            return Laxness{at - 1, unknownEscapeReason};
    }
    return std::nullopt;
}

} // namespace

std::optional<Laxness> firstLaxness(const QByteArray& json) {
    for (qsizetype at = 0; at < json.size(); ++at) {
        if (json[at] == '"') {
            if (const auto lax = inString(json, at))
                return lax;
        } else if (json[at] == '.' && !(isDigit(json, at - 1) && isDigit(json, at + 1))) {
            qsizetype begin = at; // outside strings a point is in a number
            while (begin > 0 && (isDigit(json, begin - 1) || json[begin - 1] == '-'))
                --begin;
            return Laxness{begin, bareNumberReason};
        }
    }
    return std::nullopt;
}

} // namespace thetalane

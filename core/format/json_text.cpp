#include "core/format/json_text.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace thetalane {

QByteArray shortestDigits(double value) {
    if (value == 0) // "-0" alone would be read as a whole number, which has no sign at zero
        return std::signbit(value) ? "-0.0" : "0";
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general).ptr;
    return {text, end - text};
}

QByteArray jsonNumber(double value) {
    return std::isfinite(value) ? shortestDigits(value) : QByteArray("null");
}

QByteArray jsonString(std::string_view utf8) {
    const auto plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
    if (std::all_of(utf8.begin(), utf8.end(), plain)) // most ids; a document for each would take its time
        return '"' + QByteArray(utf8.data(), qsizetype(utf8.size())) + '"';
    const QString text = QString::fromUtf8(utf8.data(), qsizetype(utf8.size()));
    const QByteArray array = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return array.mid(1, array.size() - 2);
}

QByteArray jsonPair(const Vec2<double>& v) {
    return '[' + jsonNumber(v.x) + ", " + jsonNumber(v.y) + ']';
}

QByteArray jsonTriple(const Spin<double>& w) {
    return '[' + jsonNumber(w.x) + ", " + jsonNumber(w.y) + ", " + jsonNumber(w.z) + ']';
}

} // namespace thetalane

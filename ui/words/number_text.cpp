#include "ui/words/number_text.h"

#include <QRegularExpression>

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr int smallestPlainExponent = -4; // 0.0001234 is still read at a glance
constexpr int largestPlainExponent = 5;   // and so is 123456

QString superscript(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text;
    if (exponent < 0)
        text += QChar(0x207B);
    for (const QChar c : QString::number(std::abs(exponent)))
        text += digits[c.digitValue()];
    return text;
}

// How many digits the number has when written out exactly: 0.5 has one, 1.25 three.
int digitsOf(double magnitude) {
    QString mantissa = QString::number(magnitude, 'e', QLocale::FloatingPointShortest).section('e', 0, 0);
    return int(mantissa.remove('.').size());
}

} // namespace

QString numberText(double value, int significant) {
    if (std::isnan(value))
        return QStringLiteral("—");
    const QString sign = value < 0 ? QStringLiteral("−") : QString();
    if (std::isinf(value))
        return sign + QStringLiteral("∞");
    if (value == 0)
        return QStringLiteral("0");

    const double magnitude = std::abs(value);
    // An exact short number stays short; a rounded one shows all the digits that it claims.
    const int digits = std::min(std::max(significant, 1), digitsOf(magnitude));
    const QString rounded = QString::number(magnitude, 'e', digits - 1);
    const int exponent = rounded.section('e', 1).toInt();
    if (exponent < smallestPlainExponent || exponent > largestPlainExponent)
        return sign + rounded.section('e', 0, 0) + QStringLiteral("·10") + superscript(exponent);
    return sign + QString::number(magnitude, 'f', std::max(0, digits - 1 - exponent));
}

QString exactText(double value) {
    return value == 0 ? QStringLiteral("0") : QString::number(value, 'g', QLocale::FloatingPointShortest);
}

std::optional<double> parseNumber(const QString& text) {
    static const QRegularExpression form(R"(^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$)");
    const QString plain = text.trimmed().replace(QChar(0x2212), '-');
    if (!form.match(plain).hasMatch())
        return std::nullopt;
    bool ok = false;
    const double value = plain.toDouble(&ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace thetalane

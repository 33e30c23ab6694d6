#include "ui/words/formula.h"

#include "ui/words/number_text.h"

#include <algorithm>

namespace thetalane {
namespace {

using Kind = Formula::Kind;

Formula leaf(Kind kind, const QString& text, Ink ink = Ink::Plain, const QString& exact = {}) {
    return {kind, text, exact, ink, {}};
}

Formula node(Kind kind, std::vector<Formula> parts) {
    return {kind, {}, {}, Ink::Plain, std::move(parts)};
}

bool isPrime(const QString& text) {
    return text == QStringLiteral("′");
}

QString raised(const QString& text) {
    static const QString plain = QStringLiteral("0123456789+−n");
    static const QString high = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ");
    QString result;
    for (const QChar c : text) {
        const auto at = plain.indexOf(c);
        if (at < 0)
            return QStringLiteral("^(%1)").arg(text);
        result += high[at];
    }
    return result;
}

// Whether it must be held together by parentheses below a stroke or under a root sign.
bool isLoose(const Formula& f) {
    if (f.kind == Kind::Row && f.parts.size() == 1)
        return isLoose(f.parts.front());
    if (f.kind == Kind::Number)
        return f.text.contains(QStringLiteral("·")) || f.text.startsWith(QStringLiteral("−"));
    return f.kind == Kind::Row || f.kind == Kind::Fraction;
}

// A product needs none above a stroke: m_A·m_B/(m_A + m_B).
bool isProduct(const Formula& f) {
    if (f.kind == Kind::Number)
        return true;
    return f.kind == Kind::Row && std::none_of(f.parts.begin(), f.parts.end(), [](const Formula& part) {
               return part.kind == Kind::Operator && part.text != QStringLiteral("·");
           });
}

QString held(const Formula& f, Digits digits) {
    const QString text = plainText(f, digits);
    return isLoose(f) ? QStringLiteral("(%1)").arg(text) : text;
}

// What stands between two neighbours that no operator parts: 0.18 m, v cos θ, e·m, 12°.
QString between(const Formula& left, const Formula& right) {
    if (right.text == QStringLiteral("°"))
        return {};
    const bool word = left.kind == Kind::Upright || right.kind == Kind::Upright;
    return word ? QStringLiteral(" ") : QStringLiteral("·");
}

QString operatorText(const QString& text, bool unary) {
    if (unary || text == QStringLiteral("·"))
        return text;
    return text == QStringLiteral(",") ? QStringLiteral(", ") : QStringLiteral(" %1 ").arg(text);
}

QString rowText(const std::vector<Formula>& parts, Digits digits) {
    QString text;
    const Formula* last = nullptr;
    for (const Formula& part : parts) {
        if (isEmpty(part))
            continue;
        const bool afterOperator = !last || last->kind == Kind::Operator;
        if (part.kind == Kind::Operator)
            text += operatorText(part.text, afterOperator);
        else
            text += (afterOperator ? QString() : between(*last, part)) + plainText(part, digits);
        last = &part;
    }
    return text;
}

// Letters of an index stand close: v_Ax′, v_ball,x′.
QString indexText(const Formula& f, Digits digits) {
    if (f.kind != Kind::Row)
        return f.kind == Kind::Operator ? f.text : plainText(f, digits);
    QString text;
    for (const Formula& part : f.parts)
        text += indexText(part, digits);
    return text;
}

QString scriptText(const Formula& f, Digits digits) {
    const Formula& base = f.parts[0];
    QString text = held(base, digits);
    const QString sub = indexText(f.parts[1], digits);
    const QString super = indexText(f.parts[2], digits);
    if (isPrime(super)) // belongs to the letter: v′_A
        text += super;
    if (!sub.isEmpty())
        text += QStringLiteral("_") + sub;
    if (!super.isEmpty() && !isPrime(super))
        text += raised(super);
    return text;
}

QString fractionText(const Formula& f, Digits digits) {
    const QString above = isProduct(f.parts[0]) ? plainText(f.parts[0], digits) : held(f.parts[0], digits);
    const QString below = held(f.parts[1], digits);
    return above == "1" && below == "2" ? QStringLiteral("½") : above + QStringLiteral("/") + below;
}

} // namespace

Formula row(std::vector<Formula> parts) {
    return node(Kind::Row, std::move(parts));
}

Formula symbol(const QString& text, Ink ink) {
    return leaf(Kind::Symbol, text, ink);
}

Formula upright(const QString& text, Ink ink) {
    return leaf(Kind::Upright, text, ink);
}

Formula number(double value, Ink ink) {
    return leaf(Kind::Number, numberText(value), ink, exactText(value));
}

Formula signedFactor(double value, Ink ink) {
    Formula n = number(value, ink);
    const bool needsHolding = value < 0 || n.text.contains(QStringLiteral("·"));
    return needsHolding ? group(std::move(n)) : n;
}

Formula op(const QString& text) {
    return leaf(Kind::Operator, text);
}

Formula fraction(Formula above, Formula below) {
    return node(Kind::Fraction, {std::move(above), std::move(below)});
}

Formula root(Formula under) {
    return node(Kind::Root, {std::move(under)});
}

Formula script(Formula base, Formula sub, Formula super) {
    return node(Kind::Script, {std::move(base), std::move(sub), std::move(super)});
}

Formula group(Formula inner) {
    return node(Kind::Group, {std::move(inner)});
}

bool isEmpty(const Formula& f) {
    return f.kind == Kind::Row && f.parts.empty();
}

QString plainText(const Formula& f, Digits digits) {
    switch (f.kind) {
    case Kind::Row:
        return rowText(f.parts, digits);
    case Kind::Number:
        return digits == Digits::All ? f.exact : f.text;
    case Kind::Symbol:
    case Kind::Upright:
    case Kind::Operator:
        return f.text;
    case Kind::Fraction:
        return fractionText(f, digits);
    case Kind::Root:
        return QStringLiteral("√") + held(f.parts[0], digits);
    case Kind::Script:
        return scriptText(f, digits);
    case Kind::Group:
        return QStringLiteral("(%1)").arg(plainText(f.parts[0], digits));
    }
    return {};
}

} // namespace thetalane

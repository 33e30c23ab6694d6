#include "ui/words/worked_lines.h"

#include <cmath>
#include <numbers>

namespace thetalane {

// a = x_A − x_B
WorkedLine LineWriter::leg(const char* name, const char* coordinate, double from, double to,
                           double length) const {
    return {letter(name), row({of(coordinate, first()), operation("−"), of(coordinate, second())}),
            row({number(from, Ink::First), operation("−"), signedFactor(to, Ink::Second)}),
            valued(length, Ink::Triangle, "m")};
}

// r_A + r_B = … m ≥ Z: the test of the paper. Meeting exactly, the two agree but for rounding.
WorkedLine LineWriter::reach() const {
    const double sum = m_s.first.radius + m_s.second.radius;
    const double gap = m_s.contact.Z - sum;
    const char* sign = std::abs(gap) <= 1e-9 * sum ? "≈" : gap < 0 ? ">" : "<";
    const Formula result = row({number(sum), unit("m"), operation(sign), letter("Z")});
    if (m_collision.isWall())
        return {of("r", first()), {}, {}, result};
    return {
        row({of("r", first()), operation("+"), of("r", second())}),
        {},
        row({number(m_s.first.radius, Ink::First), operation("+"), number(m_s.second.radius, Ink::Second)}),
        result};
}

std::vector<WorkedLine> LineWriter::contact() const {
    const Contact<double>& c = m_s.contact;
    const auto n = [](double value) { return signedFactor(value, Ink::Triangle); };
    const auto ratio = [&](const char* name, const char* side, double length, double value) -> WorkedLine {
        if (c.Z == 0)
            return {function(name), {}, {}, number(value, Ink::Triangle)};
        return {function(name), fraction(letter(side), letter("Z")),
                fraction(number(length, Ink::Triangle), number(c.Z, Ink::Triangle)),
                number(value, Ink::Triangle)};
    };
    const double degrees = std::atan2(c.sinTheta, c.cosTheta) * 180 / std::numbers::pi; // for display only
    return {leg("a", "x", m_s.first.position.x, m_s.second.position.x, c.a),
            leg("b", "y", m_s.first.position.y, m_s.second.position.y, c.b),
            {letter("Z"), root(row({square(letter("a")), operation("+"), square(letter("b"))})),
             root(row({square(n(c.a)), operation("+"), square(n(c.b))})), valued(c.Z, Ink::Triangle, "m")},
            reach(),
            ratio("cos", "a", c.a, c.cosTheta),
            ratio("sin", "b", c.b, c.sinTheta),
            {letter("θ"), {}, {}, valued(degrees, Ink::Triangle, "°")}};
}

std::vector<WorkedLine> LineWriter::split() const {
    std::vector<WorkedLine> lines;
    for (const Party& p : parties()) {
        if (p.before == Vec2d{}) {
            lines.push_back({v(p, "x"), v(p, "y"), {}, valued(0, p.ink, "m/s")});
            continue;
        }
        const double speed = norm(p.before);
        const double degrees = std::atan2(p.before.y, p.before.x) * 180 / std::numbers::pi;
        const Formula angle = script(symbol("φ", p.ink), upright(indexName(m_scene, p.body), p.ink));
        const auto part = [&](const char* axis, const char* name, double value) -> WorkedLine {
            return {v(p, axis), row({v(p, {}), upright(name), angle}),
                    row({number(speed, p.ink), operation("·"), upright(name),
                         degrees < 0 ? group(valued(degrees, p.ink, "°")) : valued(degrees, p.ink, "°")}),
                    valued(value, p.ink, "m/s")};
        };
        lines.push_back({row({v(p, {})}), {}, {}, valued(speed, p.ink, "m/s")});
        lines.push_back({angle, {}, {}, valued(degrees, p.ink, "°")});
        lines.push_back(part("x", "cos", p.before.x));
        lines.push_back(part("y", "sin", p.before.y));
    }
    return lines;
}

// one·cos θ ± two·sin θ, or with sin first
WorkedLine LineWriter::turned(Formula left, Formula one, double oneValue, Ink oneInk, const char* sign,
                              bool cosFirst, Formula two, double twoValue, Ink twoInk, double result,
                              Ink ink) const {
    return {std::move(left),
            row({std::move(one), function(cosFirst ? "cos" : "sin"), operation(sign), std::move(two),
                 function(cosFirst ? "sin" : "cos")}),
            row({number(oneValue, oneInk), operation("·"), cosFirst ? cosine() : sine(), operation(sign),
                 signedFactor(twoValue, twoInk), operation("·"), cosFirst ? sine() : cosine()}),
            valued(result, ink, "m/s")};
}

std::vector<WorkedLine> LineWriter::rotation() const {
    std::vector<WorkedLine> lines;
    for (const Party& p : parties()) {
        lines.push_back(turned(v(p, alongAxis), v(p, "x"), p.before.x, p.ink, "+", true, v(p, "y"),
                               p.before.y, p.ink, p.rotated.x, Ink::Along));
        lines.push_back(turned(v(p, acrossAxis), v(p, "y"), p.before.y, p.ink, "−", true, v(p, "x"),
                               p.before.x, p.ink, p.rotated.y, Ink::Across));
    }
    return lines;
}

// [(m − e m′) v + (1 + e) m′ v′]/(m + m′), in the order of the paper: A's term first.
WorkedLine LineWriter::exchanged(const Party& p, const Party& other) const {
    const Formula e = symbol("e");
    const Formula en = number(m_s.restitution);
    const auto kept = [](Formula m, std::vector<Formula> product) {
        product.insert(product.begin(), {std::move(m), operation("−")});
        return group(row(std::move(product)));
    };
    const auto given = [](Formula f) { return group(row({number(1), operation("+"), std::move(f)})); };
    const auto mass = [](const Party& q) { return number(q.disc.mass, q.ink); };
    const auto along = [](const Party& q) { return signedFactor(q.rotated.x, Ink::Along); };
    const Formula dot = operation("·");

    const Formula own = row({kept(of("m", p), {e, of("m", other)}), v(p, alongAxis)});
    const Formula own2 = row({kept(mass(p), {en, dot, mass(other)}), dot, along(p)});
    const Formula got = row({given(e), of("m", other), v(other, alongAxis)});
    const Formula got2 = row({given(en), dot, mass(other), dot, along(other)});
    const bool ownFirst = p.body == m_collision.first;
    const auto sum = [&](const Formula& a, const Formula& b) {
        return ownFirst ? row({a, operation("+"), b}) : row({b, operation("+"), a});
    };
    return {v(p, alongAxis, When::After),
            fraction(sum(own, got), row({of("m", first()), operation("+"), of("m", second())})),
            fraction(sum(own2, got2), row({mass(first()), operation("+"), mass(second())})),
            valued(p.exchanged.x, Ink::Along, "m/s")};
}

std::vector<WorkedLine> LineWriter::exchange() const {
    std::vector<WorkedLine> lines;
    if (m_collision.isWall())
        lines.push_back({v(first(), alongAxis, When::After),
                         row({operation("−"), symbol("e"), v(first(), alongAxis)}),
                         row({operation("−"), number(m_s.restitution), operation("·"),
                              signedFactor(m_s.rotated.first.x, Ink::Along)}),
                         valued(m_s.exchanged.first.x, Ink::Along, "m/s")});
    else
        lines = {exchanged(first(), second()), exchanged(second(), first())};
    for (const Party& p : parties())
        lines.push_back(
            {v(p, acrossAxis, When::After), v(p, acrossAxis), {}, valued(p.exchanged.y, Ink::Across, "m/s")});
    return lines;
}

std::vector<WorkedLine> LineWriter::rotationBack() const {
    std::vector<WorkedLine> lines;
    for (const Party& p : parties()) {
        const Formula along = v(p, alongAxis, When::After);
        const Formula across = v(p, acrossAxis, When::After);
        lines.push_back(turned(v(p, "x", When::After), along, p.exchanged.x, Ink::Along, "−", true, across,
                               p.exchanged.y, Ink::Across, p.after.x, p.ink));
        lines.push_back(turned(v(p, "y", When::After), along, p.exchanged.x, Ink::Along, "+", false, across,
                               p.exchanged.y, Ink::Across, p.after.y, p.ink));
    }
    return lines;
}

} // namespace thetalane

#include "ui/words/worked_lines.h"

namespace thetalane {

// p_x = m_A v_Ax + m_B v_Bx, before and after, and what rounding left between them.
void LineWriter::momentum(std::vector<WorkedLine>& lines, const QString& axis, double Vec2d::*part) const {
    const Party a = first();
    const Party b = second();
    const auto total = [&](When when) {
        const Formula prime = when == When::After ? symbol("′") : Formula{};
        return script(symbol("p"), symbol(axis), prime);
    };
    const auto sum = [&](When when) -> WorkedLine {
        const double va = (when == When::After ? a.after : a.before).*part;
        const double vb = (when == When::After ? b.after : b.before).*part;
        return {total(when),
                row({of("m", a), v(a, axis, when), operation("+"), of("m", b), v(b, axis, when)}),
                row({number(a.disc.mass, a.ink), operation("·"), signedFactor(va, a.ink), operation("+"),
                     number(b.disc.mass, b.ink), operation("·"), signedFactor(vb, b.ink)}),
                valued(a.disc.mass * va + b.disc.mass * vb, Ink::Plain, "kg·m/s")};
    };
    lines.push_back(sum(When::Before));
    lines.push_back(sum(When::After));
    lines.push_back({row({total(When::After), operation("−"), total(When::Before)}),
                     {},
                     {},
                     valued(m_s.momentumResidual.*part, Ink::Plain, "kg·m/s")});
}

// e = −(v′_Ax′ − v′_Bx′)/(v_Ax′ − v_Bx′)
WorkedLine LineWriter::restitution() const {
    const Party a = first();
    const auto difference = [&](When when) {
        if (m_collision.isWall())
            return v(a, alongAxis, when);
        return row({v(a, alongAxis, when), operation("−"), v(second(), alongAxis, when)});
    };
    const auto numbers = [&](const Vec2d& mine, const Vec2d& others) {
        if (m_collision.isWall())
            return number(mine.x, Ink::Along);
        return row({number(mine.x, Ink::Along), operation("−"), signedFactor(others.x, Ink::Along)});
    };
    const double approach = m_s.rotated.first.x - m_s.rotated.second.x;
    const Formula minus = operation("−");
    WorkedLine line{symbol("e"),
                    row({minus, fraction(difference(When::After), difference(When::Before))}),
                    {},
                    number(m_s.restitution)};
    if (approach != 0)
        line.substituted = row({minus, fraction(numbers(m_s.exchanged.first, m_s.exchanged.second),
                                                numbers(m_s.rotated.first, m_s.rotated.second))});
    return line;
}

// What rounding left of the law, or by how much other impulses parted the two faster.
WorkedLine LineWriter::restitutionLeft() const {
    const auto relative = [&](When when) {
        if (m_collision.isWall())
            return v(first(), alongAxis, when);
        return group(row({v(first(), alongAxis, when), operation("−"), v(second(), alongAxis, when)}));
    };
    return {row({relative(When::After), operation("+"), symbol("e"), relative(When::Before)}),
            {},
            {},
            valued(m_s.restitutionResidual, Ink::Plain, "m/s")};
}

// The impulse on the first body.
WorkedLine LineWriter::impulse() const {
    const Party a = first();
    return {symbol("I"),
            row({of("m", a), group(row({v(a, alongAxis, When::After), operation("−"), v(a, alongAxis)}))}),
            row({number(a.disc.mass, a.ink), operation("·"),
                 group(row({number(a.exchanged.x, Ink::Along), operation("−"),
                            signedFactor(a.rotated.x, Ink::Along)}))}),
            valued(m_s.impulse, Ink::Plain, "N·s")};
}

WorkedLine LineWriter::energy(When when) const {
    const bool after = when == When::After;
    const Formula half = fraction(number(1), number(2));
    std::vector<Formula> symbols;
    std::vector<Formula> numbers;
    double sum = 0;
    for (const Party& p : parties()) {
        const Vec2d& velocity = after ? p.after : p.before;
        const auto join = [&](std::vector<Formula>& parts) {
            if (!parts.empty())
                parts.push_back(operation("+"));
            parts.push_back(half);
        };
        join(symbols);
        Formula speed = v(p, {}, when);
        symbols.push_back(of("m", p));
        symbols.push_back(after ? square(group(std::move(speed))) : square(std::move(speed)));
        join(numbers);
        numbers.push_back(operation("·"));
        numbers.push_back(number(p.disc.mass, p.ink));
        numbers.push_back(operation("·"));
        numbers.push_back(square(signedFactor(norm(velocity), p.ink)));
        sum += p.disc.mass * dot(velocity, velocity) / 2;
    }
    return {script(symbol("E"), {}, after ? symbol("′") : Formula{}), row(std::move(symbols)),
            row(std::move(numbers)), valued(sum, Ink::Plain, "J")};
}

// E − E′ = ½ μ (1 − e²)(v_Ax′ − v_Bx′)², μ = m_A m_B/(m_A + m_B); at a wall μ is the body's mass.
WorkedLine LineWriter::loss() const {
    const Party a = first();
    const Formula half = fraction(number(1), number(2));
    const Formula dot = operation("·");
    const auto factor = [](Formula e) {
        return group(row({number(1), operation("−"), square(std::move(e))}));
    };
    const Formula left = row({symbol("E"), operation("−"), script(symbol("E"), {}, symbol("′"))});
    const Formula result = valued(m_s.energyLoss, Ink::Plain, "J");
    if (m_collision.isWall())
        return {left, row({half, of("m", a), factor(symbol("e")), square(v(a, alongAxis))}),
                row({half, dot, number(a.disc.mass, a.ink), dot, factor(number(m_s.restitution)), dot,
                     square(signedFactor(a.rotated.x, Ink::Along))}),
                result};
    const Party b = second();
    const double reduced = a.disc.mass * b.disc.mass / (a.disc.mass + b.disc.mass);
    const Formula relative = group(row({v(a, alongAxis), operation("−"), v(b, alongAxis)}));
    const Formula relative2 =
        group(row({number(a.rotated.x, Ink::Along), operation("−"), signedFactor(b.rotated.x, Ink::Along)}));
    return {left, row({half, symbol("μ"), factor(symbol("e")), square(relative)}),
            row({half, dot, number(reduced), dot, factor(number(m_s.restitution)), dot, square(relative2)}),
            result};
}

std::vector<WorkedLine> LineWriter::check() const {
    std::vector<WorkedLine> lines;
    const bool wall = m_collision.isWall();
    if (!wall) {
        momentum(lines, "x", &Vec2d::x);
        momentum(lines, "y", &Vec2d::y);
    }
    lines.push_back(restitution());
    lines.push_back(restitutionLeft());
    lines.push_back(impulse());
    lines.push_back(energy(When::Before));
    lines.push_back(energy(When::After));
    if (!wall) {
        const Party a = first();
        const Party b = second();
        lines.push_back(
            {symbol("μ"),
             fraction(row({of("m", a), of("m", b)}), row({of("m", a), operation("+"), of("m", b)})),
             {},
             valued(a.disc.mass * b.disc.mass / (a.disc.mass + b.disc.mass), Ink::Plain, "kg")});
    }
    lines.push_back(loss());
    return lines;
}

} // namespace thetalane

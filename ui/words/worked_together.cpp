// Contacts that were resolved together: the impulses of all of them made the velocities, so the exchange of
// two bodies is not what happened.
#include "ui/words/worked_lines.h"

#include <cmath>

namespace thetalane {
namespace {

constexpr std::size_t mostTerms = 4; // a longer sum is written with Σ, and its numbers are the other lines'

Formula primed(Formula base, Formula sub, When when) {
    return script(std::move(base), std::move(sub), when == When::After ? symbol("′") : Formula{});
}

Formula sumSign() {
    return upright(QStringLiteral("Σ"));
}

} // namespace

bool LineWriter::isPartedFaster() const {
    const double approach = m_s.rotated.first.x - m_s.rotated.second.x;
    return m_s.restitutionResidual > 1e-9 * (std::abs(approach) + norm(m_s.before.first));
}

// I_AB
Formula LineWriter::impulseOf(const Collision& c) const {
    const QString a = indexName(m_scene, c.first);
    const QString b = indexName(m_scene, c.second);
    std::vector<Formula> index{upright(a)};
    if (a.size() > 1 || b.size() > 1)
        index.push_back(op(","));
    index.push_back(upright(b));
    return script(symbol("I", &c == &m_collision ? Ink::Along : Ink::Plain), row(std::move(index)));
}

// v′_Ax′ − v′_Bx′ = −e (v_Ax′ − v_Bx′); where the others part the two faster, both sides by themselves.
void LineWriter::law(std::vector<WorkedLine>& lines) const {
    const bool wall = m_collision.isWall();
    const auto difference = [&](When when) {
        const Formula own = v(first(), alongAxis, when);
        return wall ? own : row({own, operation("−"), v(second(), alongAxis, when)});
    };
    const double before = m_s.rotated.first.x - m_s.rotated.second.x;
    const double after = m_s.exchanged.first.x - m_s.exchanged.second.x;
    const Formula held = wall ? difference(When::Before) : group(difference(When::Before));
    const Formula asked = row({operation("−"), symbol("e"), held});
    const Formula numbers =
        row({operation("−"), number(m_s.restitution), operation("·"), signedFactor(before, Ink::Along)});
    if (!isPartedFaster()) {
        lines.push_back({difference(When::After), asked, numbers, valued(after, Ink::Along, "m/s")});
        return;
    }
    lines.push_back({difference(When::After), {}, {}, valued(after, Ink::Along, "m/s")});
    lines.push_back({asked, {}, numbers, valued(-m_s.restitution * before, Ink::Along, "m/s")});
}

// v′ = v + (I + I_k cos δ_k + …)/m along x′, and with sin δ_k across: δ_k is from x′ to that contact's line.
WorkedLine LineWriter::gathered(const Party& p, bool along) const {
    const QString axis = along ? alongAxis : acrossAxis;
    const Ink ink = along ? Ink::Along : Ink::Across;
    const double before = along ? p.rotated.x : p.rotated.y;
    const Contact<double>& here = m_s.contact;
    std::vector<Formula> symbols, numbers;
    std::size_t terms = 0;
    for (const Collision& c : m_pass) {
        const bool own = &c == &m_collision;
        if (!c.involves(p.body) || (own ? !along : c.steps.impulse == 0))
            continue;
        ++terms;
        const bool pushed = c.first == p.body;
        if (!symbols.empty() || !pushed)
            for (auto* parts : {&symbols, &numbers})
                parts->push_back(operation(pushed ? "+" : "−"));
        symbols.push_back(impulseOf(c));
        numbers.push_back(number(c.steps.impulse, own ? Ink::Along : Ink::Plain));
        if (own)
            continue;
        const Contact<double>& there = c.steps.contact;
        const Vec2d turn = rotateIn(Vec2d{there.cosTheta, there.sinTheta}, here);
        symbols.push_back(upright(along ? "cos" : "sin"));
        symbols.push_back(script(symbol("δ"), impulseOf(c).parts[1]));
        numbers.push_back(operation("·"));
        numbers.push_back(signedFactor(along ? turn.x : turn.y));
    }
    const Formula was = v(p, axis);
    const Formula left = v(p, axis, When::After);
    const Formula result = valued(along ? p.exchanged.x : p.exchanged.y, ink, "m/s");
    if (terms == 0)
        return {left, was, {}, result};
    if (terms > mostTerms) {
        const Formula each = row({sumSign(), script(symbol("I"), symbol("k")), upright(along ? "cos" : "sin"),
                                  script(symbol("δ"), symbol("k"))});
        return {left, row({was, operation("+"), fraction(each, of("m", p))}), {}, result};
    }
    return {left, row({was, operation("+"), fraction(row(std::move(symbols)), of("m", p))}),
            row({number(before, ink), operation("+"),
                 fraction(row(std::move(numbers)), number(p.disc.mass, p.ink))}),
            result};
}

std::vector<WorkedLine> LineWriter::exchangeTogether() const {
    std::vector<WorkedLine> lines;
    law(lines);
    lines.push_back({impulseOf(m_collision), {}, {}, valued(m_s.impulse, Ink::Along, "N·s")});
    for (const Collision& c : m_pass) {
        const bool meets =
            c.involves(m_collision.first) || (!m_collision.isWall() && c.involves(m_collision.second));
        if (&c != &m_collision && meets)
            lines.push_back({impulseOf(c), {}, {}, valued(c.steps.impulse, Ink::Plain, "N·s")});
    }
    for (const bool along : {true, false})
        for (const Party& p : parties())
            lines.push_back(gathered(p, along));
    return lines;
}

// p_x = m_A v_Ax + m_B v_Bx + m_C v_Cx, each body of the pass once.
WorkedLine LineWriter::passMomentum(const std::vector<PassBody>& bodies, const QString& axis,
                                    double Vec2d::*part, When when) const {
    std::vector<Formula> symbols, numbers;
    double sum = 0;
    for (const PassBody& b : bodies) {
        const double velocity = (when == When::After ? b.after : b.before).*part;
        const Ink ink = inkOf(m_collision, b.body, {});
        if (!symbols.empty())
            for (auto* parts : {&symbols, &numbers})
                parts->push_back(operation("+"));
        symbols.push_back(script(symbol("m", ink), upright(indexName(m_scene, b.body), ink)));
        symbols.push_back(velocitySymbol(m_scene, m_collision, b.body, axis, when));
        numbers.push_back(number(b.mass, ink));
        numbers.push_back(operation("·"));
        numbers.push_back(signedFactor(velocity, ink));
        sum += b.mass * velocity;
    }
    const Formula left = primed(symbol("p"), symbol(axis), when);
    const Formula result = valued(sum, Ink::Plain, "kg·m/s");
    if (bodies.size() <= mostTerms)
        return {left, row(std::move(symbols)), row(std::move(numbers)), result};
    const Formula each = primed(symbol("v"), row({symbol("k"), symbol(axis)}), when);
    return {left, row({sumSign(), script(symbol("m"), symbol("k")), each}), {}, result};
}

WorkedLine LineWriter::passEnergy(const std::vector<PassBody>& bodies, When when) const {
    const Formula half = fraction(number(1), number(2));
    const bool after = when == When::After;
    const auto squared = [&](Formula speed) {
        return after ? square(group(std::move(speed))) : square(std::move(speed));
    };
    std::vector<Formula> symbols, numbers;
    double sum = 0;
    for (const PassBody& b : bodies) {
        const Vec2d& velocity = after ? b.after : b.before;
        const Ink ink = inkOf(m_collision, b.body, {});
        if (!symbols.empty())
            for (auto* parts : {&symbols, &numbers})
                parts->push_back(operation("+"));
        symbols.insert(symbols.end(),
                       {half, script(symbol("m", ink), upright(indexName(m_scene, b.body), ink)),
                        squared(velocitySymbol(m_scene, m_collision, b.body, {}, when))});
        numbers.insert(numbers.end(), {half, operation("·"), number(b.mass, ink), operation("·"),
                                       square(signedFactor(norm(velocity), ink))});
        sum += b.mass * dot(velocity, velocity) / 2;
    }
    const Formula left = primed(symbol("E"), {}, when);
    const Formula result = valued(sum, Ink::Plain, "J");
    if (bodies.size() <= mostTerms)
        return {left, row(std::move(symbols)), row(std::move(numbers)), result};
    const Formula each = squared(primed(symbol("v"), symbol("k"), when));
    return {left, row({sumSign(), half, script(symbol("m"), symbol("k")), each}), {}, result};
}

std::vector<WorkedLine> LineWriter::checkTogether() const {
    std::vector<WorkedLine> lines;
    const std::vector<PassBody> bodies = bodiesOf(m_pass);
    const bool wall = hasWall(m_pass);
    const auto axisOf = [&](const QString& axis, double Vec2d::*part) {
        lines.push_back(passMomentum(bodies, axis, part, When::Before));
        lines.push_back(passMomentum(bodies, axis, part, When::After));
        double change = m_s.momentumResidual.*part;
        if (wall) { // what the walls gave, and no residual
            change = 0;
            for (const PassBody& b : bodies)
                change += b.mass * (b.after.*part - b.before.*part);
        }
        lines.push_back({row({primed(symbol("p"), symbol(axis), When::After), operation("−"),
                              primed(symbol("p"), symbol(axis), When::Before)}),
                         {},
                         {},
                         valued(change, Ink::Plain, "kg·m/s")});
    };
    axisOf("x", &Vec2d::x);
    axisOf("y", &Vec2d::y);
    if (!isPartedFaster())
        lines.push_back(restitution());
    lines.push_back(restitutionLeft());
    lines.push_back(passEnergy(bodies, When::Before));
    lines.push_back(passEnergy(bodies, When::After));
    lines.push_back(share());
    double lost = 0;
    for (const Collision& c : m_pass)
        lost += c.steps.energyLoss;
    lines.push_back({row({symbol("E"), operation("−"), script(symbol("E"), {}, symbol("′"))}),
                     row({sumSign(), script(symbol("L"), symbol("k"))}),
                     {},
                     valued(lost, Ink::Plain, "J")});
    return lines;
}

// What is lost at this contact: L_AB = ½ I_AB (1 − e)(v_Bx′ − v_Ax′). All of them together are E − E′.
WorkedLine LineWriter::share() const {
    const Formula half = fraction(number(1), number(2));
    const Formula times = operation("·");
    const bool wall = m_collision.isWall();
    const Formula approach =
        wall ? group(row({operation("−"), v(first(), alongAxis)}))
             : group(row({v(second(), alongAxis), operation("−"), v(first(), alongAxis)}));
    const double speed = m_s.rotated.second.x - m_s.rotated.first.x;
    const auto left = [](Formula e) { return group(row({number(1), operation("−"), std::move(e)})); };
    return {script(symbol("L"), impulseOf(m_collision).parts[1]),
            row({half, impulseOf(m_collision), left(symbol("e")), approach}),
            row({half, times, number(m_s.impulse, Ink::Along), times, left(number(m_s.restitution)), times,
                 signedFactor(speed, Ink::Along)}),
            valued(m_s.energyLoss, Ink::Plain, "J")};
}

} // namespace thetalane

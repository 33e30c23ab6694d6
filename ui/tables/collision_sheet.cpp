#include "ui/tables/collision_sheet.h"

#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_lines.h"

#include <QCoreApplication>

#include <cmath>

namespace thetalane {
namespace {

struct SheetText {
    Q_DECLARE_TR_FUNCTIONS(CollisionSheet)
};

const QString metresPerSecond = QStringLiteral("m/s");
const QString momentumUnit = QStringLiteral("kg·m/s");
const QString joule = QStringLiteral("J");

// What a row of a body says, in this order; the units are those of bodyColumns().
std::vector<SheetCell> valuesOf(double mass, const Vec2d& v) {
    const double speed = norm(v);
    return {numberCell(mass, QStringLiteral("kg")),
            numberCellOf(v.x, speed, metresPerSecond),
            numberCellOf(v.y, speed, metresPerSecond),
            numberCell(speed, metresPerSecond),
            numberCellOf(mass * v.x, mass * speed, momentumUnit),
            numberCellOf(mass * v.y, mass * speed, momentumUnit),
            numberCell(mass * dot(v, v) / 2, joule)};
}

// A total has no velocity of its own.
std::vector<SheetCell> totalsOf(double mass, const Vec2d& p, double energy, double scale) {
    return {numberCell(mass, QStringLiteral("kg"), Ink::Plain, true),
            {},
            {},
            {},
            numberCellOf(p.x, scale, momentumUnit, Ink::Plain, true),
            numberCellOf(p.y, scale, momentumUnit, Ink::Plain, true),
            numberCell(energy, joule, Ink::Plain, true)};
}

std::vector<SheetCell> heading(const QString& text) {
    return {textCell(text, Ink::Plain, true)};
}

// Value and remark of one check: "0.3375 J", "27 %".
std::vector<SheetCell> check(const QString& name, SheetCell value, const QString& remark) {
    return {textCell(name), std::move(value), textCell(remark)};
}

SheetCell withUnit(double value, const QString& unit) {
    SheetCell cell = numberCell(value, unit);
    if (!unit.isEmpty())
        cell.shown += QChar(0xA0) + unit;
    return cell;
}

std::vector<SheetCell> momentumCheck(const QString& axis, double residual, const PassSums& sums) {
    const QString name = SheetText::tr("Σ%1 after − before").arg(QStringLiteral("p") + axis);
    SheetCell value = withUnit(residual, momentumUnit);
    if (isRounding(residual, sums.momentumScale)) {
        value.shown = QStringLiteral("0");
        return check(name, std::move(value), SheetText::tr("within rounding"));
    }
    return check(name, std::move(value), sums.wall ? SheetText::tr("taken up by the wall") : QString());
}

Vec2d residualOf(std::span<const Collision> pass, const PassSums& sums) {
    if (pass.size() == 1 && !sums.wall)
        return pass.front().steps.momentumResidual;
    return sums.momentumAfter - sums.momentumBefore;
}

SheetCell share(double lost, double before) {
    if (!(before > 0))
        return {};
    SheetCell cell = numberCell(100 * lost / before, QStringLiteral("%"));
    cell.shown += QStringLiteral(" %");
    return cell;
}

} // namespace

PassSums sumsOf(std::span<const Collision> pass) {
    PassSums sums;
    for (const PassBody& b : bodiesOf(pass)) {
        sums.mass += b.mass;
        sums.momentumBefore = sums.momentumBefore + b.mass * b.before;
        sums.momentumAfter = sums.momentumAfter + b.mass * b.after;
        sums.energyBefore += b.mass * dot(b.before, b.before) / 2;
        sums.energyAfter += b.mass * dot(b.after, b.after) / 2;
        sums.momentumScale += b.mass * (norm(b.before) + norm(b.after));
    }
    for (const Collision& c : pass)
        sums.energyLoss += c.steps.energyLoss;
    sums.wall = hasWall(pass);
    return sums;
}

std::optional<double> measuredRestitution(const PairCollision<double>& s) {
    const double before = s.rotated.first.x - s.rotated.second.x;
    if (before == 0)
        return std::nullopt;
    return -(s.exchanged.first.x - s.exchanged.second.x) / before;
}

std::vector<SheetColumn> bodyColumns() {
    return {{SheetText::tr("Body"), {}},
            {QStringLiteral("m"), QStringLiteral("kg")},
            {QStringLiteral("vx"), metresPerSecond},
            {QStringLiteral("vy"), metresPerSecond},
            {QStringLiteral("v"), metresPerSecond},
            {QStringLiteral("px"), momentumUnit},
            {QStringLiteral("py"), momentumUnit},
            {QStringLiteral("Ek"), joule}};
}

std::vector<SheetCell> bodyRow(const QString& name, double mass, const Vec2d& velocity, Ink ink) {
    std::vector<SheetCell> row{textCell(name, ink)};
    for (SheetCell& cell : valuesOf(mass, velocity))
        row.push_back(std::move(cell));
    return row;
}

std::vector<SheetCell> totalRow(double mass, const Vec2d& momentum, double energy, double scale) {
    std::vector<SheetCell> row{textCell(SheetText::tr("Total"), Ink::Plain, true)};
    for (SheetCell& cell : totalsOf(mass, momentum, energy, scale))
        row.push_back(std::move(cell));
    return row;
}

Sheet blockSheet(const Scene& scene, std::span<const Collision> collisions, std::size_t index) {
    const auto pass = passOf(collisions, index);
    const PassSums sums = sumsOf(pass);
    Sheet sheet{bodyColumns(), {}};
    for (const When when : {When::Before, When::After}) {
        const bool after = when == When::After;
        sheet.rows.push_back(heading(after ? SheetText::tr("After") : SheetText::tr("Before")));
        for (const PassBody& b : bodiesOf(pass))
            sheet.rows.push_back(bodyRow(bodyName(scene, b.body), b.mass, after ? b.after : b.before,
                                         inkOf(collisions[index], b.body, {})));
        sheet.rows.push_back(totalRow(sums.mass, after ? sums.momentumAfter : sums.momentumBefore,
                                      after ? sums.energyAfter : sums.energyBefore, sums.momentumScale));
    }
    return sheet;
}

Sheet narrowSheet(const Scene& scene, std::span<const Collision> collisions, std::size_t index) {
    const auto pass = passOf(collisions, index);
    const PassSums sums = sumsOf(pass);
    const std::vector<SheetColumn> names = bodyColumns();
    Sheet sheet{{{{}, {}}, {SheetText::tr("Before"), {}}, {SheetText::tr("After"), {}}}, {}};
    const auto block = [&](const std::vector<SheetCell>& before, const std::vector<SheetCell>& after) {
        for (std::size_t k = 0; k < before.size(); ++k)
            if (!before[k].shown.isEmpty())
                sheet.rows.push_back(
                    {textCell(columnTitle(names[k + 1])), before[k], after[k]}); // the first names the body
    };
    for (const PassBody& b : bodiesOf(pass)) {
        sheet.rows.push_back(heading(bodyName(scene, b.body)));
        sheet.rows.back()[0].ink = inkOf(collisions[index], b.body, {});
        block(valuesOf(b.mass, b.before), valuesOf(b.mass, b.after));
    }
    sheet.rows.push_back(heading(SheetText::tr("Total")));
    block(totalsOf(sums.mass, sums.momentumBefore, sums.energyBefore, sums.momentumScale),
          totalsOf(sums.mass, sums.momentumAfter, sums.energyAfter, sums.momentumScale));
    return sheet;
}

Sheet checkSheet(const Scene&, std::span<const Collision> collisions, std::size_t index) {
    const auto pass = passOf(collisions, index);
    const PassSums sums = sumsOf(pass);
    const PairCollision<double>& steps = collisions[index].steps;
    Sheet sheet{{{SheetText::tr("Check"), {}}, {SheetText::tr("Value"), {}}, {{}, {}}}, {}};
    sheet.rows.push_back({textCell(SheetText::tr("Energy lost")), withUnit(sums.energyLoss, joule),
                          share(sums.energyLoss, sums.energyBefore)});
    const auto measured = measuredRestitution(steps);
    SheetCell ratio = measured ? numberCell(*measured, {}) : textCell(QStringLiteral("—"));
    if (!ratio.hover.isEmpty())
        ratio.hover = SheetText::tr("−(relative velocity along x′ after)/(before) = %1").arg(ratio.hover);
    sheet.rows.push_back(check(SheetText::tr("e from the velocities"), std::move(ratio),
                               SheetText::tr("given: %1").arg(numberText(steps.restitution))));
    const Vec2d residual = residualOf(pass, sums);
    sheet.rows.push_back(momentumCheck(QStringLiteral("x"), residual.x, sums));
    sheet.rows.push_back(momentumCheck(QStringLiteral("y"), residual.y, sums));
    return sheet;
}

Sheet collisionRecord(const Scene& scene, std::span<const Collision> collisions, std::size_t index) {
    const auto pass = passOf(collisions, index);
    const PassSums sums = sumsOf(pass);
    const std::vector<SheetColumn> names = bodyColumns();
    Sheet sheet{{names[0], names[1]}, {}};
    for (const QString& when : {SheetText::tr("before"), SheetText::tr("after")})
        for (std::size_t k = 2; k < names.size(); ++k)
            sheet.columns.push_back({names[k].name + u' ' + when, names[k].unit});
    const auto join = [](std::vector<SheetCell> before, const std::vector<SheetCell>& after) {
        before.insert(before.end(), after.begin() + 2, after.end()); // its name and mass are there already
        return before;
    };
    for (const PassBody& b : bodiesOf(pass)) {
        const QString name = bodyName(scene, b.body);
        sheet.rows.push_back(
            join(bodyRow(name, b.mass, b.before, Ink::Plain), bodyRow(name, b.mass, b.after, Ink::Plain)));
    }
    sheet.rows.push_back(join(totalRow(sums.mass, sums.momentumBefore, sums.energyBefore, sums.momentumScale),
                              totalRow(sums.mass, sums.momentumAfter, sums.energyAfter, sums.momentumScale)));
    const auto line = [&](const QString& name, const SheetCell& value) {
        sheet.rows.push_back({textCell(name), value});
    };
    const Vec2d residual = residualOf(pass, sums);
    const auto measured = measuredRestitution(collisions[index].steps);
    sheet.rows.push_back({});
    line(SheetText::tr("Energy lost") + QStringLiteral(" [J]"), numberCell(sums.energyLoss, {}));
    line(SheetText::tr("Energy lost") + QStringLiteral(" [%]"), share(sums.energyLoss, sums.energyBefore));
    line(SheetText::tr("e from the velocities"), measured ? numberCell(*measured, {}) : SheetCell{});
    line(SheetText::tr("e, given"), numberCell(collisions[index].steps.restitution, {}));
    for (const auto& [axis, left] : {std::pair{"px", residual.x}, {"py", residual.y}})
        line(SheetText::tr("Σ%1 after − before").arg(QLatin1String(axis)) + QStringLiteral(" [kg·m/s]"),
             numberCell(left, {}));
    return sheet;
}

} // namespace thetalane

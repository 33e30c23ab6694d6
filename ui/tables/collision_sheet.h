// Before and after of one collision in rows and columns, all of it from what the engine wrote down. Of
// contacts that were resolved together it is the whole pass, each body once.
#pragma once

#include "core/engine/engine.h"
#include "ui/tables/sheet.h"

#include <optional>
#include <span>

namespace thetalane {

// Sums of a pass: momentum [kg·m/s], kinetic energy [J].
struct PassSums {
    double mass = 0; // [kg]
    Vec2d momentumBefore, momentumAfter;
    double energyBefore = 0, energyAfter = 0;
    double energyLoss = 0;    // as the engine has it
    double momentumScale = 0; // Σ m(|v| + |v′|): against it a residual is rounding or is not
    bool wall = false;        // one of them takes up momentum
};
PassSums sumsOf(std::span<const Collision> pass);

// −(va′ − vb′) after / before along x′; nothing where they did not approach.
std::optional<double> measuredRestitution(const PairCollision<double>& steps);

// Two blocks, before and after, a row a body; for a panel that is wide enough.
Sheet blockSheet(const Scene& scene, std::span<const Collision> collisions, std::size_t index);
// A block a body, a row a quantity, before beside after; for a narrow one.
Sheet narrowSheet(const Scene& scene, std::span<const Collision> collisions, std::size_t index);
// Energy lost, e against the velocities, and what rounding left of the momentum.
Sheet checkSheet(const Scene& scene, std::span<const Collision> collisions, std::size_t index);
// For files and the clipboard: a row a body, before and after side by side; the checks below.
Sheet collisionRecord(const Scene& scene, std::span<const Collision> collisions, std::size_t index);

// All bodies at one moment, and their sum; scale: Σ m|v|, against it a sum is rounding or is not.
std::vector<SheetColumn> bodyColumns();
std::vector<SheetCell> bodyRow(const QString& name, double mass, const Vec2d& velocity, Ink ink);
std::vector<SheetCell> totalRow(double mass, const Vec2d& momentum, double energy, double scale);

} // namespace thetalane

// The diagrams of the lab, and the row of the table behind each of their points.
#pragma once

#include "ui/lab/run_lab.h"
#include "ui/plot/study_plot.h"

#include <optional>
#include <vector>

namespace thetalane {

enum class Diagram {
    Point,         // what the preset is about
    WorkPrecision, // error against cost
    OverTime,      // error against time
};
std::vector<Diagram> diagramsOf(const LabPlan& plan); // the first is the one to begin with
QString diagramName(const LabPlan& plan, Diagram diagram);

struct LabPlot {
    Plot plot;
    std::vector<std::vector<std::optional<std::size_t>>> rows; // of each point of each series
};
LabPlot labPlot(const LabResult& result, Diagram diagram);

// The same wherever a row is drawn: colour, line, marker. No two rows of one family that are drawn over each
// other are alike.
MethodStyle rowStyle(const LabPlan& plan, std::size_t row);

} // namespace thetalane

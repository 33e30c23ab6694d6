// Runs what the lab was asked, on whatever thread calls it, and tells as it goes.
#pragma once

#include "core/study/parting.h"
#include "ui/lab/lab_plan.h"

#include <algorithm>
#include <memory>

namespace thetalane {

// One case as a row of the study computed it, to be drawn over the truth.
struct Ghost {
    std::size_t row = 0;
    std::shared_ptr<const Run> run;
    std::optional<Parting> parting;        // when and where it leaves the truth
    std::optional<std::size_t> difference; // the first contact that differs, as firstDifference() says
    std::optional<double> digits;          // left after its last contact, where that is known
};

struct Ghosts {
    std::size_t kase = 0;
    std::shared_ptr<const Run> truth;
    double until = 0;     // [s]
    double tolerance = 0; // [m]
    double shownAt = 0;   // a moment at which all that leave have left [s]
    std::vector<Ghost> all;

    double lastShown() const { return std::min(until, 2 * shownAt); } // [s]
};

struct LabResult {
    std::shared_ptr<const LabPlan> plan;
    StudyResult study; // a row each: of shifts, the results have the reference as their method
    std::shared_ptr<const Ghosts> ghosts; // null until they are drawn
    double part = 0;                      // of the work, about, 0 to 1
    double seconds = 0;                   // since it began
    bool ended = false;                   // StudyResult::cancelled says whether all is there
};
using LabNews = std::function<void(std::shared_ptr<const LabResult>)>;

// The last news is the ended result.
void runLab(std::shared_ptr<const LabPlan> plan, const LabNews& news, std::stop_token stop);

// Of the first case that comes out otherwise in the plan's telling row, up to `until`.
Ghosts drawGhosts(const LabPlan& plan, const StudyResult& result, std::stop_token stop);

} // namespace thetalane

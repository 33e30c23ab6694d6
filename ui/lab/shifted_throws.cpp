#include "ui/lab/shifted_throws.h"

#include "core/study/sum_up.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace thetalane {
namespace {

StudyResult emptyResult(const LabPlan& plan) {
    StudyResult result;
    result.until = result.untilAsked = plan.cases.until;
    result.casesAsked = plan.cases.scenes.size();
    result.truth = plan.options.methods.front();
    result.truthDigits = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < plan.shifts.size(); ++row)
        result.methods.emplace_back().method = result.truth;
    return result;
}

} // namespace

Scene shifted(Scene scene, double left) {
    scene.bodies.front().position.x -= left;
    return scene;
}

StudyResult studyShifts(const LabPlan& plan, const StudyReport& report, std::stop_token stop) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds often{100};
    StudyResult result = emptyResult(plan);
    std::vector<std::vector<CaseError>> errors(plan.shifts.size());
    auto told = Clock::now() - often;
    for (const Scene& scene : plan.cases.scenes) {
        if (stop.stop_requested())
            break;
        const Run truth = std::get<Run>(runMethod(result.truth, scene, result.until));
        for (std::size_t row = 0; row < plan.shifts.size(); ++row) {
            const auto run = runMethod(result.truth, shifted(scene, plan.shifts[row]), result.until);
            errors[row].push_back(compareRuns(truth, std::get<Run>(run), result.until));
        }
        ++result.cases;
        if (report && Clock::now() - told >= often) {
            for (std::size_t row = 0; row < plan.shifts.size(); ++row)
                sumUp(result.methods[row], errors[row]);
            report(result, {StudyStage::Errors, result.cases, result.casesAsked});
            told = Clock::now();
        }
    }
    for (std::size_t row = 0; row < plan.shifts.size(); ++row)
        sumUp(result.methods[row], errors[row]);
    result.cancelled = stop.stop_requested();
    return result;
}

} // namespace thetalane

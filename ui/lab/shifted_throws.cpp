#include "ui/lab/shifted_throws.h"

#include "core/study/compare_runs.h"
#include "core/study/measure_cost.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace thetalane {
namespace {

PositionError positionError(const std::vector<CaseError>& errors, std::size_t time) {
    std::vector<double> values;
    double squares = 0, worst = 0;
    for (const CaseError& e : errors) {
        values.push_back(e.position[time]);
        squares += e.position[time] * e.position[time];
        worst = std::max(worst, e.position[time]);
    }
    return {quartilesOf(std::move(values)).median, std::sqrt(squares / double(errors.size())), worst};
}

void sumUp(MethodResult& r, const std::vector<CaseError>& errors) {
    if (errors.empty())
        return;
    const double n = double(errors.size());
    r.state = MethodState::Measured;
    r.cases = errors.size();
    const auto mean = [&](auto value) {
        double sum = 0;
        for (const CaseError& e : errors)
            sum += double(value(e));
        return sum / n;
    };
    r.sameTouched = mean([](const CaseError& e) { return e.sameTouched; });
    r.sameDown = mean([](const CaseError& e) { return e.sameDown; });
    r.sameOrder = mean([](const CaseError& e) { return e.firstDifference < 0; });
    r.missed = mean([](const CaseError& e) { return e.missed; });
    r.repeated = mean([](const CaseError& e) { return e.repeated; });
    r.collisions = mean([](const CaseError& e) { return e.collisions; });
    std::vector<double> indices, times;
    for (const CaseError& e : errors)
        if (e.firstDifference >= 0) {
            indices.push_back(e.firstDifference);
            times.push_back(e.differenceTime);
        }
    r.firstDifference = quartilesOf(std::move(indices));
    r.differenceTime = quartilesOf(std::move(times));
    for (std::size_t k = 0; k < studyTimes; ++k)
        r.errors[k] = positionError(errors, k);
}

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

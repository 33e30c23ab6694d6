#include "core/study/sum_up.h"

#include "core/study/measure_cost.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

PositionError positionError(const std::vector<CaseError>& errors, std::size_t time) {
    std::vector<double> values;
    double sum = 0, worst = 0;
    for (const CaseError& e : errors) {
        values.push_back(e.position[time]);
        sum += e.position[time] * e.position[time];
        worst = std::max(worst, e.position[time]);
    }
    return {quartilesOf(std::move(values)).median, std::sqrt(sum / double(errors.size())), worst};
}

template <class Value> double meanOf(const std::vector<CaseError>& errors, Value&& value) {
    double sum = 0;
    for (const CaseError& e : errors)
        sum += double(value(e));
    return sum / double(errors.size());
}

template <class Value> double medianOf(const std::vector<CaseError>& errors, Value&& value) {
    std::vector<double> values;
    for (const CaseError& e : errors)
        values.push_back(value(e));
    return quartilesOf(std::move(values)).median;
}

} // namespace

void sumUp(MethodResult& r, const std::vector<CaseError>& errors) {
    r.cases = errors.size();
    if (errors.empty())
        return;
    r.state = MethodState::Measured;
    r.sameTouched = meanOf(errors, [](auto& e) { return e.sameTouched; });
    r.sameDown = meanOf(errors, [](auto& e) { return e.sameDown; });
    r.sameOrder = meanOf(errors, [](auto& e) { return e.firstDifference < 0; });
    r.missed = meanOf(errors, [](auto& e) { return e.missed; });
    r.repeated = meanOf(errors, [](auto& e) { return e.repeated; });
    r.collisions = meanOf(errors, [](auto& e) { return e.collisions; });
    r.energyDrift = medianOf(errors, [](auto& e) { return e.energyDrift; });
    r.momentumDrift = medianOf(errors, [](auto& e) { return e.momentumDrift; });
    std::int64_t right = 0;
    r.digitsAsked = 0;
    for (const CaseError& e : errors) {
        r.digitsAsked += e.digitsAsked;
        right += e.digitsRight;
    }
    r.digitsRight = r.digitsAsked > 0 ? double(right) / double(r.digitsAsked) : 0;
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

} // namespace thetalane

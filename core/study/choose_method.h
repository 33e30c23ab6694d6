// The cheapest method that keeps the error under a tolerance on this scene, decided by measurement.
#pragma once

#include "core/study/method.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace thetalane {

struct TriedMethod {
    Method method;
    double error = 0;     // the largest of any body at any of the times compared [m]
    double cost = 0;      // of the time measured [µs]
    bool within = false;  // error under the tolerance
    bool tooSlow = false; // not run: it would have taken longer than the best so far; cost is extrapolated
};

struct Choice {
    Method method;
    bool met = false;     // false: no method was within; `method` is the one with the smallest error
    double tolerance = 0; // m
    double until = 0;     // as far as it was measured [s]; may be less than asked, to be done in time
    double untilAsked = 0;
    Precision reference = Precision::Quad;
    std::vector<TriedMethod> tried; // from the cheapest to the dearest
    double seconds = 0;             // that the choice took
};

// Where the time asked for could not be measured whole, a method is within when its error is so small a part
// of the tolerance.
inline constexpr double roomToGrow = 1e-3;

// patience: about how long it may take [s]. Nothing for a tolerance or a time that is not positive.
std::optional<Choice> chooseMethod(const Scene& scene, double tolerance, double until, double patience = 2,
                                   std::stop_token stop = {});

} // namespace thetalane

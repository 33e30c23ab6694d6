// How far one run of a scene is from another that is taken for the truth.
#pragma once

#include "core/study/study.h"

namespace thetalane {

// Of one method on one case.
struct CaseError {
    bool sameTouched = false;
    bool sameDown = false;
    int firstDifference = -1; // among the truth's contacts; -1: none
    double differenceTime = 0;
    std::array<double, studyTimes> position{}; // rms over the bodies [m]
    double furthest = 0;                       // of any body at any of the times [m]
    double energyDrift = 0;
    double momentumDrift = 0;
    std::int64_t missed = 0;
    std::int64_t repeated = 0;
    std::int64_t collisions = 0;
    std::int64_t digitsAsked = 0; // collisions of which digitsLeft() says something
    std::int64_t digitsRight = 0; // and is within one digit of what is left
};

// Both with their lists of collisions; `run` may be of a scene with models left out.
CaseError compareRuns(const Run& truth, const Run& run, double until);

} // namespace thetalane

// What a study holds its methods against: as far as it can be had in the time allowed.
#pragma once

#include "core/study/study.h"

#include <memory>

namespace thetalane {

struct Truth {
    Method method;                    // as asked for, or in double where 113 bits are too dear
    double until = 0;                 // [s]; that far it got
    std::shared_ptr<const Run> first; // of the first case
};

// More bodies than this: 113 bits, which look at all pairs, would take minutes to begin.
inline constexpr std::size_t mostBodiesInQuad = 1000;

// patience: for the first case [s]; the others are taken to be alike.
Truth truthWithin(const StudyCases& cases, const Method& method, double patience, std::stop_token stop = {});

// One run of it on another case.
Run truthOf(const Truth& truth, const Scene& scene);

// About how long one run would take [s]; a few steps are run to find out where it might be long.
double expectedTime(const Method& method, const Scene& scene, double until);

} // namespace thetalane

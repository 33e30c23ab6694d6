// What a search for the earliest event answers.
#pragma once

#include "core/engine/surroundings.h"

namespace thetalane {

// What happens first, and whether another contact may happen at the same instant, within rounding: it need
// not, but where there is one, this is true.
template <class Real> struct FirstEvent {
    std::size_t body = 0;
    NextEvent<Real> event;
    bool tied = false;
};

// Times that differ by no more may be of the same instant.
template <class Real> Real tieWindow(const Real& time) {
    using std::abs;
    constexpr int roundings = sizeof(Real) < 8 ? 16 : 65536; // of a float few, or all were of one instant
    return abs(time) * (roundings * std::numeric_limits<Real>::epsilon());
}

} // namespace thetalane

// A body on its way, as those see it who ask what it will meet.
#pragma once

#include "core/math/vec2.h"

#include <limits>

namespace thetalane {

// How a body moves from now on.
template <class Real> struct Traveller {
    Vec2<Real> p, v, a;
    Real radius{};
    Real until = std::numeric_limits<Real>::infinity(); // the end of its stretch
};

} // namespace thetalane

// Two numbers side by side, on which a processor with vectors computes for the price of one, and to the same
// bits. With comparisons that give a mask, and `mask ? a : b` for each of the two.
#pragma once

namespace thetalane {

template <class Real> struct Pair { typedef Real Type __attribute__((vector_size(2 * sizeof(Real)))); };
template <class Real> using Two = typename Pair<Real>::Type;

} // namespace thetalane

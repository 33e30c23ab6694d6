// Two numbers side by side, on which a processor with vectors computes for the price of one, and to the same
// bits. With comparisons that give a mask, and `mask ? a : b` for each of the two.
#pragma once

#include <cstddef>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace thetalane {

template <class Real> struct Pair { typedef Real Type __attribute__((vector_size(2 * sizeof(Real)))); };
template <class Real> using Two = typename Pair<Real>::Type;

// Of a column of pairs: number i. The pair is written whole, so that reading it at once does not have to wait
// for a half.
template <class V, class Real> inline void putInto(V* column, std::size_t i, const Real& value) {
    V& couple = column[i / 2];
    couple = i % 2 == 0 ? V{value, couple[1]} : V{couple[0], value};
}

// Bit 0 and bit 1 of what a comparison gave.
template <class Mask> inline unsigned bitsOf(const Mask& mask) {
#if defined(__SSE2__)
    if constexpr (sizeof(Mask) == 16)
        return unsigned(_mm_movemask_pd(reinterpret_cast<const __m128d&>(mask)));
#endif
    return unsigned(mask[0] & 1) | unsigned(mask[1] & 2);
}

} // namespace thetalane

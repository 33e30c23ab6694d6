// The sizes that laying out the tree of hits and drawing it share, in pixels.
#pragma once

#include "ui/appearance.h"

#include <algorithm>

namespace thetalane::hittree {

inline constexpr double trunk = 6; // from a disc to the line that its other hits hang on
inline constexpr double headLength = 7;
inline constexpr int longestName = 4; // letters in a disc

inline double discSize(const Appearance& a) {
    return a.projector() ? 38 : 26;
}

inline double rowHeight(const Appearance& a) {
    return std::max(discSize(a) + a.unit(), 2.6 * a.pixels(Appearance::Size::Small) + a.unit());
}

inline double edgeSpace(const Appearance& a) {
    return a.unit() / 4.0;
}

} // namespace thetalane::hittree

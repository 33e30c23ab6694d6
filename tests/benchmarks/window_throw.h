// Frames and aiming in the window, off screen.
#pragma once

namespace thetalane::benchmarks {

// Two tables: frame by frame through the busiest second of a break and of a strike, and from a move of the
// mouse that aims until the lane is painted.
void throwTables(bool quick);

} // namespace thetalane::benchmarks

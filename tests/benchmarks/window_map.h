// How well the window answers while the strike map is computed in it, off screen.
#pragma once

namespace thetalane::benchmarks {

// A table: of each map the time until its first picture and until it is whole, and the longest that a timer
// of 1 ms waited meanwhile.
void mapTable(bool quick);

} // namespace thetalane::benchmarks

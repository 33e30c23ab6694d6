// The tables of thetalane_bench. `quick`: one short repetition of little work, only to see that all of it
// runs.
#pragma once

namespace thetalane::benchmarks {

void rackTable(bool quick);
void laneTable(bool quick);
void elevenTable(bool quick);
void gasTables(bool quick);
void searchTable(bool quick); // from how many bodies on the cells are cheaper than all pairs
void microTable(bool quick);
void longTable(bool quick);    // ten million collisions
void longRunTable(bool quick); // ten minutes of gas-1000 in bounded memory

} // namespace thetalane::benchmarks

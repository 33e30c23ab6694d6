// A Markdown table, printed row by row, and numbers as a reader wants them.
#pragma once

#include <string>
#include <vector>

namespace thetalane::benchmarks {

class Table {
public:
    // The first column is text, the others are numbers, to the right.
    Table(const std::string& title, const std::vector<std::string>& columns);
    void row(const std::vector<std::string>& cells);
};

std::string seconds(double s);     // 1.23 µs
std::string times(double ratio);   // 12.3
std::string percent(double share); // 4 %
std::string tiny(double x);        // 1.2e-13; "–" for what is not known
std::string whole(double x);       // 12,345

} // namespace thetalane::benchmarks

#include "tests/benchmarks/table.h"

#include <cmath>
#include <cstdio>

namespace thetalane::benchmarks {
namespace {

template <class... Values> std::string formatted(const char* format, Values... values) {
    char text[64];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

void print(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells)
        std::printf("| %s ", cell.c_str());
    std::puts("|");
}

} // namespace

Table::Table(const std::string& title, const std::vector<std::string>& columns) {
    std::printf("\n%s\n\n", title.c_str());
    print(columns);
    std::printf("|---");
    for (std::size_t k = 1; k < columns.size(); ++k)
        std::printf("|---:");
    std::puts("|");
}

void Table::row(const std::vector<std::string>& cells) {
    print(cells);
}

std::string seconds(double s) {
    if (s < 1e-6)
        return formatted("%.3g ns", s * 1e9);
    if (s < 0.9995e-3)
        return formatted("%.3g µs", s * 1e6);
    return s < 0.9995 ? formatted("%.3g ms", s * 1e3) : formatted("%.3g s", s);
}

std::string times(double ratio) {
    return ratio < 99.5 ? formatted("%.3g", ratio) : whole(ratio);
}

std::string percent(double share) {
    return formatted("%.0f %%", 100 * share);
}

std::string tiny(double x) {
    if (std::isnan(x))
        return "–";
    return x == 0                                      ? "0"
           : std::abs(x) >= 0.001 && std::abs(x) < 1e3 ? formatted("%.3g", x)
                                                       : formatted("%.1e", x);
}

std::string whole(double x) {
    std::string text = formatted("%.0f", x);
    for (auto k = std::ptrdiff_t(text.size()) - 3; k > 0; k -= 3)
        text.insert(std::size_t(k), ",");
    return text;
}

} // namespace thetalane::benchmarks

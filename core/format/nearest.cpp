#include "core/format/nearest.h"

#include <algorithm>
#include <vector>

namespace thetalane {
namespace {

constexpr std::size_t mostSlips = 2;

// Optimal string alignment distance, row by row.
std::size_t slips(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = last;
        last = row;
    }
    return last.back();
}

} // namespace

std::string nearest(std::string_view word, std::span<const std::string_view> known) {
    std::string_view best;
    std::size_t fewest = mostSlips + 1;
    for (const std::string_view candidate : known) {
        // Also keeps a key of a megabyte from being compared letter by letter.
        if (word.size() > candidate.size() + mostSlips || candidate.size() > word.size() + mostSlips)
            continue;
        const std::size_t n = slips(word, candidate);
        if (n < fewest && 2 * n < std::max(word.size(), candidate.size())) {
            fewest = n;
            best = candidate;
        }
    }
    return std::string(best);
}

} // namespace thetalane

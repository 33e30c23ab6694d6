// What somebody probably meant: the known word that a misspelt one is closest to.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace thetalane {

// The known word at most two slips (a letter too many, too few, wrong, or two swapped) from `word`, and fewer
// slips than half its letters; empty when none is that near.
std::string nearest(std::string_view word, std::span<const std::string_view> known);

} // namespace thetalane

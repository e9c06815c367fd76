#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// The candidate that takes the fewest insertions, removals and replacements of single bytes
/// (Levenshtein 1966) to reach from `word`, the first of equals; empty when none needs at most half
/// of the word's length. For messages such as "did you mean size_mm?".
std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace moontrace

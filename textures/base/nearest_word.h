#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// For messages such as "did you mean size_mm?": the shortest candidate that begins with `word`,
/// else the one that takes the fewest edits to reach from it, at most one for every three bytes of
/// the word: insertions, removals and replacements of single bytes and swaps of two neighbours
/// (optimal string alignment, Damerau 1964; the share is ours: with half a word changed, "grade2"
/// is near "greek"). The first of equals, empty when there is none.
std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates);

/// For names, whose beginnings may say little: the one of the fewest such edits, within the same
/// share, wherever they are; the first of equals, empty when there is none.
std::string NearestName(std::string_view word, const std::vector<std::string>& names);

}  // namespace moontrace

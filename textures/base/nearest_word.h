#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// For messages such as "did you mean size_mm?": the shortest candidate that begins with `word`,
/// else the one that takes the fewest edits to reach from it, at most one for each
/// `bytes_an_edit` of the word (above zero): insertions, removals and replacements of single bytes
/// and swaps of two neighbours (optimal string alignment, Damerau 1964). The first of equals, empty
/// when there is none.
std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates,
                        std::size_t bytes_an_edit = 2);

/// For names, whose beginnings may say little: the one of the fewest such edits, at most half of
/// the word's length, wherever they are; the first of equals, empty when there is none.
std::string NearestName(std::string_view word, const std::vector<std::string>& names);

}  // namespace moontrace

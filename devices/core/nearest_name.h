#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// The name that somebody who wrote `word` most likely meant: the one that takes the fewest
/// insertions, removals and replacements of single bytes (Levenshtein 1966), at most half of the
/// word's length; the first of equals, empty if there is none.
std::string NearestName(std::string_view word, const std::vector<std::string>& names);

}  // namespace moontrace

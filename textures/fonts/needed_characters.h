#pragma once

#include <set>
#include <string_view>

namespace moontrace {

/// Characters that a script of thousands must have for a text: the text's own without blanks and
/// controls, and those it may be folded to (fold.h): small letters, parts of Unicode's
/// compatibility decomposition. For loaders that read only what is needed. Throws InputError: text
/// that is not UTF-8 (line and column), or has nothing but blanks.
std::set<char32_t> NeededCharacters(std::string_view text);

}  // namespace moontrace

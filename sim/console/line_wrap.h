#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// Breaks at spaces so that no line passes `columns` characters (not bytes); a longer word stands
/// alone. A number stays on the line of the word behind it: "26 back", "12 mm". 0: nothing is
/// broken. Line ends in the text stay. Lines end with a newline each.
std::string Wrapped(std::string_view text, std::size_t columns = 80);

/// The sentences of a text, whose line ends are spaces: each ends in a full stop, an exclamation or
/// question mark, perhaps a closing quotation mark, before a space and a capital, a digit or an
/// opening quotation mark.
std::vector<std::string> Sentences(std::string_view text);

}  // namespace moontrace

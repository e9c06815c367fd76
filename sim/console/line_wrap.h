#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moontrace {

/// Breaks at spaces so that no line passes `columns` characters (not bytes); a longer word stands
/// alone. Lines end with a newline each.
std::string Wrapped(std::string_view text, std::size_t columns = 80);

}  // namespace moontrace

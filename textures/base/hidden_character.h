#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// Characters that must not pass from foreign text into a line for people: controls, marks that
/// turn the direction of writing, what has no width, line and paragraph separators, tags, and
/// private use, which everybody's font draws otherwise (Unicode's categories Cc, Cf, Zl, Zp, Co,
/// and noncharacters).
bool IsHidden(char32_t code) noexcept;

/// Well-formed UTF-8 has one of them.
bool HasHidden(std::string_view utf8) noexcept;

/// Each of them made a "?". `utf8` is well-formed.
std::string HiddenShown(std::string_view utf8);

}  // namespace moontrace

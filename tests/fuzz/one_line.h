#pragma once

#include <cstdlib>
#include <string_view>

namespace moontrace {

/// A refusal is one line, and says something.
inline void MustBeOneLine(std::string_view line) {
  if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
}

}  // namespace moontrace

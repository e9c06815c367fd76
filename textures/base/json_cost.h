#pragma once

#include <cstddef>
#include <string_view>

namespace moontrace {

/// What parsing a JSON text would cost, counted from its bytes in one pass: each value takes many
/// times its text, destructors recurse, and a parser that is asked to count by itself walks an
/// array again for every object in it.
struct JsonCost {
  std::size_t depth = 0;   ///< brackets within brackets; 1 of a flat object
  std::size_t values = 1;  ///< no fewer than there are, keys and objects' ends counted too
};

/// Any bytes may be given; those that are no JSON have some cost as well.
JsonCost CostOf(std::string_view json) noexcept;

}  // namespace moontrace

#include "textures/base/json_cost.h"

#include <algorithm>

namespace moontrace {

JsonCost CostOf(std::string_view json) noexcept {
  JsonCost cost;
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    switch (json[i]) {
      case '"':
        quoted = !quoted;
        break;
      case '\\':
        i += quoted ? 1 : 0;  // what is escaped ends no text
        break;
      case '{':
      case '[':
        if (quoted) break;
        cost.depth = std::max(cost.depth, ++depth);
        cost.values += 2;
        break;
      case '}':
      case ']':
        if (!quoted && depth > 0) --depth;
        break;
      case ',':
      case ':':
        if (!quoted) ++cost.values;
        break;
      default:
        break;
    }
  }
  return cost;
}

}  // namespace moontrace

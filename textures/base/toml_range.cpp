#include "textures/base/toml_range.h"

#include <fmt/core.h>

namespace moontrace {

double InRange(const TomlTable& table, const std::string& key, double value, double low,
               double high) {
  if (!(value >= low && value <= high)) {
    table.Fail(key, fmt::format("{:.6g} is out of range: give {:.6g} to {:.6g}", value, low, high));
  }
  return value;
}

}  // namespace moontrace

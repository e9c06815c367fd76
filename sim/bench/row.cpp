#include "sim/bench/row.h"

#include <fmt/format.h>

namespace moontrace {

BenchRow AtMost(std::string name, double value, std::string unit, double most) {
  return {std::move(name), value, std::move(unit), fmt::format("at most {:g}", most),
          value <= most};
}

BenchRow AtLeast(std::string name, double value, std::string unit, double least) {
  return {std::move(name), value, std::move(unit), fmt::format("at least {:g}", least),
          value >= least};
}

}  // namespace moontrace

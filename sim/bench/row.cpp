#include "sim/bench/row.h"

#include "sim/console/wording.h"

namespace moontrace {

BenchRow AtMost(std::string name, double value, std::string unit, double most) {
  return {std::move(name), value, std::move(unit), "at most " + say::Plain(most), value <= most};
}

BenchRow AtLeast(std::string name, double value, std::string unit, double least) {
  return {std::move(name), value, std::move(unit), "at least " + say::Plain(least), value >= least};
}

}  // namespace moontrace

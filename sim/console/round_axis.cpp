#include "sim/console/round_axis.h"

#include <algorithm>
#include <cmath>

namespace moontrace {

std::vector<double> RoundAxis(double most, double least) {
  constexpr double kMostSteps = 4;
  const double top = std::max(most, least);
  double step = std::pow(10, std::floor(std::log10(top / kMostSteps)));
  for (const double factor : {2.0, 2.5, 2.0}) {  // 1, 2, 5, 10
    if (kMostSteps * step >= top * (1 - 1e-9)) break;
    step *= factor;
  }
  std::vector<double> numbers;
  for (int i = 0; i == 0 || numbers.back() < top * (1 - 1e-9); ++i) numbers.push_back(i * step);
  return numbers;
}

}  // namespace moontrace

#pragma once

#include <vector>

namespace moontrace {

/// Where the numbers of an axis stand, from 0: steps of 1, 2 or 5 times a power of ten, at most
/// four of them, the last not below `most` and `least` (above 0).
std::vector<double> RoundAxis(double most, double least);

}  // namespace moontrace

#pragma once

#include <cstddef>
#include <vector>

namespace moontrace {

/// The union of intervals of a line's arc length: which parts of it have been covered. Exact;
/// keeps disjoint intervals only, so that covering the same part again costs nothing.
class CoveredLength {
 public:
  /// Allocates nothing until more than `capacity` disjoint intervals are held.
  explicit CoveredLength(std::size_t capacity) { intervals_.reserve(capacity); }

  /// Adds [begin, end] [m]; nothing when end < begin.
  void Add(double begin, double end);

  /// Length of the union [m].
  double Total() const noexcept;

 private:
  struct Interval {
    double begin = 0, end = 0;
  };
  std::vector<Interval> intervals_;  ///< ascending, none touching the next
};

}  // namespace moontrace

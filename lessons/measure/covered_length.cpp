#include "lessons/measure/covered_length.h"

#include <algorithm>
#include <iterator>

namespace moontrace {

void CoveredLength::Add(double begin, double end) {
  if (!(end >= begin)) return;
  // The first that reaches up to `begin`; it and those after it may meet the new one.
  const auto first =
      std::lower_bound(intervals_.begin(), intervals_.end(), begin,
                       [](const Interval& interval, double at) { return interval.end < at; });
  if (first == intervals_.end() || first->begin > end) {
    intervals_.insert(first, {begin, end});
    return;
  }
  first->begin = std::min(first->begin, begin);
  if (end <= first->end) return;
  first->end = end;
  auto next = std::next(first);
  for (; next != intervals_.end() && next->begin <= end; ++next) {
    first->end = std::max(end, next->end);
  }
  intervals_.erase(std::next(first), next);
}

double CoveredLength::Total() const noexcept {
  double total = 0;
  for (const Interval& interval : intervals_) total += interval.end - interval.begin;
  return total;
}

}  // namespace moontrace

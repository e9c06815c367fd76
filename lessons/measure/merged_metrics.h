#pragma once

#include <vector>

#include "lessons/measure/scoring.h"

namespace moontrace {

/// A page's total and its weight: the length of its strokes, a dot counting one width [m].
struct PageMetrics {
  TraceMetrics total;
  double stroke_length = 0;
};

/// Totals of pages traced one after the other: figures of strokes weighted by their length,
/// where any was followed (coverage: all), forces and speed by the time in contact, other figures
/// of time by duration, sums of counts and times, greatest of greatest values.
TraceMetrics MergedMetrics(const std::vector<PageMetrics>& pages);

}  // namespace moontrace

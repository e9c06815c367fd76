#include "lessons/measure/shape_distance.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>

namespace moontrace {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

using Points = std::vector<glm::dvec2>;

/// Greatest distance of a point of `a` to the nearest of `b`.
double Farthest(const Points& a, const Points& b) {
  double farthest = 0;
  for (const glm::dvec2 p : a) {
    double nearest = kFar;
    for (const glm::dvec2 q : b) nearest = std::min(nearest, glm::distance(p, q));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// Both recurrences over the table of pairs, one row kept.
ShapeDistance InOrder(const Points& a, const Points& b) {
  std::vector<double> warped(b.size(), kFar), leash(b.size(), kFar);
  for (std::size_t i = 0; i < a.size(); ++i) {
    double warped_corner = kFar, leash_corner = kFar;  // of the pair (i - 1, j - 1)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double d = glm::distance(a[i], b[j]);
      const bool first = i == 0 && j == 0;
      const double warped_left = j > 0 ? warped[j - 1] : kFar;
      const double leash_left = j > 0 ? leash[j - 1] : kFar;
      const double straight = std::min(warped[j], warped_left) + d;
      const double reached = std::min({leash[j], leash_left, leash_corner});
      const double next = first ? 2 * d : std::min(straight, warped_corner + 2 * d);
      warped_corner = warped[j];
      leash_corner = leash[j];
      warped[j] = next;
      leash[j] = first ? d : std::max(reached, d);
    }
  }
  return {warped.back() / static_cast<double>(a.size() + b.size()), leash.back(), 0};
}

}  // namespace

ShapeDistance ShapeDistanceOf(const Points& a, const Points& b) {
  if (a.empty() || b.empty()) return {};
  ShapeDistance distance = InOrder(a, b);
  distance.hausdorff = std::max(Farthest(a, b), Farthest(b, a));
  return distance;
}

Points Resampled(const Points& points, std::size_t count) {
  if (points.empty() || count == 0) return {};
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i], points[i - 1]);
  Points even{points.front()};
  double passed = 0;  // length before points[i - 1]
  std::size_t i = 1;
  while (even.size() + 1 < count) {
    const double s = length * static_cast<double>(even.size()) / static_cast<double>(count - 1);
    double step = 0;
    while (i < points.size()) {
      step = glm::distance(points[i], points[i - 1]);
      if (passed + step >= s) break;
      passed += step;
      ++i;
    }
    if (i >= points.size()) break;  // rounding at the end
    even.push_back(step > 0 ? glm::mix(points[i - 1], points[i], (s - passed) / step) : points[i]);
  }
  while (even.size() < count) even.push_back(points.back());
  return even;
}

}  // namespace moontrace

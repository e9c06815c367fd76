#include "lessons/measure/tip_way.h"

#include <glm/geometric.hpp>

namespace moontrace {

void TipWay::Add(glm::dvec2 p) {
  newest_ = p;
  if (!points_.empty() && glm::distance(points_.back(), p) < spacing_) return;
  points_.push_back(p);
  if (points_.size() < kMost) return;
  for (std::size_t i = 0; i < kMost / 2; ++i) points_[i] = points_[2 * i];
  points_.resize(kMost / 2);
  spacing_ *= 2;
}

std::vector<glm::dvec2> TipWay::Points() const {
  std::vector<glm::dvec2> points = points_;
  if (!points.empty() && points.back() != newest_) points.push_back(newest_);
  return points;
}

}  // namespace moontrace

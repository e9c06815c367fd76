#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {

/// How far one path is from another, both as points in order [m]. Symmetric; 0 for the same points.
/// All zero where either has no point.
struct ShapeDistance {
  /// Dynamic time warping: mean distance of the points matched in order so that it is least (Sakoe
  /// and Chiba 1978, symmetric form: a diagonal step counts twice, the sum is over both counts).
  double warped = 0;
  double frechet = 0;    ///< discrete: shortest leash on which both paths can be walked
  double hausdorff = 0;  ///< greatest distance of a point to the other path's points; no order
};
ShapeDistance ShapeDistanceOf(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b);

/// `count` points evenly along a polyline, both its ends among them; empty for no points.
std::vector<glm::dvec2> Resampled(const std::vector<glm::dvec2>& points, std::size_t count);

}  // namespace moontrace

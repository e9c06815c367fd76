#include "tests/textures/stroke_distance.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "textures/field/element.h"

namespace moontrace {

double DistanceToPolyline(glm::dvec2 p, const std::vector<glm::dvec2>& points) {
  double least = glm::length(p - points.front());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::dvec2 along = points[i + 1] - points[i];
    const double length2 = glm::dot(along, along);
    const double t =
        length2 > 0 ? std::clamp(glm::dot(p - points[i], along) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(p - points[i] - t * along));
  }
  return least;
}

double DistanceOf(const Stroke& stroke, const std::vector<glm::dvec2>& points) {
  constexpr int kSamples = 64;
  double most = 0;
  for (const Piece& piece : stroke.pieces) {
    for (int i = 0; i <= kSamples; ++i) {
      most =
          std::max(most, DistanceToPolyline(PointAt(piece, Length(piece) * i / kSamples), points));
    }
  }
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    for (int i = 0; i <= kSamples; ++i) {
      const glm::dvec2 p = points[k] + (points[k + 1] - points[k]) * (double(i) / kSamples);
      double least = 1e300;
      for (const Piece& piece : stroke.pieces) least = std::min(least, DistanceTo(piece, p));
      most = std::max(most, least);
    }
  }
  return most;
}

double DistanceOf(const Stroke& from, const Stroke& to) {
  double most = 0;
  for (const Piece& piece : from.pieces) {
    for (int i = 0; i <= 32; ++i) {
      const glm::dvec2 p = PointAt(piece, Length(piece) * i / 32);
      double least = 1e300;
      for (const Piece& other : to.pieces) least = std::min(least, DistanceTo(other, p));
      most = std::max(most, least);
    }
  }
  return most;
}

}  // namespace moontrace

#include "textures/fonts/polyline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "textures/fonts/arc_fit.h"

namespace moontrace {
namespace {

constexpr double kSharpest = std::numbers::pi / 3;  ///< bend that is still rounded [rad]
constexpr double kStraight = 1e-6;                  ///< bend that needs no rounding [rad]

/// How much of both lines the fillet at `corner` uses; 0 for none.
double FilletReach(glm::dvec2 before, glm::dvec2 corner, glm::dvec2 behind, double tolerance) {
  const glm::dvec2 in = corner - before, out = behind - corner;
  const double bend = std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
  if (bend < kStraight || bend > kSharpest) return 0;
  const double radius = tolerance / (1 / std::cos(bend / 2) - 1);
  const double room = 0.5 * std::min(glm::length(in), glm::length(out));
  return std::min(radius * std::tan(bend / 2), room);
}

}  // namespace

std::vector<Piece> RoundedPolyline(const std::vector<glm::dvec2>& points, double tolerance) {
  std::vector<glm::dvec2> p;
  for (const glm::dvec2 point : points) {
    if (p.empty() || point != p.back()) p.push_back(point);
  }
  std::vector<Piece> pieces;
  if (p.size() < 2) return pieces;
  const auto add_line = [&pieces](glm::dvec2 from, glm::dvec2 to) {
    // Fillets that meet in the middle of a line leave rounding errors between them.
    if (glm::length(to - from) > 1e-12) pieces.emplace_back(Line{from, to});
  };
  glm::dvec2 at = p.front();
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double reach = FilletReach(p[i - 1], p[i], p[i + 1], tolerance);
    if (reach <= 0) {
      add_line(at, p[i]);
      at = p[i];
      continue;
    }
    const glm::dvec2 in = glm::normalize(p[i] - p[i - 1]);
    const glm::dvec2 from = p[i] - reach * in;
    const glm::dvec2 to = p[i] + reach * glm::normalize(p[i + 1] - p[i]);
    add_line(at, from);
    pieces.push_back(ArcByTangent(from, in, to, 0));
    at = to;
  }
  add_line(at, p.back());
  return pieces;
}

}  // namespace moontrace

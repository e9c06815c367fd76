#include "textures/typeset/arc_line_arc.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace moontrace {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kNoTurn = 1e-7;  // [rad]; what rounding leaves of a turn that is none

glm::dvec2 LeftOf(glm::dvec2 v) { return {-v.y, v.x}; }

/// The two turns and the straight part between them.
struct Parts {
  bool exists = false;
  glm::dvec2 from_center{0, 0}, to_center{0, 0};
  glm::dvec2 straight{0, 0};            // unit
  double from_sweep = 0, to_sweep = 0;  // signed
  double length = 0;                    // of the straight part
  double whole = 0;
};

/// The turn from one direction to another in the sense of `radius`.
double SweepBetween(glm::dvec2 from, glm::dvec2 to, double radius) {
  const double angle = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  double sweep = radius > 0 ? angle : -angle;
  if (sweep < 0) sweep += kTurn;
  if (sweep < kNoTurn || sweep > kTurn - kNoTurn) sweep = 0;
  return radius > 0 ? sweep : -sweep;
}

Parts PartsOf(const Ray& from, const Ray& to, double from_radius, double to_radius) {
  Parts parts;
  parts.from_center = from.point + from_radius * LeftOf(from.direction);
  parts.to_center = to.point + to_radius * LeftOf(to.direction);
  // The common tangent: it lies `from_radius` to the right of one centre, `to_radius` of the other.
  const glm::dvec2 v = parts.to_center - parts.from_center;
  const double k = to_radius - from_radius;
  const double square = glm::dot(v, v), left = square - k * k;
  if (!(square > 0 && left >= 0)) return parts;
  parts.length = std::sqrt(left);
  parts.straight = glm::normalize((parts.length * v - k * LeftOf(v)) / square);
  parts.from_sweep = SweepBetween(from.direction, parts.straight, from_radius);
  parts.to_sweep = SweepBetween(parts.straight, to.direction, to_radius);
  parts.whole = std::abs(from_radius * parts.from_sweep) + parts.length +
                std::abs(to_radius * parts.to_sweep);
  parts.exists = parts.whole > 0;
  return parts;
}

/// The arc that begins at `p` on the circle.
Arc ArcFrom(glm::dvec2 center, double radius, glm::dvec2 p, double sweep) {
  return {center, std::abs(radius), std::atan2(p.y - center.y, p.x - center.x), sweep};
}

}  // namespace

double ArcLineArcLength(const Ray& from, const Ray& to, double from_radius, double to_radius) {
  const Parts parts = PartsOf(from, to, from_radius, to_radius);
  return parts.exists ? parts.whole : std::numeric_limits<double>::infinity();
}

std::vector<Piece> ArcLineArc(const Ray& from, const Ray& to, double from_radius,
                              double to_radius) {
  const Parts parts = PartsOf(from, to, from_radius, to_radius);
  std::vector<Piece> pieces;
  if (!parts.exists) return pieces;
  const glm::dvec2 right = -LeftOf(parts.straight);
  const glm::dvec2 begin =
      parts.from_sweep == 0 ? from.point : parts.from_center + from_radius * right;
  const glm::dvec2 end = parts.to_sweep == 0 ? to.point : parts.to_center + to_radius * right;
  if (parts.from_sweep != 0) {
    pieces.push_back(ArcFrom(parts.from_center, from_radius, from.point, parts.from_sweep));
  }
  const double none = 1e-9 * parts.whole;
  if (parts.length > none) pieces.push_back(Line{begin, end});
  if (parts.to_sweep != 0) {
    pieces.push_back(ArcFrom(parts.to_center, to_radius, end, parts.to_sweep));
  }
  return pieces;
}

}  // namespace moontrace

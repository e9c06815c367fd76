#include "textures/script/svg_arc.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace moontrace {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

glm::dvec2 Turned(glm::dvec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace

EllipseArc ByCenter(const SvgArc& arc) {
  // In the frame of the ellipse, scaled to a unit circle, the chord's midpoint is the origin.
  glm::dvec2 radii = arc.radii;
  glm::dvec2 half = Turned(0.5 * (arc.from - arc.to), -arc.turn) / radii;
  const double half_length = glm::length(half);
  if (half_length > 1) {
    radii *= half_length;
    half /= half_length;
  }
  const double rise = std::sqrt(std::max(0.0, 1 / glm::dot(half, half) - 1));
  const double side = arc.large == arc.positive ? -1 : 1;
  const glm::dvec2 center = side * rise * glm::dvec2(half.y, -half.x);
  const glm::dvec2 first = half - center, last = -half - center;

  EllipseArc out;
  out.radii = radii;
  out.turn = arc.turn;
  out.center = 0.5 * (arc.from + arc.to) + Turned(center * radii, arc.turn);
  out.start = std::atan2(first.y, first.x);
  out.sweep = std::atan2(last.y, last.x) - out.start;
  if (arc.positive && out.sweep <= 0) out.sweep += kTurn;
  if (!arc.positive && out.sweep >= 0) out.sweep -= kTurn;
  return out;
}

Curve CurveOf(const EllipseArc& arc) {
  return {[arc](double t) {
            const double angle = arc.start + t * arc.sweep;
            const glm::dvec2 unit(std::cos(angle), std::sin(angle));
            return arc.center + Turned(arc.radii * unit, arc.turn);
          },
          [arc](double t) {
            const double angle = arc.start + t * arc.sweep;
            const glm::dvec2 unit(-std::sin(angle), std::cos(angle));
            return Turned(arc.sweep * arc.radii * unit, arc.turn);
          }};
}

}  // namespace moontrace

#pragma once

#include <cmath>
#include <vector>

#include "textures/field/piece.h"

namespace moontrace {

/// A part of an outline that only rises or only falls, made for counting crossings.
struct RisingEdge {
  double y_low = 0, y_high = 0;  ///< [m]
  double x_low = 0, x_high = 0;  ///< at these heights [m]
  glm::dvec2 center{0, 0};       ///< of an arc [m]
  double radius = 0;             ///< 0: straight; below zero: on the left half of its circle [m]
};

/// Cuts an outline at its arcs' highest and lowest points.
std::vector<RisingEdge> RisingEdges(const std::vector<Piece>& outline);

/// Whether a ray from `p` towards +x crosses the edge; half-open in y, so that a corner counts
/// once.
inline bool Crosses(const RisingEdge& edge, glm::dvec2 p) noexcept {
  if (p.y < edge.y_low || p.y >= edge.y_high) return false;
  if (edge.radius != 0) {
    const double dy = p.y - edge.center.y;
    const double half_chord = std::sqrt(std::fmax(0.0, edge.radius * edge.radius - dy * dy));
    return p.x < edge.center.x + (edge.radius > 0 ? half_chord : -half_chord);
  }
  const double share = (p.y - edge.y_low) / (edge.y_high - edge.y_low);
  return p.x < edge.x_low + share * (edge.x_high - edge.x_low);
}

/// Whether `p` lies within a closed outline of lines and arcs (even-odd rule). Points on the
/// outline belong to either side.
bool IsInside(const std::vector<Piece>& outline, glm::dvec2 p);

}  // namespace moontrace

#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// A plane curve over t in [0, 1]; any unit of length. The derivative may vanish (cusps, doubled
/// control points): directions are then taken from points close by.
struct Curve {
  std::function<glm::dvec2(double)> point;
  std::function<glm::dvec2(double)> derivative;
};

/// A cubic Bezier curve by its four control points.
Curve CubicCurve(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3);

/// The arc from `p` along the unit direction `tangent` to `q`; a line where it is flatter than
/// `flat` (height of the arc over its chord).
Piece ArcByTangent(glm::dvec2 p, glm::dvec2 tangent, glm::dvec2 q, double flat);

/// Replaces a curve by lines and arcs that lie within `tolerance` of it and join without a kink:
/// biarcs (two arcs that share the end tangents; K. M. Bolton, "Biarc curves", 1975, with equal
/// tangent lengths), halving the range of t until they fit. First and last points are the curve's.
std::vector<Piece> FitArcs(const Curve& curve, double tolerance);

/// Joins neighbours that continue each other: collinear lines to one line, arcs to one arc through
/// the first, the middle and the last point, where that arc lies within `tolerance` of what it
/// replaces. Arcs of the very same circle keep its centre and radius exactly; two half circles
/// become one whole circle (|sweep| = 2 pi). Corners stay.
std::vector<Piece> MergePieces(const std::vector<Piece>& pieces, double tolerance);

}  // namespace moontrace

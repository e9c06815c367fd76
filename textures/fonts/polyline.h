#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// Lines through the points, any unit of length; where the polyline bends by less than 60 degrees
/// its corner is rounded by an arc that touches both lines (so that the direction is continuous)
/// and lies within `tolerance` of them, since such corners only stand for a curve. Sharper ones,
/// and the joint of a closed polyline, stay. Points equal to the one before are dropped; the first
/// and the last point stay. Empty for fewer than two different points.
///
/// A fillet of radius R at a bend by the angle a passes the corner at R (1 / cos(a/2) - 1) and uses
/// R tan(a/2) of both lines: R is the greatest for which the first stays within the tolerance and
/// the second within half a line.
std::vector<Piece> RoundedPolyline(const std::vector<glm::dvec2>& points, double tolerance);

/// How far strokes may leave the polylines that they are made of [em]: 0.04 mm at letters of
/// 20 mm.
constexpr double kPolylineTolerance = 0.002;

}  // namespace moontrace

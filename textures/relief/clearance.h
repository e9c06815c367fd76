#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/piece.h"

namespace moontrace {

/// A line or an arc with what distances and crossings ask of it worked out, so that they need no
/// angle.
struct Curve {
  glm::dvec2 from{0, 0}, to{0, 0};  ///< [m]
  glm::dvec2 center{0, 0};          ///< of an arc [m]
  double radius = 0;                ///< [m]; zero for a line
  /// Unit directions from the centre to an arc's ends, the second counter-clockwise from the first.
  glm::dvec2 first{1, 0}, last{1, 0};
  bool turns_left = true;  ///< an arc that is travelled counter-clockwise
  bool is_long = false;    ///< an arc of more than half a turn
  bool is_whole = false;   ///< of a whole one
  Box box;
};

Curve CurveOf(const Piece& piece);
std::vector<Curve> CurvesOf(const std::vector<Piece>& pieces);
Curve Moved(const Curve& curve, glm::dvec2 by);
/// An arc of radius above zero by its ends; `sweep` [rad], signed, says which way and how far.
Curve ArcCurve(glm::dvec2 center, double radius, glm::dvec2 from, glm::dvec2 to, double sweep);
Curve LineCurve(glm::dvec2 from, glm::dvec2 to);

/// Unit direction of travel at an end of a curve of some length.
glm::dvec2 WayAtStart(const Curve& curve);
glm::dvec2 WayAtEnd(const Curve& curve);

/// Distance of a point to the nearest of a curve [m].
double DistanceTo(const Curve& curve, glm::dvec2 p);

/// Least distance of two curves [m], zero where they cross. In closed form.
double DistanceBetween(const Curve& a, const Curve& b);

}  // namespace moontrace

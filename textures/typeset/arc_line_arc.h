#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// A place and a direction of travel through it.
struct Ray {
  glm::dvec2 point{0, 0};      ///< [m]
  glm::dvec2 direction{1, 0};  ///< unit
};

/// The way from one ray to another that turns on a circle, goes straight and turns on a second
/// circle (the outer four of Dubins' ways, 1957, here with two radii). Radii [m] are signed: above
/// zero the circle is travelled counter-clockwise. The first piece leaves in `from`'s direction,
/// the last arrives in `to`'s, joints have no corner. Pieces of no length are left out. Empty
/// where the circles lie so that there is no such way, and between equal rays.
std::vector<Piece> ArcLineArc(const Ray& from, const Ray& to, double from_radius, double to_radius);

/// Its length alone [m]; infinite where there is none.
double ArcLineArcLength(const Ray& from, const Ray& to, double from_radius, double to_radius);

}  // namespace moontrace

#pragma once

#include <glm/vec2.hpp>

namespace moontrace {

/// Displacement of the surface along its normal, and the derivative along x and y.
struct Sample {
  double displacement = 0;        ///< [m], below zero in grooves
  glm::dvec2 gradient{0.0, 0.0};  ///< [m/m]
};

}  // namespace moontrace

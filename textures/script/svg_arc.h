#pragma once

#include <glm/vec2.hpp>

#include "textures/script/arc_fit.h"

namespace moontrace {

/// An elliptical arc as SVG writes it: from end to end with radii, turn and two choices.
struct SvgArc {
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
  glm::dvec2 radii{0, 0};  ///< magnitudes, > 0
  double turn = 0;         ///< of the ellipse's x axis [rad]
  bool large = false;      ///< the longer way round
  bool positive = false;   ///< towards growing angles
};

/// The same arc by its centre (SVG 1.1, appendix F.6.5; radii that are too small grow, F.6.6).
struct EllipseArc {
  glm::dvec2 center{0, 0};
  glm::dvec2 radii{0, 0};
  double turn = 0;   ///< [rad]
  double start = 0;  ///< parameter angle [rad]
  double sweep = 0;  ///< [rad], never zero
};
/// `from` and `to` must differ.
EllipseArc ByCenter(const SvgArc& arc);

/// The arc over t in [0, 1].
Curve CurveOf(const EllipseArc& arc);

}  // namespace moontrace

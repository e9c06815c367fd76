#pragma once

#include <glm/vec2.hpp>
#include <variant>
#include <vector>

#include "textures/field/piece.h"
#include "textures/field/profile.h"

namespace moontrace {

/// The circle of radius zero: caps line ends and rounds corners.
struct Dot {
  glm::dvec2 center{0, 0};
  bool operator==(const Dot&) const = default;
};

/// The area within a closed outline (each piece starts where the one before ends).
struct Fill {
  std::vector<Piece> outline;
  bool operator==(const Fill&) const = default;
};

using Shape = std::variant<Line, Arc, Dot, Fill>;

/// How an element becomes smaller along its spine: its profile at a distance d is q^2 h(d/q), so
/// that width and rounding are q times and the depth q^2 times the profile's: the curvature stays,
/// the slope is q times as steep. q goes by the smooth step (C1, level at both ends) from its value
/// at the start to that at the end, both above 0 and at most 1. For lines and arcs of less than a
/// turn; other shapes have none. Ours.
struct Fade {
  double from = 1;
  double to = 1;
  bool operator==(const Fade&) const = default;
  bool IsNone() const { return from == 1 && to == 1; }
};

/// An elementary texture (the paper, section 4): a shape with its cross-section.
struct Element {
  Shape shape;
  Profile profile;
  Fade fade{};
};

/// Where the element can be other than zero.
Box BoundsOf(const Element& element);

/// Magnitude of an element's displacement and its gradient.
struct Magnitude {
  double height = 0;              ///< [m], >= 0
  glm::dvec2 gradient{0.0, 0.0};  ///< [m/m]
};
/// Displacement of the surface along its normal, and the derivative along x and y.
struct Sample {
  double displacement = 0;        ///< [m], below zero in grooves
  glm::dvec2 gradient{0.0, 0.0};  ///< [m/m]
};
/// The element's own magnitude at `p`, in the element's frame; zero where it does not reach. The
/// plain definition that the compiled field is tested against.
Magnitude Evaluate(const Element& element, glm::dvec2 p);

}  // namespace moontrace

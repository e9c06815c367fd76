#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "textures/field/profile.h"

namespace moontrace {

/// An axis-aligned rectangle; empty while min > max.
struct Box {
  glm::dvec2 min{1e300, 1e300};
  glm::dvec2 max{-1e300, -1e300};
  bool operator==(const Box&) const = default;
};
void Include(Box& box, glm::dvec2 p);
void Include(Box& box, const Box& other);
Box Grown(const Box& box, double by);
Box Moved(const Box& box, glm::dvec2 by);
bool Contains(const Box& box, glm::dvec2 p) noexcept;
bool Overlap(const Box& a, const Box& b) noexcept;

/// A straight line between two points, butt ends: it covers only points whose foot lies on it.
struct Line {
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
  bool operator==(const Line&) const = default;
};

/// A piece of a circle from angle `start` through `sweep` [rad], counter-clockwise positive, butt
/// ends. |sweep| >= 2 pi is the whole circle.
struct Arc {
  glm::dvec2 center{0, 0};
  double radius = 0;  ///< > 0
  double start = 0;
  double sweep = 0;
  bool operator==(const Arc&) const = default;
};

/// The circle of radius zero: caps line ends and rounds corners.
struct Dot {
  glm::dvec2 center{0, 0};
  bool operator==(const Dot&) const = default;
};

/// A piece of a stroke or of an outline, travelled from its first point to its last.
using Piece = std::variant<Line, Arc>;

/// The area within a closed outline (each piece starts where the one before ends).
struct Fill {
  std::vector<Piece> outline;
  bool operator==(const Fill&) const = default;
};

glm::dvec2 StartOf(const Piece& piece);
glm::dvec2 EndOf(const Piece& piece);
double Length(const Piece& piece);
/// Point at arc length `s` from the start, held to the piece.
glm::dvec2 PointAt(const Piece& piece, double s);
/// Unit direction of travel at arc length `s`.
glm::dvec2 TangentAt(const Piece& piece, double s);
/// Distance of `p` to the nearest point of the piece, its ends included.
double DistanceTo(const Piece& piece, glm::dvec2 p);
/// The piece scaled about the origin and then moved.
Piece Placed(const Piece& piece, double scale, glm::dvec2 origin);
Box BoundsOf(const Piece& piece);

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

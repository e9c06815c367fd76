#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "textures/field/piece.h"
#include "textures/objects/solid.h"

namespace moontrace {

/// Length along an ellipse from its first axis on, as a series in the parameter angle: smooth,
/// periodic, with an exact derivative.
class EllipseArc {
 public:
  EllipseArc() = default;
  /// Semi-axes [m]: a point is (first cos t, second sin t).
  EllipseArc(double first, double second);
  double LengthTo(double angle) const noexcept;  ///< [m]
  double RateAt(double angle) const noexcept;    ///< [m/rad]
  double AngleAt(double length) const noexcept;  ///< inverse of LengthTo [rad]
  double around() const noexcept;                ///< the whole circumference [m]

 private:
  static constexpr int kTerms = 24;
  double mean_ = 0;                         ///< [m/rad]
  std::array<double, kTerms> harmonics_{};  ///< of sin(2 n t) [m]
};

/// Where a page lies on a face. A face has coordinates of its own, seen from outside, u to the
/// right and v up, from the face's middle: flat faces have the axes of O (top x, y; front x, z; the
/// others turned about from there, bottom about x); round ones u around from the front (-y) to the
/// right, v along z.
struct LabelPlace {
  Face face = Face::kTop;
  glm::dvec2 on_face{0, 0};  ///< this point of the face [m] ...
  glm::dvec2 on_page{0, 0};  ///< ... lies under this point of the page [m]
  double turn = 0;           ///< of the page on the face, to the left [rad]
};

/// The chart of one label: page P over a solid O. (x, y) of P is a point of the surface, z the
/// height above it along the normal.
///
/// True to scale: flat faces and the side of a cylinder or capsule exactly. Sphere: exactly along
/// the great circle through the middle of the page; at v from it lengths along the text are too
/// short by 1 - cos(v / R), 1 % at 0.14 R, lengths across exact. The caps of a capsule as a sphere.
/// Ellipsoid: exactly along its equator; elsewhere by what LengthError gives.
///
/// Continuous on each face, but for a seam of round faces opposite to the middle of the page, where
/// a page that is not too wide has no texture, and the poles.
class LabelChart {
 public:
  LabelChart() = default;
  LabelChart(const Solid& solid, const LabelPlace& place);

  /// What belongs to a point of space.
  struct Point {
    glm::dvec2 p_P{0, 0};                     ///< below it, on the page [m]
    glm::dvec3 dx_O{1, 0, 0}, dy_O{0, 1, 0};  ///< gradients of p_P, in O [m/m]
  };
  /// Finite for every finite point but those on the axis of a round face, where dx is large.
  Point At(glm::dvec3 p_O) const noexcept;
  /// The point of space over a page's point; inverse of At and NearestOf down to GreatestDepth.
  glm::dvec3 ToObject(glm::dvec3 p_P) const noexcept;

  /// Height of a point above the label's own face, which goes on beyond its edges, and the normal
  /// there: what the z of P is.
  Nearest Above(glm::dvec3 p_O) const noexcept;

  const LabelPlace& place() const noexcept { return place_; }

 private:
  /// Coordinates of the face, with their gradients.
  Point OnFace(glm::dvec3 p_O) const noexcept;
  Point OnRound(glm::dvec3 p_O) const noexcept;
  Point OnEllipsoid(glm::dvec3 p_O) const noexcept;
  glm::dvec3 FromFace(glm::dvec2 p_F, double height) const noexcept;

  Solid solid_;
  LabelPlace place_;
  double c_ = 1, s_ = 0;           ///< of the turn; 1, 0 on a sphere, where own_ has it
  glm::dmat3 own_{1.0};            ///< sphere: its own poles; columns are the chart's axes in O
  EllipseArc equator_, meridian_;  ///< ellipsoid
};

/// What of a face text may cover, in coordinates of the face [m]: the whole of a flat one, infinite
/// where a plane has no edge; of a cap the square within its circle. Of round ones the straight
/// part, of a sphere and an ellipsoid what is within 60 degrees of the equator, and around all but
/// a sixteenth.
Box RoomOn(const Solid& solid, Face face) noexcept;

/// Whether `box_P` lies within that room: around a round face it may begin anywhere, and a sphere
/// counts from the great circle of the page.
bool Fits(const Solid& solid, const LabelPlace& place, const Box& box_P) noexcept;

/// Least and greatest length on the page over the length on the surface, within `box_P`, in any
/// direction; 1: true to scale.
struct ScaleRange {
  double least = 1, greatest = 1;
};
ScaleRange ScalesOf(const LabelChart& chart, const Box& box_P) noexcept;
/// Greatest relative error of a length on the surface, against the page.
double LengthError(const LabelChart& chart, const Box& box_P) noexcept;

}  // namespace moontrace

#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string_view>

namespace moontrace {

/// Solids that carry text: those of MuJoCo's geoms whose surface has a chart. Frame O: the solid's
/// own, its origin in the middle; of a plane, on it, with z out of it.
enum class SolidKind : std::uint8_t { kPlane, kBox, kCylinder, kSphere, kCapsule, kEllipsoid };

/// A part of a solid's surface with a chart of its own. A plane has kTop; a box all six; a cylinder
/// kTop, kBottom and kRound; the others kRound. Front is -y, right is +x.
enum class Face : std::uint8_t { kTop, kBottom, kFront, kBack, kLeft, kRight, kRound };

/// Names of faces, as a label's key `face` takes them.
inline constexpr const char* kFaceNames = "top, bottom, front, back, left, right, round";
std::string_view NameOf(Face face) noexcept;
std::optional<Face> FaceOf(std::string_view name) noexcept;

/// `half` [m]: plane: half its length and width, zero or less where it has no edge, which bounds
/// labels but not the surface. Box: half lengths. Cylinder and capsule: radius, half the length
/// without caps, unused; the axis is z. Sphere: radius, unused. Ellipsoid: semi-axes.
struct Solid {
  SolidKind kind = SolidKind::kPlane;
  glm::dvec3 half{0, 0, 0};
};

bool HasFace(const Solid& solid, Face face) noexcept;
/// The face that a label without the key `face` lies on.
Face UsualFace(const Solid& solid) noexcept;

/// By which side a point came into a thin solid: for each axis -1, +1, or 0 where nothing is
/// remembered. A plate thinner than a press is deep would otherwise push its far side out.
struct Sides {
  glm::dvec3 of{0, 0, 0};
};

/// Remembers the side of `p_O` along axes of a box or a cylinder that are thinner than `thin` [m],
/// while the point is beyond that side; forgets nothing. A tip that is pressed out at the back
/// is still pushed to the front, as below a page, until it leaves the plate's outline.
void Remember(const Solid& solid, double thin, glm::dvec3 p_O, Sides& sides) noexcept;

/// The smooth surface that is nearest to a point.
struct Nearest {
  Face face = Face::kTop;
  double height = 0;             ///< above the surface, negative inside [m]
  glm::dvec3 normal_O{0, 0, 1};  ///< unit, outwards: the gradient of `height`
};

/// Nearest external surface of a point. Inside a box or cylinder the face that is least deep, at
/// equal depths the first in the order of Face: on those planes (the medial axis) height is
/// continuous and the normal jumps. In the middle of a sphere, on an axis, any direction is
/// nearest: one of them is given. Ellipsoid: by the equation of the nearest point (Hart 1994),
/// solved to rounding; unique from outside down to GreatestDepth.
Nearest NearestOf(const Solid& solid, glm::dvec3 p_O, const Sides& sides = {}) noexcept;

/// Down to here the nearest surface and its chart are well defined [m]: half the least radius of
/// curvature; infinite for plane and box, whose faces meet only at edges.
double GreatestDepth(const Solid& solid) noexcept;

/// Greatest factor by which a length on the round surface shrinks at that depth below it, 1 / (1 -
/// depth / radius): by so much slopes of a texture grow. 1 for flat faces. `depth` [m] at most
/// GreatestDepth.
double ShrinkAt(const Solid& solid, double depth) noexcept;

/// No point of the solid is farther from its middle [m]; infinite for a plane.
double Radius(const Solid& solid) noexcept;

/// The parameter t of the nearest point x_i = a_i^2 p_i / (a_i^2 + t) of an ellipsoid, semi-axes
/// a [m]; p not in its middle.
double EllipsoidParameter(glm::dvec3 a, glm::dvec3 p) noexcept;

}  // namespace moontrace

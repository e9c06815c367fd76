#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "textures/field/field.h"

namespace moontrace {

/// How depth becomes force. `kPaper`: k x depth along the unit normal, magnitude capped (the paper,
/// section 4). `kPotential` (default): the exact gradient of a potential of depth, whose derivative
/// saturates, so that the force stays conservative with the cap reached.
enum class ForceLaw { kPotential, kPaper };

/// The plane's elastic answer.
struct Surface {
  double stiffness = 1000;  ///< k [N/m]
  double force_cap = 3;     ///< F_cap, greatest magnitude [N]
  ForceLaw law = ForceLaw::kPotential;
};

/// What a tip meets at one point of a textured plane.
struct Contact {
  double depth = 0;             ///< of the tip below the textured surface along z [m]; <= 0 outside
  Sample sample;                ///< displacement and gradient of the texture there
  glm::dvec3 force_P{0, 0, 0};  ///< reaction [N], zero outside and for a point that is not finite
};

/// Unit normal of a surface with this gradient. The one place where a gradient becomes a normal.
glm::dvec3 NormalOf(glm::dvec2 gradient) noexcept;

/// Contact of a point with the plane z = 0 carrying `field` (point 6 of design section 4).
Contact Touch(const Surface& surface, const TextureField& field, glm::dvec3 p_P) noexcept;

/// Potential energy of the default law at a depth [J] (zero outside): what `force_P` is the
/// gradient of.
double Potential(const Surface& surface, const TextureField& field, double depth) noexcept;

/// Greatest stiffness a tip can feel [N/m]: k (1 + s^2) + F s/r, F the press [N], at most the cap.
double GreatestStiffness(const Surface& surface, const TextureField& field, double press) noexcept;

}  // namespace moontrace

#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "textures/field/field.h"

namespace moontrace {

/// How depth becomes force. `kPaper`: k x depth along the unit normal, magnitude capped (the paper,
/// section 4). `kPotential` (default): the exact gradient of two potentials, so that the force
/// stays conservative with the cap reached. One is of the depth below the textured surface and
/// gives all that pushes sideways; it saturates early. The other is of the depth below the plane
/// and carries what the first no longer does: without it a firm press would sink through flat
/// paper wherever the page has steep grooves.
enum class ForceLaw { kPotential, kPaper };

/// The plane's elastic answer.
struct Surface {
  double stiffness = 1000;  ///< k [N/m]
  double force_cap = 4;     ///< F_cap, greatest magnitude [N]
  ForceLaw law = ForceLaw::kPotential;
};

/// What a tip meets at one point of a textured plane.
struct Contact {
  /// Of the tip below what carries it, along z [m]: the textured surface, or the level where the
  /// support begins if that is higher; > 0 in contact.
  double depth = 0;
  Sample sample;                ///< displacement and gradient of the texture there
  glm::dvec3 force_P{0, 0, 0};  ///< reaction [N], zero outside and for a point that is not finite
};

/// Shares of the cap that the default law gives to each direction; their squares add to one.
inline constexpr double kSidewaysShare = 0.55;
inline constexpr double kNormalShare = 0.835;

/// A surface on one field: what follows from both and does not change from point to point.
struct SurfaceLaw {
  Surface surface;
  double normal = 0;    ///< F_n: greatest force along z [N]
  double sideways = 0;  ///< G: of what pushes sideways, before the slope [N]
  double support = 0;   ///< a0: depth at which the support begins [m]
};
SurfaceLaw LawOf(const Surface& surface, const TextureField& field) noexcept;

/// Unit normal of a surface with this gradient. The one place where a gradient becomes a normal.
glm::dvec3 NormalOf(glm::dvec2 gradient) noexcept;

/// Contact of a point with the plane z = 0 carrying `field` (point 6 of design section 4).
///
/// The default law, with h the displacement, a = -z and d = a + h:
///   phi = min(k d+, G),  psi = min(k (a - a0)+, F_n - G),  force = (-phi grad h, phi + psi),
///   F_n = 0.835 F_cap,  G = min(F_n, 0.55 F_cap / s_max),  a0 = max(0, max(G/k, D) - H),
/// D and H the field's greatest fall and rise. So the sideways force stays within 0.55 F_cap and
/// the force along z within F_n. Where no groove is deeper than G/k, flat engraved paper is linear,
/// k a, up to F_n, and a groove is felt whole up to a press of G - k D; above it fades, (G + k D -
/// P) / 2k is left under the press P, since a bounded sideways force can hold no more energy than G
/// D in a groove. Under deeper ones the support begins at their floor, or they would have none of
/// their own shape: flat paper sinks there from G/k to D once it is pressed harder than G.
Contact Touch(const SurfaceLaw& law, const TextureField& field, glm::dvec3 p_P) noexcept;
/// The same where the texture was sampled before, at p_P's x and y.
Contact Touch(const SurfaceLaw& law, const Sample& sample, glm::dvec3 p_P) noexcept;
/// The same for one point: LawOf each time.
Contact Touch(const Surface& surface, const TextureField& field, glm::dvec3 p_P) noexcept;

/// Potential energy of the default law [J] at the height `z` over a point of that displacement [m]:
/// what Touch's force is the gradient of. Zero outside.
double Potential(const SurfaceLaw& law, double displacement, double z) noexcept;

/// Greatest press that the page carries for as long as it lasts, at every point [N]: 0.94 of F_n, a
/// reserve against the hand's own wavering; F_cap at the steepest place for the paper's law.
double CarriedPress(const Surface& surface, const TextureField& field) noexcept;

/// How far below the plane the tip is through the paper [m]: five millimetres beyond where the
/// force can grow no more, room for a hand that lands firmly.
double ThroughDepth(const Surface& surface, const TextureField& field) noexcept;

/// Greatest stiffness a tip can feel [N/m], F the press [N], at most the cap, s and s/r the field's
/// greatest slope and curvature. Paper's law: k (1 + s^2) + F s/r. Default law: both potentials
/// can act at once, k (s^2 + 2 + sqrt(s^4 + 4)) / 2 + min(F, G) s/r, unless G is F_n.
double GreatestStiffness(const Surface& surface, const TextureField& field, double press) noexcept;

}  // namespace moontrace

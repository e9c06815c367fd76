#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "textures/field/field.h"
#include "textures/field/surface.h"
#include "textures/objects/label_chart.h"
#include "textures/objects/solid.h"

namespace moontrace {

/// A texture on a solid.
struct LabelOnSolid {
  LabelChart chart;
  const TextureField* field = nullptr;  ///< none: blank
  double stretch = 1;                   ///< ScaleRange::greatest of what is textured
};

/// What a tip meets at one point of a textured solid.
struct SolidContact {
  Nearest nearest;
  /// As Contact::depth, along the normal of the smooth surface; > 0 in contact [m].
  double depth = 0;
  double displacement = 0;         ///< of all textures there [m]
  glm::dvec3 gradient_O{0, 0, 0};  ///< of the displacement, in space [m/m]
  glm::dvec3 force_O{0, 0, 0};     ///< reaction [N], zero outside
};

/// The law of a solid: as LawOf (surface.h) for the steepest, deepest and highest of its labels,
/// which lie beside each other. Lengths shrink with depth on a round surface, so slopes grow: the
/// sideways limit G falls by as much, and no force passes the cap down to ThroughDepthOn.
SurfaceLaw LawOn(const Solid& solid, const Surface& surface,
                 std::span<const LabelOnSolid> labels) noexcept;

/// How far below the smooth surface a tip is through it [m]: ThroughDepth, at most GreatestDepth.
double ThroughDepthOn(const Solid& solid, const Surface& surface,
                      std::span<const LabelOnSolid> labels) noexcept;

/// Greatest press that lasts [N]: CarriedPress, or less where that would go through.
double CarriedPressOn(const Solid& solid, const Surface& surface,
                      std::span<const LabelOnSolid> labels) noexcept;

/// Greatest stiffness a tip can feel on the solid [N/m]: GreatestStiffness of each label, its
/// slopes grown as above, and what the turning of the normal adds, force over radius.
double StiffnessOn(const Solid& solid, const Surface& surface,
                   std::span<const LabelOnSolid> labels) noexcept;

/// Contact of a point with a solid: the two potentials of surface.h with the depth below the smooth
/// surface as a = -height, so that force = -grad (phi-energy of (h - height) + psi-energy of
/// (-height - a0)), h the displacement at the chart's point:
///   force = phi (n - grad h) + psi n,  n the normal, grad h by the chart's Jacobian.
/// Zero outside. Continuous wherever Nearest and charts are; across an edge the direction jumps
/// inside (the medial axis), the potential does not as long as texture keeps the tip's depth away
/// from it. `labels` on other faces do not count.
SolidContact TouchSolid(const SurfaceLaw& law, const Solid& solid,
                        std::span<const LabelOnSolid> labels, glm::dvec3 p_O,
                        const Sides& sides = {}) noexcept;

}  // namespace moontrace

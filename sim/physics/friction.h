#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace moontrace {

/// Coulomb friction with elastic presliding (Dahl's bristle with Coulomb's sharp limit): a spring
/// from the point of contact to an anchor on the surface; when it would pull harder than mu times
/// the normal force the anchor is dragged along. The spring's stretch only ever grows by the
/// contact's own travel; turning with the surface, sliding and lifting make it shorter, so the
/// model hands out no energy that the travel did not put in. All in the page's frame, so that a
/// moving page drags the contact along. Trivially copyable: part of what a replay starts from.
class Friction {
 public:
  /// Advances to the contact at `p_P` [m] under a surface of unit normal `normal_P` that presses
  /// with `normal_force` [N], and returns the force on what slides [N], tangent to the surface, at
  /// most mu * normal_force. A normal force of zero lifts: the anchor is forgotten. Once per
  /// integration step.
  glm::dvec3 Advance(double mu, double stiffness, glm::dvec3 p_P, glm::dvec3 normal_P,
                     double normal_force) noexcept;

  /// Energy held by the spring [J].
  double Energy(double stiffness) const noexcept {
    return 0.5 * stiffness * glm::dot(stretch_P_, stretch_P_);
  }

 private:
  glm::dvec3 stretch_P_{0, 0, 0};  ///< from the anchor to the contact [m]
  glm::dvec3 last_P_{0, 0, 0};     ///< contact of the step before [m]
  double touching_ = 0;            ///< 1 while in contact; a double, as the saved state wants
};

}  // namespace moontrace

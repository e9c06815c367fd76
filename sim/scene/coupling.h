#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace moontrace {

/// The virtual coupling between tip and proxy (Colgate, Stanley and Brown 1995): a spring and a
/// damper, the same in every direction. The device feels at most its stiffness, whatever the page.
struct Coupling {
  double stiffness = 0;  ///< K [N/m]
  double damping = 0;    ///< B [N s/m]

  /// Pull on the proxy [N] for tip minus proxy, as position [m] and as velocity [m/s]; the device
  /// feels the opposite.
  glm::dvec3 Pull(glm::dvec3 stretch, glm::dvec3 stretch_rate) const noexcept {
    return stiffness * stretch + damping * stretch_rate;
  }
  /// Energy held by the spring [J].
  double Energy(glm::dvec3 stretch) const noexcept {
    return 0.5 * stiffness * glm::dot(stretch, stretch);
  }
};

}  // namespace moontrace

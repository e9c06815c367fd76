#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "sim/physics/scene_options.h"

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

/// Sum of the magnitudes of the coupling's answer to a unit pulse of page force, for the very
/// recursion that the scene runs (semi-implicit Euler at steps of `step` [s]): the l1 norm of the
/// discrete impulse response, by which a bounded page force bounds the coupling's. Infinite if the
/// answer does not die out: no damping, or an unstable step. For small steps it tends to the
/// integral of |h|, h the impulse response of (B s + K) / (m s^2 + B s + K).
double CouplingNorm(double stiffness, double damping, double mass, double step);

/// Upper bound of the force on the device [N], for every page, direction, speed and path.
///
/// Proxy rendering. Seen from a device that moves evenly, the proxy is a mass m on the coupling (K,
/// B), driven by the page's force f alone. Both force laws keep f's normal part within F_cap, and
/// friction, perpendicular to it, within mu F_cap, so |f| <= P = F_cap sqrt(1 + mu^2), whatever the
/// page is. With e = tip - proxy and w its rate, a step of h is
///
///   w' = w - (h/m) (K e + B w + f),  e' = e + h w',  force on the device F = -(K e + B w),
///
/// linear and the same in every direction; hence |F| <= ||g||_1 P with g the response of F to a
/// unit pulse of f (CouplingNorm). A device whose velocity changes by a h in a step adds h a to w',
/// as a page force of -m a would: |F| <= ||g||_1 (P + m a) while its acceleration stays within
/// `acceleration` [m/s^2]. Sub-steps split the pulse of a into one sub-step out of n; as the force
/// handed out is their mean, the bound is the same with h the sub-step.
///
/// Direct rendering: P itself.
double ForceBound(const SceneOptions& options, double proxy_mass, double acceleration,
                  int substeps = 1);

}  // namespace moontrace

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

  /// The same for a coupling that gives way: its spring pulls with at most `most` [N], and with the
  /// damper no harder either. What holds the proxy then never gives the hand more than that.
  glm::dvec3 PullWithin(double most, glm::dvec3 stretch, glm::dvec3 stretch_rate) const noexcept {
    const glm::dvec3 pull = Pull(stretch, stretch_rate);
    const double size = glm::length(pull);
    return size > most ? pull * (most / size) : pull;
  }
  double EnergyWithin(double most, glm::dvec3 stretch) const noexcept {
    const double force = stiffness * glm::length(stretch);
    if (!(force > most)) return Energy(stretch);
    return most * (glm::length(stretch) - 0.5 * most / stiffness);
  }
};

/// Sum of the magnitudes of the coupling's answer to a unit pulse of page force, for the very
/// recursion that the scene runs (semi-implicit Euler at steps of `step` [s]): the l1 norm of the
/// discrete impulse response, by which a bounded page force bounds the coupling's. Infinite if the
/// answer does not die out: no damping, or an unstable step. For small steps it tends to the
/// integral of |h|, h the impulse response of (B s + K) / (m s^2 + B s + K).
double CouplingNorm(double stiffness, double damping, double mass, double step);

/// How a device moves, for the bound of its force.
struct Movement {
  double acceleration = 0;    ///< greatest [m/s^2]; 0: it moves evenly
  double position_step = 0;   ///< of its readings, each axis [m]; 0: they are exact
  bool pushes_height = true;  ///< false: a stick, which feels the force along the page only
};

/// Upper bound of the force on the device [N], for every page that rests, direction, speed and path
/// within `movement`. A page that moves, or a proxy that something else holds, has none.
///
/// Proxy rendering. Seen from a device that moves evenly, the proxy is a mass m on the coupling (K,
/// B), driven by the page's force f alone. With e = tip - proxy and w its rate, a step of h is
///
///   w' = w - (h/m) (K e + B w + f),  e' = e + h w',  force on the device F = -(K e + B w),
///
/// linear and the same in every direction; so each part of F is at most that part of f times n =
/// ||g||_1, g the response of F to a unit pulse of f (CouplingNorm). A part that never changes its
/// sign reaches only n+ = (n + 1) / 2 times itself, since g adds up to one. The default law keeps f
/// sideways within a = 0.55 F_cap and upwards, from zero, within b = 0.835 F_cap (surface.h):
///
///   |F| <= sqrt((n a)^2 + (n+ b)^2) + n mu F_cap,
///
/// the last term friction, which is at most mu times the pressing force, at most mu F_cap. The
/// paper's law, whose friction is perpendicular to f: |F| <= n F_cap sqrt(1 + mu^2).
///
/// A device whose velocity changes by A h in a step adds h A to w', as a page force of -m A would:
/// n m A more. Readings in steps of q leave the place that the coupling is given off by at most 3.5
/// q (TipEstimate follows them within three steps), its velocity by at most q a tick and the 2 A
/// tick that such a follower lags: a force u = 3.5 K q + B (q/tick + 2 A tick) between tip and
/// proxy, of which the device feels u itself and the proxy's answer: sqrt(3) (1 + n) u more, the
/// three axes together; nothing where q is zero. Sub-steps split the pulse of A into one sub-step
/// out of n; as the force handed out is their mean, the bound is the same with h the sub-step.
///
/// Direct rendering: the page's force itself.
double ForceBound(const SceneOptions& options, double proxy_mass, const Movement& movement = {},
                  int substeps = 1);

}  // namespace moontrace

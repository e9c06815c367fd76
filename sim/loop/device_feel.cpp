#include "sim/loop/device_feel.h"

#include <algorithm>
#include <cmath>

#include "sim/physics/coupling.h"

namespace moontrace {

SceneOptions HeldBy(const DeviceLimits& limits, SceneOptions options, double proxy_mass) {
  if (limits.coupling_stiffness > 0) {
    options.coupling_stiffness = limits.coupling_stiffness;
    options.coupling_damping = limits.coupling_damping;
  }
  if (limits.stiffness < options.coupling_stiffness && limits.stiffness > 0) {
    options.coupling_damping *= std::sqrt(limits.stiffness / options.coupling_stiffness);
    options.coupling_stiffness = limits.stiffness;
  }
  const double bound = ForceBound(options, proxy_mass, {.pushes_height = limits.pushes.z});
  if (std::isfinite(bound) && bound > 0 && limits.peak_force > 0) {
    options.surface.force_cap *= limits.peak_force / bound;
  }
  return options;
}

GuidanceGains HeldBy(const DeviceLimits& limits, GuidanceGains gains, double scale) {
  // the force is the same in the world and at the device, the device's travel is 1 / scale
  if (limits.stiffness > 0) {
    gains.stiffness = std::min(gains.stiffness, limits.stiffness / std::max(scale, 1.0));
  }
  if (limits.peak_force > 0) gains.cap = std::min(gains.cap, limits.peak_force);
  return gains;
}

}  // namespace moontrace

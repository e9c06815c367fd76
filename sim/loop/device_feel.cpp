#include "sim/loop/device_feel.h"

#include <algorithm>
#include <cmath>

#include "sim/scene/bound.h"

namespace moontrace {

SceneOptions HeldBy(const DeviceLimits& limits, SceneOptions options, double proxy_mass) {
  if (limits.stiffness < options.coupling_stiffness && limits.stiffness > 0) {
    options.coupling_damping *= std::sqrt(limits.stiffness / options.coupling_stiffness);
    options.coupling_stiffness = limits.stiffness;
  }
  const double bound = ForceBound(options, proxy_mass, 0);
  if (std::isfinite(bound) && bound > limits.peak_force && limits.peak_force > 0) {
    options.surface.force_cap *= limits.peak_force / bound;
  }
  return options;
}

}  // namespace moontrace

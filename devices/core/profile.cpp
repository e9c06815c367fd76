#include "devices/core/profile.h"

#include <algorithm>
#include <cmath>

namespace moontrace {

double StableStiffness(const DeviceProfile& profile) {
  const double period = 1 / profile.rate + 2 * profile.delay;
  double stiffness = profile.limits.stiffness;
  if (profile.limits.damping > 0) {
    stiffness = std::min(stiffness, 2 * profile.limits.damping / period);
  }
  if (profile.coulomb_friction > 0 && profile.position_step > 0) {
    stiffness = std::min(stiffness, 2 * profile.coulomb_friction / profile.position_step);
  }
  return stiffness;
}

/// Tremor moves a hand 8 to 12 times a second: two of its swings or more [s].
constexpr double kLeastStill = 0.25;

DeviceLimits LimitsOf(const DeviceProfile& profile, double tick) {
  DeviceLimits limits = profile.limits;
  limits.stiffness = StableStiffness(profile);
  limits.friction = profile.coulomb_friction;
  limits.still = std::max(limits.silence, kLeastStill);
  // Periods that are whole ticks but for rounding count as whole.
  constexpr double kRounding = 1e-6;
  const double ticks = std::ceil((1 / profile.rate + profile.delay) / tick - kRounding) - 1;
  limits.late_ticks = std::max(1, static_cast<int>(ticks));
  return limits;
}

}  // namespace moontrace

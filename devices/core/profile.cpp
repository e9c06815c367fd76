#include "devices/core/profile.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "devices/core/coupling_margin.h"
#include "devices/core/tip_estimate.h"

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

namespace {

constexpr double kStiffest = 2000, kUsual = 1000;  ///< couplings [N/m]
constexpr double kProxy = 0.05;                    ///< mass of models/proxy.xml [kg]
constexpr double kDampingRatio = 0.7;
/// Force of the coupling's spring over one step of the readings [N]: at 0.06 the tip's grit, which
/// tracking (tip_estimate.h) brings to two thirds of that, is below 0.05 N rms.
constexpr double kStepForce = 0.055;
constexpr double kMovingMass = 0.1;  ///< hand and device at the tip, as devices/hand.toml [kg]
constexpr double kHandDamping = 3;   ///< of the hand alone, as there [N s/m]
/// A damper B that acts t late takes the mass B t from what it moves: a little more than the
/// proxy's, then it still swings less than it would undamped and hard turns kick by 0.12 N at most
/// [kg].
constexpr double kLateMass = 0.055;

/// Greatest time by which a damper's velocity is late: of the tracker and a whole period [s].
double VelocityLag(const DeviceProfile& profile) {
  const double tracker = std::sqrt(profile.position_step / std::sqrt(12.0) / kHandAcceleration);
  return std::numbers::sqrt2 * tracker + 1 / profile.rate;
}

CouplingGains DampedFor(const DeviceProfile& profile, double stiffness) {
  const double damping = 2 * kDampingRatio * std::sqrt(kProxy * stiffness);
  return {stiffness, std::min(damping, kLateMass / VelocityLag(profile))};
}

}  // namespace

CouplingGains CouplingOf(const DeviceProfile& profile) {
  double stiffness = std::min(kStiffest, StableStiffness(profile));
  if (!std::isfinite(profile.limits.stiffness)) stiffness = std::min(stiffness, kUsual);
  if (profile.position_step > 0) {
    stiffness = std::min(stiffness, kStepForce / profile.position_step);
  }
  if (!(stiffness > 0)) return {};
  CouplingGains coupling = DampedFor(profile, stiffness);
  if (!glm::any(profile.limits.pushes)) return coupling;  // nothing that could swing
  DeviceProfile held = profile;
  if (!(held.limits.damping > 0)) held.limits.damping = kHandDamping;  // unknown: the hand is there
  // a softer one has the greater margin; in steps of two percent, as no figure here is finer
  while (CouplingMargin(held, coupling, kMovingMass) < kLeastCouplingMargin && stiffness > 1) {
    stiffness *= 0.98;
    coupling = DampedFor(profile, stiffness);
  }
  return coupling;
}

/// Tremor moves a hand 8 to 12 times a second: two of its swings or more [s].
constexpr double kLeastStill = 0.25;

DeviceLimits LimitsOf(const DeviceProfile& profile, double tick) {
  DeviceLimits limits = profile.limits;
  limits.stiffness = StableStiffness(profile);
  const CouplingGains coupling = CouplingOf(profile);
  limits.coupling_stiffness = coupling.stiffness;
  limits.coupling_damping = coupling.damping;
  limits.position_step = profile.position_step;
  limits.friction = profile.coulomb_friction;
  limits.still = std::max(limits.silence, kLeastStill);
  // Periods that are whole ticks but for rounding count as whole.
  constexpr double kRounding = 1e-6;
  const double ticks = std::ceil((1 / profile.rate + profile.delay) / tick - kRounding) - 1;
  limits.late_ticks = std::max(1, static_cast<int>(ticks));
  return limits;
}

}  // namespace moontrace

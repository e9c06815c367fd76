#include "sim/physics/coupling.h"

#include <cmath>
#include <limits>

namespace moontrace {

double CouplingNorm(double stiffness, double damping, double mass, double step) {
  constexpr int kGreatestSteps = 10'000'000;
  constexpr double kNegligible = 1e-13;
  const double still = damping + std::sqrt(stiffness * mass);
  double rate = -step / mass;  // the pulse f = 1 has just acted
  double stretch = step * rate;
  double sum = 0;
  for (int i = 0; i < kGreatestSteps; ++i) {
    const double force = stiffness * stretch + damping * rate;
    sum += std::abs(force);
    rate -= step / mass * force;
    stretch += step * rate;
    // an amplitude, not the momentary force, which passes through zero as it swings
    const double amplitude = stiffness * std::abs(stretch) + still * std::abs(rate);
    if (!std::isfinite(amplitude)) break;
    if (amplitude < kNegligible * sum) return sum * (1 + 1e-9);  // the tail, rounded up
  }
  return std::numeric_limits<double>::infinity();
}

double ForceBound(const SceneOptions& options, double proxy_mass, const Movement& movement,
                  int substeps) {
  const double cap = options.surface.force_cap, mu = options.friction;
  const bool direct = options.rendering == Rendering::kDirect;
  const double K = options.coupling_stiffness, B = options.coupling_damping;
  const double n = direct ? 1 : CouplingNorm(K, B, proxy_mass, options.tick / substeps);
  double bound = 0;
  if (options.surface.law == ForceLaw::kPaper) {
    bound = n * cap * std::sqrt(1 + mu * mu);
  } else {
    const double sideways = n * kSidewaysShare * cap;
    const double upwards = movement.pushes_height ? 0.5 * (n + 1) * kNormalShare * cap : 0;
    bound = std::hypot(sideways, upwards) + n * mu * cap;
  }
  if (direct) return bound;
  const double q = movement.position_step;
  const double lag = q > 0 ? 2 * movement.acceleration * options.tick : 0;  // [m/s]
  return bound + n * proxy_mass * movement.acceleration +
         std::sqrt(3.0) * (1 + n) * (3.5 * K * q + B * (q / options.tick + lag));
}

}  // namespace moontrace

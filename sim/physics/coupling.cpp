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

double ForceBound(const SceneOptions& options, double proxy_mass, double acceleration,
                  int substeps) {
  const double page =
      options.surface.force_cap * std::sqrt(1 + options.friction * options.friction);
  if (options.rendering == Rendering::kDirect) return page;
  const double norm = CouplingNorm(options.coupling_stiffness, options.coupling_damping, proxy_mass,
                                   options.tick / substeps);
  return norm * (page + proxy_mass * acceleration);
}

}  // namespace moontrace

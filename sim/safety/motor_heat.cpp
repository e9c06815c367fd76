#include "sim/safety/motor_heat.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moontrace {

MotorHeat::MotorHeat(double peak, double continuous, double time_constant,
                     double longest_hold) noexcept
    : peak_(peak > 0 && std::isfinite(peak) ? peak : 0) {
  if (continuous == std::numeric_limits<double>::infinity()) return;
  if (!(continuous > 0)) {  // also NaN
    peak_ = 0;
  } else if (!(time_constant > 0)) {
    peak_ = std::min(peak_, continuous);
  } else if (std::isfinite(time_constant)) {
    continuous_ = continuous;
    time_constant_ = time_constant;
    // Over a hold H the heat comes to h + (c^2/f_c^2 - h)(1 - E), E = exp(-H/tau). With
    // c^2 = C (1 - h) + f_c^2 h that is h + (1 - h)(1 - E) C / f_c^2: within 1 if C is within this.
    const double share = -std::expm1(-longest_hold / time_constant);
    cold_square_ = std::min(peak_ * peak_, continuous * continuous / share);
  }
}

void MotorHeat::Advance(double force, double elapsed) noexcept {
  if (continuous_ <= 0) return;
  const double share = force / continuous_;
  heat_ += (share * share - heat_) * -std::expm1(-elapsed / time_constant_);
}

double MotorHeat::Ceiling() const noexcept {
  if (continuous_ <= 0) return peak_;
  // h may pass 1 over a stall of the loop: below the continuous force, until it has cooled
  const double square = cold_square_ * (1 - heat_) + continuous_ * continuous_ * heat_;
  return std::min(peak_, std::sqrt(std::max(0.0, square)));
}

}  // namespace moontrace

#include "sim/safety/still_tip.h"

#include <algorithm>
#include <cmath>

namespace moontrace {

namespace {

/// Share of the distance from the middle to the edge; a stick's ends are calibrated no better.
constexpr double kEdge = 0.98;

}  // namespace

StillTip::StillTip(const DeviceLimits& limits) noexcept
    : limits_(limits), least_force_(std::max(kFeltForce, 2 * limits.friction)) {}

bool StillTip::IsAtEdge() const noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    const double edge = kEdge * limits_.workspace_D[axis];
    if (limits_.measures[axis] && std::abs(p_D_[axis]) >= edge) return true;
  }
  return false;
}

void StillTip::Pause() noexcept {
  still_ = waited_ = 0;
  if (!stuck_) share_ = 1;  // what follows begins with a ramp
}

void StillTip::Advance(double elapsed, bool fresh, glm::dvec3 p_D, double force) noexcept {
  waited_ += elapsed;
  if (fresh) {
    const bool moved = !begun_ || p_D != p_D_;
    begun_ = true;
    p_D_ = p_D;
    still_ = moved || !(force > least_force_) || IsAtEdge() ? 0 : still_ + waited_;
    waited_ = 0;
    if (moved && stuck_) {
      stuck_ = false;
      share_ = 1;  // what follows begins with a ramp
    }
  }
  if (stuck_) return;
  if (still_ <= limits_.still) {
    share_ = std::min(1.0, share_ + elapsed / kReturnTime);
    return;
  }
  share_ = std::max(0.0, share_ - elapsed / kYieldTime);
  stuck_ = share_ <= 0;
}

}  // namespace moontrace

#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lessons/guide/guidance.h"

namespace moontrace {

/// The guiding push of a running loop: the plan in use and what it remembers. Allocates nothing,
/// throws nothing.
class LoopPush {
 public:
  /// Another plan, from its beginning; nullptr: no push. It must outlive its use here.
  void Take(const GuidancePlan* plan) noexcept {
    plan_ = plan;
    state_ = GuidanceState{};
  }
  /// One tick of `tick` [s]. `felt`: force can be felt now; else nothing is pushed, the way stands
  /// still, and there is a ramp-in afterwards. `tip_P` [m], `v_P` [m/s].
  GuidanceResult Advance(bool felt, glm::dvec3 tip_P, glm::dvec3 v_P, double tick) noexcept {
    if (felt && plan_ != nullptr) return Guide(*plan_, state_, tip_P, v_P, tick);
    Pause();
    GuidanceResult none;
    none.target_P = glm::dvec2(tip_P);
    return none;
  }
  /// The tip is elsewhere, or force has ended: there is a ramp-in afterwards.
  void Pause() noexcept {
    state_.ramp = 0;
    state_.begun = false;
  }

  bool guided() const noexcept { return plan_ != nullptr; }
  bool done() const noexcept { return plan_ != nullptr && state_.done; }

 private:
  const GuidancePlan* plan_ = nullptr;
  GuidanceState state_;
};

}  // namespace moontrace

#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <utility>

#include "lessons/guide/guidance.h"
#include "sim/physics/pose.h"
#include "sim/physics/scene_options.h"

namespace moontrace {

class Scene;

/// Called for each tick of a trial or replay, with simulated time [s], what was felt, the push
/// within it, and the scene behind it. An exception from it ends the trial.
using TickWatch = std::function<void(double time, const TickResult& felt,
                                     const GuidanceResult& push, const Scene& scene)>;

/// A guiding push on top of what a scene's ticks answer: for simulated trials and their replay,
/// which must be identical. The tip's velocity is the device's, else its travel in one tick over
/// the tick's time.
class ScenePush {
 public:
  ScenePush(GuidancePlan plan, double tick) : plan_(std::move(plan)), tick_(tick) {}

  /// Adds the push to the force of a tick's answer. After a fault there is none, and a ramp-in.
  GuidanceResult Add(const Pose& X_WP, TickResult& output) noexcept {
    if (output.fault) {
      begun_ = false;
      state_.ramp = 0;
      state_.begun = false;
      return {};
    }
    glm::dvec3 v_P = begun_ ? (output.tip_P - tip_P_) / tick_ : glm::dvec3(0, 0, 0);
    if (output.velocity_known) v_P = output.v_P;
    tip_P_ = output.tip_P;
    begun_ = true;
    const GuidanceResult push = Guide(plan_, state_, output.tip_P, v_P, tick_);
    output.force_P += push.force_P;
    output.force_W += TurnToWorld(X_WP, push.force_P);
    return push;
  }

 private:
  GuidancePlan plan_;
  double tick_ = 0.001;  ///< [s]
  GuidanceState state_;
  glm::dvec3 tip_P_{0, 0, 0};  ///< in the last tick [m]
  bool begun_ = false;
};

}  // namespace moontrace

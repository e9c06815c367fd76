#pragma once

#include "devices/core/profile.h"
#include "devices/core/tip_estimate.h"
#include "devices/hand/hand.h"
#include "sim/bench/sampled_device.h"
#include "sim/physics/scene.h"
#include "sim/safety/safety.h"

namespace moontrace {

/// Scene options for a device: the coupling is the one it gets (CouplingOf); the rest is the
/// default.
SceneOptions SceneFor(const DeviceProfile& profile);

/// A simulated device, the scene and the safety stage, joined as the loop joins them: the hand gets
/// what the learner feels. Frames D and W are one.
class DeviceRig {
 public:
  /// `field` must outlive the rig. `hand_stiffness` [N/m] draws the tip to its aim on each axis.
  DeviceRig(const DeviceProfile& profile, const HandModel& hand, glm::dvec3 hand_stiffness,
            const TextureField& field, const SceneOptions& options);

  /// One tick under the hand's force [N] and aim [m].
  void Step(glm::dvec3 hand_force, glm::dvec3 aim);

  /// One tick of a hand that no force stops: from `p` to `next` [m].
  void Follow(glm::dvec3 p, glm::dvec3 next);

  const SampledDevice& device() const { return device_; }
  const TickResult& scene_result() const { return felt_; }
  const SafetyResult& safety_result() const { return safe_; }
  Pose X_WP() const { return scene_.X_WP(); }
  void Place(glm::dvec3 p) { device_.Place(p, {0, 0, 0}); }

 private:
  DeviceLimits limits_;
  double tick_;
  double press_;
  const TextureField& field_;
  Scene scene_;
  Safety safety_;
  SampledDevice device_;
  TipEstimate tip_;
  DeviceState state_;
  TickResult felt_;
  SafetyResult safe_;
  bool delivered_ = false;  ///< the last tick's force was commanded whole
  long ticks_ = 0;
};

}  // namespace moontrace

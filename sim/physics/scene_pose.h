#pragma once

#include <atomic>
#include <vector>

#include "sim/physics/pose.h"
#include "sim/physics/scene.h"

namespace moontrace {

/// Where everything in a scene stood at one instant: what MuJoCo's kinematics begin with.
struct ScenePose {
  std::vector<double> qpos, mocap_pos, mocap_quat;  ///< mjData's
  Pose X_WP;                                        ///< Scene::X_WP
};

/// The scene's now. Allocates only where `pose` is another model's.
void TakePose(const Scene& scene, ScenePose& pose);

/// Passes a scene's pose from the tick to one other thread, when that has asked for it. Neither
/// side waits. The tick's part allocates nothing, behind Fit.
class PoseMail {
 public:
  /// Before the ticks: makes room for this scene's.
  void Fit(const Scene& scene) { TakePose(scene, pose_); }
  /// The tick: gives the scene's, if somebody waits for one.
  void Put(const Scene& scene) noexcept {
    if (state_.load(std::memory_order_acquire) != kWanted) return;
    TakePose(scene, pose_);
    state_.store(kThere, std::memory_order_release);
  }
  /// The other thread: true and the pose that has come since the last call, and asks for the next.
  bool Take(ScenePose& pose) {
    const bool there = state_.load(std::memory_order_acquire) == kThere;
    if (there) pose = pose_;
    state_.store(kWanted, std::memory_order_release);
    return there;
  }

 private:
  enum State { kIdle, kWanted, kThere };
  ScenePose pose_;  // the tick's while kWanted, else the other thread's
  std::atomic<State> state_{kIdle};
};

}  // namespace moontrace

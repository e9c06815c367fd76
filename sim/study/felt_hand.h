#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "devices/core/profile.h"
#include "devices/hand/hand.h"
#include "lessons/guide/guidance.h"
#include "sim/physics/scene.h"

namespace moontrace {

/// One tick of a hand at work, as a meter or a score wants it.
struct HandTick {
  double time = 0;                 ///< since the work began [s]
  glm::dvec3 tip_P{0, 0, 0};       ///< [m]
  glm::dvec3 force_P{0, 0, 0};     ///< on the tip, the push included [N]
  glm::dvec3 guidance_P{0, 0, 0};  ///< of the push alone [N]
  bool in_contact = false;
};

/// A hand at a page for one piece of work after another: the simulated stylus in the real scene.
/// The scene is loaded once. Same page, path, push and seed: same bytes, whatever came before.
class FeltHand {
 public:
  /// On a device of that profile (HandOnDevice, with its coupling and peak force); null: read
  /// exactly. Throws as Scene::Load.
  FeltHand(const HandModel& hand, const SceneOptions& options,
           const DeviceProfile* device = nullptr);

  struct Work {
    const TextureField* field = nullptr;  ///< none: flat paper; must outlive the work
    HandPath path;                        ///< in the world's frame
    const GuidancePlan* push = nullptr;   ///< none: no push
    std::uint64_t seed = 1;               ///< of tremor and drift
  };
  /// Follows the path to its end; `each` is called with every tick.
  void Do(const Work& work, const std::function<void(const HandTick&)>& each);

  const HandModel& model() const { return hand_; }
  const std::optional<DeviceProfile>& device() const { return device_; }
  Pose X_WP() const { return scene_.X_WP(); }
  double tick() const { return tick_; }
  double seconds() const { return seconds_; }  ///< simulated so far [s]

 private:
  HandModel hand_;
  std::optional<DeviceProfile> device_;
  Scene scene_;
  double tick_ = 1e-3;
  double seconds_ = 0;
};

}  // namespace moontrace

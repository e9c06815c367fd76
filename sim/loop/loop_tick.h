#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "devices/core/device.h"
#include "devices/core/tip_estimate.h"
#include "lessons/guide/guidance.h"
#include "sim/loop/button.h"
#include "sim/loop/loop_mail.h"
#include "sim/loop/loop_types.h"
#include "sim/loop/pressing.h"
#include "sim/physics/scene.h"
#include "sim/safety/safety.h"

namespace moontrace {

/// The guiding push of a running loop: the plan in use and its state. Allocates nothing, throws
/// nothing.
class LoopPush {
 public:
  /// Another plan, from its beginning; nullptr: no push. It must outlive its use here.
  void Take(const GuidancePlan* plan) noexcept {
    plan_ = plan;
    state_ = GuidanceState{};
  }
  /// One tick of `tick` [s]. `felt`: force can be felt now; else there is no push, its target on
  /// the path stands still, and a ramp-in follows. `tip_P` [m], `v_P` [m/s].
  GuidanceResult Advance(bool felt, glm::dvec3 tip_P, glm::dvec3 v_P, double tick) noexcept {
    if (felt && plan_ != nullptr) return Guide(*plan_, state_, tip_P, v_P, tick);
    Pause();
    GuidanceResult none;
    none.target_P = glm::dvec2(tip_P);
    return none;
  }
  /// The tip is elsewhere, or force has ended: a ramp-in follows.
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

/// One tick of the loop, without threads and without a clock of its own: read device, frame D to W,
/// scene, guiding push, safety, write device, publish. Run allocates nothing, locks nothing, throws
/// nothing and makes no system call.
class LoopTick {
 public:
  /// `field` and `mail` must outlive the ticks (the field until a page change is done). Throws as
  /// Scene::SetField.
  LoopTick(Scene scene, const TextureField& field, std::unique_ptr<Device> device,
           const DevicePlace& place, const LoopOptions& options, LoopMail& mail);

  /// `time` [s], ascending. `late`: the loop was silent before this tick.
  void Run(double time, bool late) noexcept;

  /// Zero force, after the last tick.
  void Release() noexcept;

  const Scene& scene() const { return scene_; }
  const Safety& safety() const { return safety_; }
  const DeviceLimits& limits() const { return limits_; }

 private:
  /// What is to be felt, frame D [N].
  struct Wanted {
    glm::dvec3 force{0, 0, 0};
    glm::dvec3 push{0, 0, 0};  ///< within it
  };
  void TakeMail() noexcept;
  Pose Base() const noexcept;
  void TakePage() noexcept;
  void TakeLabel(const PostedPage& posted, const glm::dvec3* tip_P) noexcept;
  void Anchor(const std::optional<PageAnchor>& anchor, glm::dvec3 tip_P) noexcept;
  void Tilt(double tilt) noexcept;
  DeviceStatus Read() noexcept;
  TickResult Feel() noexcept;
  void GoAlong(DeviceState& tip) noexcept;
  bool IsSilent(const SafetyInput& input) const noexcept;
  Wanted Want(const TickResult& felt, bool silent) noexcept;
  void HandleButtons(double time, SafetyInput& input) noexcept;
  void Write(glm::dvec3 f_D) noexcept;
  void Lose() noexcept;
  void Restart() noexcept;
  void GoOn() noexcept;
  bool FeelsNothing(const TickResult& felt) const noexcept;
  void ReturnPage(const TickResult& felt) noexcept;
  void Report(LoopEventKind kind) noexcept;
  void ReportSafety(std::uint32_t events) noexcept;
  glm::dvec3 PushFelt(const Wanted& wanted, const SafetyResult& safe) const noexcept;
  void Publish(const TickResult& felt, const SafetyResult& safe, glm::dvec3 push_P) noexcept;

  Scene scene_;
  std::unique_ptr<Device> device_;  ///< none while lost
  DeviceLimits limits_;
  LoopOptions options_;
  LoopMail& mail_;
  DevicePlace home_;      ///< of the device at the first page, at the present tilt
  DevicePlace place_;     ///< of the device at the page that is felt
  glm::dmat3 R_WD_{1.0};  ///< of the first page, before any tilt
  const TextureField* field_;
  LoopPush push_;
  glm::dvec2 target_P_{0, 0};  ///< of the push [m]
  glm::dvec3 v_P_{0, 0, 0};    ///< of the tip [m/s]
  glm::dmat3 moves_{1.0};      ///< PagePoint::moves at the tip, where LoopOptions::on_page
  /// The tip of the last tick there, on the page and in the world [m].
  glm::dvec3 along_P_{0, 0, 0}, along_W_{0, 0, 0};
  bool let_go_ = false;  ///< the page went away under the hand: until it goes on
  Pressing pressing_;
  Safety safety_;
  double tick_ = 0.001;  ///< [s]

  DeviceState state_;  ///< newest reading, frame D
  DeviceStatus written_ = DeviceStatus::kOk;
  bool begun_ = false;      ///< the present device has been read
  TipEstimate tip_;         ///< where it is by its readings, frame D
  double elapsed_ = 0;      ///< since the last tick [s]
  TickResult last_;         ///< of the scene
  bool flowing_ = false;    ///< `last_` is of the tick before and of the same place
  bool delivered_ = false;  ///< the last tick's force was commanded as it was wanted
  double time_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint32_t page_ = 0;
  PostedPage* posted_ = nullptr;
  double fade_ = 1;    ///< share of the force that is left before a page change
  bool back_ = false;  ///< a lost device was opened again, and has not been read
  bool ramp_ = true;   ///< the next tick begins a ramp-in
  bool was_stopped_ = false;
  double felt_nothing_for_ = 0;  ///< for how long FeelsNothing has been true [s]
  ButtonState buttons_;
  std::uint32_t reported_ = 0;  ///< safety events of the last tick
  std::array<double, kSafetyEvents> reported_at_{};
};

}  // namespace moontrace

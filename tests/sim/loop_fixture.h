#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/loop/loop_tick.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {

/// What a device in the same process did, which outlives it.
struct DeviceLog {
  std::vector<glm::dvec3> written;  ///< [N]
  std::atomic<int> reads{0};
  std::string why_lost;
  std::atomic<bool> destroyed{false};
  glm::dvec3 last() const { return written.empty() ? glm::dvec3(0, 0, 0) : written.back(); }
};

/// A device whose every reading a test writes: `read` gets the number of the reading, from 0.
class ScriptedDevice final : public Device {
 public:
  using ReadFunction = std::function<DeviceStatus(int number, DeviceState& state)>;

  ScriptedDevice(DeviceLog& log, ReadFunction read, const DeviceLimits& limits = {})
      : log_(log), read_(std::move(read)), limits_(limits) {
    log_.written.reserve(1 << 18);
  }
  ~ScriptedDevice() override { log_.destroyed = true; }
  DeviceLimits Limits() const noexcept override { return limits_; }
  DeviceStatus Read(DeviceState& state) noexcept override { return read_(log_.reads++, state); }
  std::string WhyLost() override { return log_.why_lost; }
  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    if (log_.written.size() < log_.written.capacity()) log_.written.push_back(f_D);
    return DeviceStatus::kOk;
  }

 private:
  DeviceLog& log_;
  ReadFunction read_;
  DeviceLimits limits_;
};

/// In the middle of the shipped page, 1 mm below the paper: page and coupling, 1000 N/m each, press
/// back with 0.5 N.
inline constexpr glm::dvec3 kPressed{0.1, 0.1, -0.001};
inline constexpr double kPressedForce = 0.5;

inline ScriptedDevice::ReadFunction HoldAt(glm::dvec3 p_D) {
  return [p_D](int, DeviceState& state) {
    state.p_D = p_D;
    return DeviceStatus::kOk;
  };
}

/// The shipped page at 1 kHz, ticked by hand: no threads, no clock.
class LoopTickTest : public testing::Test {
 protected:
  void Begin(ScriptedDevice::ReadFunction read, const DeviceLimits& limits = {},
             const LoopOptions& options = {}) {
    tick_ =
        std::make_unique<LoopTick>(Scene::Load("", SceneOptions{}), field_,
                                   std::make_unique<ScriptedDevice>(log_, std::move(read), limits),
                                   DevicePlace{}, options, mail_);
  }
  void Run(int ticks, bool late = false) {
    for (int i = 0; i < ticks; ++i) {
      ++ticks_;
      tick_->Run(1e-3 * ticks_, late);
    }
  }
  LoopSnapshot Newest() {
    LoopSnapshot snapshot;
    mail_.snapshot.Take(snapshot);
    return snapshot;
  }
  std::uint64_t Count(SafetyEvent event) const {
    return tick_->safety().counts()[static_cast<std::size_t>(event)];
  }
  /// Whether an event of the kind was told since the last call.
  bool Told(LoopEventKind kind, SafetyEvent safety = SafetyEvent::kNotANumber) {
    bool told = false;
    LoopEvent event;
    while (mail_.events.Pop(event)) {
      told = told ||
             (event.kind == kind && (kind != LoopEventKind::kSafety || event.safety == safety));
    }
    return told;
  }

  TextureField field_;  ///< flat
  LoopMail mail_{1000};
  DeviceLog log_;
  std::unique_ptr<LoopTick> tick_;
  int ticks_ = 0;
};

}  // namespace moontrace

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "devices/device.h"

namespace moontrace {

/// What the safety stage did; each is counted, logged and told once a second at most.
enum class SafetyEvent : std::uint8_t {
  kNotANumber,  ///< force or position was no number
  kJump,        ///< the tip moved absurdly far within a tick
  kForceCap,    ///< more than the device's peak was asked for
  kRateCap,     ///< a rise was slowed
  kPowerCap,    ///< more power than the device may give
  kResting,     ///< the motors are warm: the ceiling is lowered ("resting the motors")
  kSilence,     ///< no report for longer than allowed while force was felt
  kDeviceLost,
  kNotReady,      ///< the device says that its motors are off
  kPhysicsFault,  ///< MuJoCo warned, or the scene failed to zero
  kStopped,       ///< stop was asked for; zero until someone agrees to go on
  kLateLoop,      ///< the watchdog saw no tick
};
inline constexpr std::size_t kSafetyEvents = 12;

/// Everything the stage needs to know of one tick.
struct SafetyInput {
  glm::dvec3 force{0, 0, 0};  ///< wanted, frame D [N]
  DeviceState device;         ///< newest reading
  DeviceStatus status = DeviceStatus::kOk;
  double time = 0;  ///< of the tick [s], ascending
  bool physics_fault = false;
  bool stop = false;   ///< asks for a stop (level: while true nothing goes on)
  bool go_on = false;  ///< the learner agrees to go on after a stop (edge)
  bool ramp = false;   ///< begins a ramp-in: start, page change, reconnection (edge)
  bool hold = false;   ///< force is allowed only while held, and it is not held
};

struct SafetyResult {
  glm::dvec3 force{0, 0, 0};    ///< to be commanded, frame D [N]
  std::uint32_t events = 0;     ///< bit per SafetyEvent of this tick
  glm::dvec3 heat{0, 0, 0};     ///< per axis, 1 = the modelled limit
  glm::dvec3 ceiling{0, 0, 0};  ///< per axis [N]
  bool stopped = false;         ///< waits for `go_on`
};

/// The last stage before the device: a pure function of its state and input, without allocation,
/// lock or exception. It lies above the field's own cap and acts seldom. Whatever happens, a fall
/// towards zero is never delayed.
class Safety {
 public:
  /// `tick` [s] between calls. `ramp_time` [s] of a ramp-in, at most 0.3.
  Safety(const DeviceLimits& limits, double tick, double ramp_time = 0.25);
  SafetyResult Advance(const SafetyInput& input) noexcept;

  const std::array<std::uint64_t, kSafetyEvents>& counts() const noexcept { return counts_; }

 private:
  // implementer's choice: value members only
  std::array<std::uint64_t, kSafetyEvents> counts_{};
};

}  // namespace moontrace

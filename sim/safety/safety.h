#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "devices/core/device.h"
#include "devices/core/tip_estimate.h"
#include "sim/safety/motor_heat.h"
#include "sim/safety/still_tip.h"

namespace moontrace {

/// What the safety stage did; each is counted, and reported once a second at most. An event that
/// goes on, or comes again within 0.1 s, is one occurrence and is counted once.
enum class SafetyEvent : std::uint8_t {
  kNotANumber,  ///< a force or position was NaN or infinite
  kJump,        ///< the tip moved farther, or reports a higher velocity, than a hand can
  kForceCap,    ///< more than the device's peak was asked for
  kRateCap,     ///< a rise was slowed
  kPowerCap,    ///< more power than the device may give
  kResting,     ///< the motors are warm: the ceiling is lowered ("resting the motors")
  kSilence,     ///< no report for longer than allowed while force was felt
  kDeviceLost,
  kNotReady,      ///< the device says that its motors are off
  kPhysicsFault,  ///< MuJoCo warned, or the scene failed to zero
  kStopped,       ///< stop was asked for; zero until the learner agrees to go on
  kLateLoop,      ///< no tick for so long that the watchdog has let the device go
  kStuck,         ///< reports go on, but the position does not answer to force (still_tip.h)
};
inline constexpr std::size_t kSafetyEvents = 13;

/// Whether an event means zero force; the others only reduce it; none for a value that
/// is no event.
constexpr std::optional<bool> ForceTaken(SafetyEvent event) noexcept {
  switch (event) {
    case SafetyEvent::kForceCap:
    case SafetyEvent::kRateCap:
    case SafetyEvent::kPowerCap:
    case SafetyEvent::kResting:
      return false;
    case SafetyEvent::kNotANumber:
    case SafetyEvent::kJump:
    case SafetyEvent::kSilence:
    case SafetyEvent::kDeviceLost:
    case SafetyEvent::kNotReady:
    case SafetyEvent::kPhysicsFault:
    case SafetyEvent::kStopped:
    case SafetyEvent::kLateLoop:
    case SafetyEvent::kStuck:
      return true;
  }
  return std::nullopt;
}
static_assert(ForceTaken(static_cast<SafetyEvent>(kSafetyEvents - 1)).has_value() &&
              !ForceTaken(static_cast<SafetyEvent>(kSafetyEvents)).has_value());
constexpr bool TakesForceAway(SafetyEvent event) noexcept {
  return ForceTaken(event).value_or(true);
}

/// Whether a force is commanded as it was wanted, to a hundredth on each axis [N].
inline bool IsWhole(glm::dvec3 commanded, glm::dvec3 wanted) noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(commanded[axis]) >= 0.99 * std::abs(wanted[axis]))) return false;
  }
  return true;
}

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
  bool hold = false;   ///< hold-to-feel, and the button is not held: no force
};

struct SafetyResult {
  glm::dvec3 force{0, 0, 0};    ///< to be commanded, frame D [N]
  std::uint32_t events = 0;     ///< bit per SafetyEvent that is true in this tick
  glm::dvec3 heat{0, 0, 0};     ///< per axis, 1 = the modelled limit
  glm::dvec3 ceiling{0, 0, 0};  ///< per axis [N]
  bool stopped = false;         ///< waits for `go_on`
};

/// Fastest that a hand moves the tip; what is faster is a fault of the device [m/s]. A step of the
/// tip may take 1 to 3 ms of it (5 to 15 mm), whatever the gap between two reports.
inline constexpr double kFastestHand = 5;
/// A tick later than this has found the device let go by the watchdog [s].
inline constexpr double kWatchdogTime = 0.005;

/// The last stage before the device: a pure function of its state and input, without allocation,
/// lock or exception. Its limits lie above the field's own cap, so it rarely acts. In this order:
///
/// 1. Zero at once for a value that is not finite, a jump, silence, a stuck position, a device lost
///    or not ready, a fault of the scene, a late loop, a stop, a button let go (`hold`), and until
///    a first report has come. When the cause is gone the force ramps in again.
/// 2. Ramp-in: times 3u^2 - 2u^3 of the share u of the ramp's time that has passed; and times the
///    share that is left while a tip that stands still is asked to answer.
/// 3. On each axis by itself: the ceiling (peak, or what a warm motor may give), then the rate: a
///    rise by at most `force_rate` from the last command, from zero when the sign has changed.
/// 4. Power: all axes times one factor, so that force times velocity is within `peak_power`. The
///    velocity is the device's, else TipEstimate's.
///
/// So a fall towards zero is never delayed: each axis is at most what is wanted of it.
class Safety {
 public:
  /// `tick` [s] between calls. `ramp_time` [s] of a ramp-in, at most 0.3.
  Safety(const DeviceLimits& limits, double tick, double ramp_time = 0.25) noexcept;
  SafetyResult Advance(const SafetyInput& input) noexcept;

  /// Occurrences so far, by SafetyEvent.
  const std::array<std::uint64_t, kSafetyEvents>& counts() const noexcept { return counts_; }

 private:
  double Elapsed(double time) noexcept;
  std::uint32_t Faults(const SafetyInput& input, double elapsed) noexcept;
  void WatchStillness(const SafetyInput& input, double elapsed) noexcept;
  bool TakeReading(const SafetyInput& input, double elapsed) noexcept;
  glm::dvec3 Shape(glm::dvec3 wanted, std::uint32_t& events) noexcept;
  double ShapeAxis(int axis, double wanted, bool& hot, std::uint32_t& events) const noexcept;
  bool IsResting(bool hot) noexcept;
  void Count(std::uint32_t events) noexcept;

  DeviceLimits limits_;
  double tick_ = 0.001;      ///< [s]
  double ramp_time_ = 0.25;  ///< [s]
  double ramp_ = 0;          ///< of it that has passed [s]
  double clock_ = 0;         ///< time passed since the first tick [s]
  double time_ = 0;          ///< of the last tick, as given [s]
  bool begun_ = false;
  bool read_ = false;      ///< a report has come since the device was there
  double since_read_ = 0;  ///< time since then [s]
  glm::dvec3 p_{0, 0, 0};  ///< newest [m]
  TipEstimate velocity_;
  glm::dvec3 v_{0, 0, 0};  ///< of the tip, known or found [m/s]
  bool silent_ = false;
  bool stopped_ = false;
  bool resting_ = false;
  StillTip still_;
  std::array<MotorHeat, 3> heat_{};
  glm::dvec3 force_{0, 0, 0};                 ///< last commanded [N]
  std::array<double, kSafetyEvents> last_{};  ///< `clock_` when each was last true [s]
  std::array<std::uint64_t, kSafetyEvents> counts_{};
};

}  // namespace moontrace

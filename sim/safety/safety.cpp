#include "sim/safety/safety.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "textures/base/finite.h"

namespace moontrace {
namespace {

constexpr double kLeastRate = 3000;      ///< [N/s]: slower rises would round off a groove's edge
constexpr double kLongestRamp = 0.3;     ///< [s]
constexpr double kLeastStepTime = 1e-3;  ///< [s]: reports may bunch, see kFastestHand
constexpr double kMostStepTime = 3e-3;
constexpr double kSameOccurrence = 0.1;  ///< [s]
constexpr double kRestBegins = 0.5;      ///< heat, of the modelled limit
constexpr double kRestEnds = 0.3;
constexpr double kRounding = 1e-9;  ///< above a cap that is no excess yet, relative

constexpr std::uint32_t Bit(SafetyEvent event) noexcept {
  return 1U << static_cast<unsigned>(event);
}

bool AllFinite(const SafetyInput& input) noexcept {
  return IsFinite(input.force) && IsFinite(input.device.p_D) && std::isfinite(input.time) &&
         (!input.device.velocity_known || IsFinite(input.device.v_D));
}

/// Zero for negative values and NaN.
double NonNegative(double value) noexcept { return value > 0 ? value : 0; }

}  // namespace

Safety::Safety(const DeviceLimits& limits, double tick, double ramp_time) noexcept
    : limits_(limits),
      tick_(NonNegative(tick)),
      ramp_time_(std::min(NonNegative(ramp_time), kLongestRamp)),
      still_(limits) {
  limits_.peak_force = NonNegative(limits.peak_force);
  limits_.peak_power = NonNegative(limits.peak_power);
  limits_.force_rate = limits.force_rate > kLeastRate ? limits.force_rate : kLeastRate;
  limits_.silence = NonNegative(limits.silence);
  for (int axis = 0; axis < 3; ++axis) {
    if (!limits_.pushes[axis]) continue;
    heat_[static_cast<std::size_t>(axis)] = MotorHeat(limits_.peak_force, limits_.continuous_force,
                                                      limits_.heat_time, tick_ + kWatchdogTime);
  }
  last_.fill(-1);
}

/// Time since the last tick; one tick if the clock stands still, runs back or is not finite.
double Safety::Elapsed(double time) noexcept {
  const double passed = time - time_;
  const bool sane = begun_ && std::isfinite(passed) && passed > 0;
  if (std::isfinite(time)) time_ = time;
  begun_ = true;
  return sane ? passed : tick_;
}

/// Takes the newest position and finds the velocity. False: the tip jumped.
bool Safety::TakeReading(const SafetyInput& input, double elapsed) noexcept {
  const bool fresh = input.status == DeviceStatus::kOk;
  bool plausible = true;
  if (fresh) {
    const double most = kFastestHand * std::clamp(since_read_, kLeastStepTime, kMostStepTime);
    // another place is no jump after a ramp
    plausible = !read_ || input.ramp || glm::distance(input.device.p_D, p_) <= most;
    if (!read_ || input.ramp || !plausible) velocity_.Restart();
    p_ = input.device.p_D;
    read_ = true;
    silent_ = false;
    since_read_ = 0;
  }
  velocity_.Advance(elapsed, fresh, p_);
  v_ = input.device.velocity_known ? input.device.v_D : velocity_.v();
  if (input.device.velocity_known) plausible = plausible && glm::length(v_) <= kFastestHand;
  return plausible;
}

/// Checks whether a position that does not change is stuck.
void Safety::WatchStillness(const SafetyInput& input, double elapsed) noexcept {
  if (!AllFinite(input)) return;
  glm::dvec3 wanted{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    if (limits_.pushes[axis]) wanted[axis] = input.force[axis];
  }
  still_.Advance(elapsed, input.status == DeviceStatus::kOk, input.device.p_D, glm::length(wanted));
}

/// What forbids any force in this tick, as bits.
std::uint32_t Safety::Faults(const SafetyInput& input, double elapsed) noexcept {
  std::uint32_t events = 0;
  since_read_ += elapsed;
  if (elapsed > tick_ + kWatchdogTime) events |= Bit(SafetyEvent::kLateLoop);
  if (input.status == DeviceStatus::kLost || input.status == DeviceStatus::kNotReady) {
    const bool lost = input.status == DeviceStatus::kLost;
    events |= Bit(lost ? SafetyEvent::kDeviceLost : SafetyEvent::kNotReady);
    read_ = silent_ = false;  // it may come back elsewhere
    still_.Restart();
    since_read_ = 0;
  }
  if (!AllFinite(input)) {
    events |= Bit(SafetyEvent::kNotANumber);
  } else if (!TakeReading(input, elapsed)) {
    events |= Bit(SafetyEvent::kJump);
  }
  const bool felt = glm::length(force_) > kFeltForce;
  if (felt && since_read_ > limits_.silence) silent_ = true;
  if (silent_) events |= Bit(SafetyEvent::kSilence);
  WatchStillness(input, elapsed);
  if (still_.stuck()) events |= Bit(SafetyEvent::kStuck);
  if (input.physics_fault) events |= Bit(SafetyEvent::kPhysicsFault);
  if (input.stop) {
    stopped_ = true;
  } else if (input.go_on) {
    stopped_ = false;
  }
  if (stopped_) events |= Bit(SafetyEvent::kStopped);
  return events;
}

/// `wanted` cut to the axis' ceiling and rate. `hot`: a warm motor's ceiling cut it.
double Safety::ShapeAxis(int axis, double wanted, bool& hot, std::uint32_t& events) const noexcept {
  if (!limits_.pushes[axis]) return 0;
  const double ceiling = heat_[static_cast<std::size_t>(axis)].Ceiling();
  double size = std::abs(wanted);
  if (size > limits_.peak_force * (1 + kRounding)) events |= Bit(SafetyEvent::kForceCap);
  if (ceiling < limits_.peak_force && size > ceiling) hot = true;
  size = std::min(size, ceiling);
  const double before = wanted * force_[axis] > 0 ? std::abs(force_[axis]) : 0;
  const double most = before + limits_.force_rate * tick_;
  if (size > most * (1 + kRounding)) events |= Bit(SafetyEvent::kRateCap);
  return std::copysign(std::min(size, most), wanted);
}

glm::dvec3 Safety::Shape(glm::dvec3 wanted, std::uint32_t& events) noexcept {
  const double u = ramp_ < ramp_time_ ? ramp_ / ramp_time_ : 1;
  ramp_ += tick_;
  wanted *= still_.share() * u * u * (3 - 2 * u);
  glm::dvec3 force{0, 0, 0};
  bool hot = false;
  for (int axis = 0; axis < 3; ++axis) force[axis] = ShapeAxis(axis, wanted[axis], hot, events);
  if (IsResting(hot)) events |= Bit(SafetyEvent::kResting);
  const double power = glm::dot(force, v_);
  if (power > limits_.peak_power) {
    events |= Bit(SafetyEvent::kPowerCap);
    force *= limits_.peak_power / power;
  }
  return force;
}

/// Whether the motors rest: from when a warm motor had to be spared until all have cooled.
bool Safety::IsResting(bool hot) noexcept {
  double warmest = 0;
  for (const MotorHeat& motor : heat_) warmest = std::max(warmest, motor.heat());
  resting_ = (resting_ && warmest > kRestEnds) || (hot && warmest > kRestBegins);
  return resting_;
}

void Safety::Count(std::uint32_t events) noexcept {
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    if ((events & (1U << i)) == 0) continue;
    if (last_[i] < 0 || clock_ - last_[i] > kSameOccurrence) ++counts_[i];
    last_[i] = clock_;
  }
}

SafetyResult Safety::Advance(const SafetyInput& input) noexcept {
  const double elapsed = Elapsed(input.time);
  // used only to separate occurrences: a leap is harmless, overflow is not
  clock_ += std::min(elapsed, 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    heat_[i].Advance(force_[static_cast<int>(i)], elapsed);
  }
  SafetyResult result;
  result.events = Faults(input, elapsed);
  const bool zero = result.events != 0 || input.hold || !read_;
  if (zero || input.ramp) ramp_ = 0;
  if (zero) {
    still_.Pause();
    if (IsResting(false)) result.events |= Bit(SafetyEvent::kResting);
  } else {
    result.force = Shape(input.force, result.events);
  }
  force_ = result.force;
  for (int axis = 0; axis < 3; ++axis) {
    const MotorHeat& motor = heat_[static_cast<std::size_t>(axis)];
    result.heat[axis] = motor.heat();
    result.ceiling[axis] = motor.Ceiling();
  }
  result.stopped = stopped_;
  Count(result.events);
  return result;
}

}  // namespace moontrace

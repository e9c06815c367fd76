#include "devices/hand/led_stylus.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "textures/base/finite.h"
#include "textures/base/random.h"

namespace moontrace {
namespace {

constexpr double kNoPress = 0.02;  ///< below it the hand has let go [N]

void CheckArguments(const HandModel& hand, const Muscle& muscle, double tick) {
  if (!(hand.mass > 0 && hand.stiffness > 0 && hand.damping >= 0 && hand.drift_wavelength > 0 &&
        hand.late_ticks >= 0)) {
    throw std::invalid_argument("led stylus: the hand lacks mass, spring or wavelength");
  }
  if (!(tick > 0 && muscle.lag > 0 && muscle.speed > 0 && muscle.acceleration > 0)) {
    throw std::invalid_argument("led stylus: the tick or the muscle is not above zero");
  }
}

TickMotion CriticalMotion(const HandModel& hand, double tick) {
  const double omega = std::sqrt(hand.stiffness / hand.mass);
  return MotionOver(1, omega * omega, 2 * omega, tick);
}

}  // namespace

LedStylus::LedStylus(const HandModel& hand, const Muscle& muscle, glm::dvec3 start_D, double tick,
                     std::uint64_t seed)
    : muscle_((CheckArguments(hand, muscle, tick), muscle)),
      tick_(tick),
      damping_(hand.damping),
      late_ticks_(hand.late_ticks),
      held_(MotionOver(hand.mass, hand.stiffness, hand.damping, tick)),
      pressed_(MotionOver(hand.mass, 0, hand.damping, tick)),
      tremor_(hand.tremor_rms, hand.tremor_low, hand.tremor_high, tick, Random(seed).Bits()),
      drift_(hand.drift, hand.drift_wavelength, CriticalMotion(hand, tick), Random(~seed).Bits()),
      forces_(static_cast<std::size_t>(hand.late_ticks) + 1, glm::dvec3(0, 0, 0)),
      intent_(start_D),
      p_(start_D),
      aim_(start_D) {
  wanted_.p_D = start_D;
}

void LedStylus::Lead(const LedAim& aim) noexcept {
  if (IsFinite(aim.p_D) && std::isfinite(aim.press) && aim.press >= 0) wanted_ = aim;
}

DeviceLimits LedStylus::Limits() const noexcept {
  DeviceLimits limits;
  limits.damping = damping_;
  limits.late_ticks = late_ticks_;
  return limits;
}

DeviceStatus LedStylus::Read(DeviceState& state) noexcept {
  if (begun_) Advance();
  begun_ = true;
  state = DeviceState{};
  state.time = static_cast<double>(ticks_) * tick_;
  state.p_D = p_;
  return DeviceStatus::kOk;
}

DeviceStatus LedStylus::Write(glm::dvec3 f_D) noexcept {
  written_ = IsFinite(f_D) ? f_D : glm::dvec3(0, 0, 0);
  return DeviceStatus::kOk;
}

/// A critically damped follower, whose speed and acceleration have bounds. Its lag behind an even
/// movement is 2 / omega. Far from the aim it heads for it no faster than it can brake.
void LedStylus::MoveIntent() noexcept {
  const double omega = 2 / muscle_.lag;
  const glm::dvec3 way = wanted_.p_D - intent_;
  const double distance = glm::length(way);
  glm::dvec3 rate{0, 0, 0};
  if (distance > 0) {
    const double speed = std::min(
        {0.5 * omega * distance, muscle_.speed, std::sqrt(muscle_.acceleration * distance)});
    rate = speed / distance * way;
  }
  glm::dvec3 push = 2 * omega * (rate - intent_rate_);
  const double strength = glm::length(push);
  if (strength > muscle_.acceleration) push *= muscle_.acceleration / strength;
  intent_rate_ += tick_ * push;
  intent_ += tick_ * intent_rate_;
  press_ += std::min(1.0, tick_ / muscle_.lag) * (wanted_.press - press_);
  if (wanted_.press <= 0 && press_ < kNoPress) press_ = 0;
}

/// The force written `late_ticks` ticks ago; keeps the one written now.
glm::dvec3 LedStylus::ArrivingForce() noexcept {
  forces_[slot_] = written_;
  slot_ = slot_ + 1 == forces_.size() ? 0 : slot_ + 1;
  return forces_[slot_];
}

/// Moves one axis on a spring and damper whose other end moves evenly from `from` to `to`.
void LedStylus::Follow(int axis, double from, double to, double force) noexcept {
  const double rate = (to - from) / tick_;
  double x = p_[axis] - from;
  double v = v_[axis] - rate;
  Move(held_, x, v, force);
  p_[axis] = to + x;
  v_[axis] = rate + v;
}

void LedStylus::Advance() noexcept {
  ++ticks_;
  const glm::dvec3 force = ArrivingForce();
  const glm::dvec3 before = intent_;
  MoveIntent();
  const bool pressing = press_ > 0;
  if (pressing) {
    if (!pressing_) drift_.Begin();
    drift_.Travel(glm::dvec2(intent_ - before));
  } else {
    drift_.Relax();
  }
  const glm::dvec3 aim = intent_ + tremor_.Next() + glm::dvec3(drift_.offset(), 0);
  Follow(0, aim_.x, aim.x, force.x);
  Follow(1, aim_.y, aim.y, force.y);
  if (pressing) {
    Move(pressed_, p_.z, v_.z, force.z - press_);
    // when the press ends the hand lifts from the height it is at
    intent_.z = p_.z;
    intent_rate_.z = 0;
    aim_ = {aim.x, aim.y, p_.z};
  } else {
    Follow(2, aim_.z, aim.z, force.z);
    aim_ = aim;
  }
  pressing_ = pressing;
}

}  // namespace moontrace

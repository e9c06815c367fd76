#include "devices/hand/aimed_stylus.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "devices/core/tick_motion.h"
#include "textures/base/finite.h"

namespace moontrace {
namespace {

/// A lifted tip hovers so far above the aim: clear of any ridge [m].
constexpr double kHover = 0.005;
/// The hand goes no faster than this, however far a mouse jumps [m/s].
constexpr double kFastest = 1;
/// An aim farther away than this is approached through the air, without pressing [m].
constexpr double kFar = 0.05;

bool IsUsable(const StylusAim& aim) noexcept {
  return IsFinite(aim.p_D) && std::isfinite(aim.press) && aim.press >= 0;
}

void CheckArguments(const HandModel& hand, const Mailbox<StylusAim>* aims, glm::dvec3 press,
                    double tick) {
  if (!(hand.mass > 0 && hand.stiffness > 0 && hand.damping >= 0 && hand.late_ticks >= 0)) {
    throw std::invalid_argument("aimed stylus: the hand lacks mass or spring");
  }
  if (!(tick > 0)) throw std::invalid_argument("aimed stylus: the tick is not above zero");
  if (aims == nullptr) throw std::invalid_argument("aimed stylus: there is nothing to take from");
  if (!(std::abs(glm::length(press) - 1) < 1e-6)) {
    throw std::invalid_argument("aimed stylus: the press direction is not a unit vector");
  }
}

/// Position and speed that move together, in as many directions as `Value` has.
template <class Value>
struct Motion {
  Value x{0}, v{0};
  void Advance(const TickMotion& motion, Value f) noexcept {
    const Value x0 = x;
    x = motion.xx * x0 + motion.xv * v + motion.xf * f;
    v = motion.vx * x0 + motion.vv * v + motion.vf * f;
  }
};

class AimedStylus final : public Device {
 public:
  AimedStylus(const HandModel& hand, std::shared_ptr<Mailbox<StylusAim>> aims, glm::dvec3 press,
              double tick)
      : aims_(std::move(aims)),
        up_(-glm::normalize(press)),
        tick_(tick),
        damping_(hand.damping),
        late_ticks_(hand.late_ticks),
        held_(MotionOver(hand.mass, hand.stiffness, hand.damping, tick)),
        pressed_(MotionOver(hand.mass, 0, hand.damping, tick)),
        relax_(MotionOver(1, hand.stiffness / hand.mass, 2 * std::sqrt(hand.stiffness / hand.mass),
                          tick)),
        forces_(static_cast<std::size_t>(hand.late_ticks) + 1, glm::dvec3(0, 0, 0)) {
    tip_.x = intent_.x = kHover * up_;
  }

  DeviceLimits Limits() const noexcept override {
    DeviceLimits limits;
    limits.damping = damping_;
    limits.late_ticks = late_ticks_;
    return limits;
  }

  DeviceStatus Read(DeviceState& state) noexcept override {
    TakeAim();
    if (ticks_ > 0) Advance();
    state = DeviceState{};
    state.time = static_cast<double>(ticks_) * tick_;
    state.p_D = tip_.x;
    ++ticks_;
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    written_ = IsFinite(f_D) ? f_D : glm::dvec3(0, 0, 0);
    return DeviceStatus::kOk;
  }

 private:
  void TakeAim() noexcept {
    StylusAim aim;
    if (aims_->Take(aim) && IsUsable(aim)) aim_ = aim;
  }

  bool IsPressing() const noexcept {
    const glm::dvec3 offset = aim_.p_D - intent_.x;
    return aim_.press > 0 && glm::length(offset - glm::dot(offset, up_) * up_) <= kFar;
  }

  /// The force written `late_ticks` ticks ago; keeps the one written now.
  glm::dvec3 ArrivingForce() noexcept {
    forces_[slot_] = written_;
    slot_ = slot_ + 1 == forces_.size() ? 0 : slot_ + 1;
    return forces_[slot_];
  }

  /// Moves the intended point to the aim as quickly as the hand can, without overshoot: a mouse
  /// reports its place in jumps.
  void MoveIntent(bool pressing) noexcept {
    const glm::dvec3 aim = aim_.p_D + (pressing ? 0 : kHover) * up_;
    const glm::dvec3 before = intent_.x;
    intent_.x -= aim;
    intent_.Advance(relax_, glm::dvec3(0, 0, 0));
    intent_.x += aim;
    const double haste = glm::length(intent_.v) / kFastest;
    if (haste > 1) {
      intent_.v /= haste;
      intent_.x = before + tick_ * intent_.v;
    }
    Motion<double> press{press_.x - aim_.press, press_.v};
    press.Advance(relax_, 0);
    press_ = {press.x + aim_.press, press.v};
    if (!pressing) press_ = {};
  }

  void Advance() noexcept {
    const glm::dvec3 force = ArrivingForce();
    const bool pressing = IsPressing();
    const glm::dvec3 before = intent_.x;
    MoveIntent(pressing);
    // the spring and damper are fixed to a point that moves evenly over the tick
    const glm::dvec3 speed = (intent_.x - before) / tick_;
    Motion<glm::dvec3> hung{tip_.x - before, tip_.v - speed};
    hung.Advance(held_, force);
    hung = {hung.x + intent_.x, hung.v + speed};
    if (pressing) {
      Motion<double> height{glm::dot(tip_.x, up_), glm::dot(tip_.v, up_)};
      height.Advance(pressed_, glm::dot(force, up_) - press_.x);
      hung.x += (height.x - glm::dot(hung.x, up_)) * up_;
      hung.v += (height.v - glm::dot(hung.v, up_)) * up_;
      // when the press ends, the hand lifts from where it is
      intent_.x += (height.x - glm::dot(intent_.x, up_)) * up_;
      intent_.v -= glm::dot(intent_.v, up_) * up_;
    }
    tip_ = hung;
  }

  std::shared_ptr<Mailbox<StylusAim>> aims_;
  glm::dvec3 up_{0, 0, 1};
  double tick_ = 0;
  double damping_ = 0;
  int late_ticks_ = 0;
  TickMotion held_, pressed_, relax_;
  std::vector<glm::dvec3> forces_;  ///< not yet arrived, a ring buffer [N]
  std::size_t slot_ = 0;
  std::uint64_t ticks_ = 0;
  StylusAim aim_;
  glm::dvec3 written_{0, 0, 0};
  Motion<glm::dvec3> tip_;     ///< [m], [m/s]
  Motion<glm::dvec3> intent_;  ///< the point that the spring pulls the tip to [m], [m/s]
  Motion<double> press_;       ///< approaches the aim's [N], [N/s]
};

}  // namespace

std::unique_ptr<Device> MakeAimedStylus(const HandModel& hand,
                                        std::shared_ptr<Mailbox<StylusAim>> aims,
                                        glm::dvec3 press_direction_D, double tick) {
  CheckArguments(hand, aims.get(), press_direction_D, tick);
  return std::make_unique<AimedStylus>(hand, std::move(aims), press_direction_D, tick);
}

}  // namespace moontrace

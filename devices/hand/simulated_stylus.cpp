#include "devices/hand/simulated_stylus.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <stdexcept>
#include <utility>

#include "devices/core/tick_motion.h"
#include "devices/hand/drift.h"
#include "devices/hand/tremor.h"
#include "textures/base/finite.h"
#include "textures/base/random.h"

namespace moontrace {
namespace {

/// Where nothing holds it a pressing hand stops so far below where it meant to press, on its own
/// spring: nobody reaches on and on into the void. Ours [m].
constexpr double kFarthest = 0.01;

/// Columns: two directions across the press, and up out of the page, right-handed. The first is the
/// x axis as nearly as it can be, so that a page tilted about x is felt as a level one is.
glm::dmat3 FrameFor(glm::dvec3 press_direction) {
  const glm::dvec3 up = -glm::normalize(press_direction);
  glm::dvec3 across = glm::dvec3(1, 0, 0) - up.x * up;
  if (glm::dot(across, across) < 1e-6) across = glm::dvec3(0, 1, 0) - up.y * up;
  across = glm::normalize(across);
  return glm::dmat3(across, glm::cross(up, across), up);
}

void CheckArguments(const HandModel& hand, const HandPath& path, double tick) {
  if (!(hand.mass > 0 && hand.stiffness > 0 && hand.damping >= 0 && hand.drift_wavelength > 0 &&
        hand.late_ticks >= 0)) {
    throw std::invalid_argument("simulated stylus: the hand lacks mass, spring or wavelength");
  }
  if (!(tick > 0)) throw std::invalid_argument("simulated stylus: the tick is not above zero");
  if (path.points.empty()) throw std::invalid_argument("simulated stylus: the path is empty");
  if (!(std::abs(glm::length(path.press_direction_D) - 1) < 1e-6)) {
    throw std::invalid_argument("simulated stylus: the press direction is not a unit vector");
  }
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const HandPoint& point = path.points[i];
    if (!IsFinite(point.p_D) || !std::isfinite(point.time) || !(point.press >= 0) ||
        (i > 0 && !(point.time > path.points[i - 1].time))) {
      throw std::invalid_argument("simulated stylus: the path is not finite and ascending");
    }
  }
}

/// How an offset dies away: as quickly as the hand can move, without overshoot, starting gently.
TickMotion CriticalMotion(const HandModel& hand, double tick) {
  const double omega = std::sqrt(hand.stiffness / hand.mass);
  return MotionOver(1, omega * omega, 2 * omega, tick);
}

/// What the hand means to do at a moment, in the frame of FrameFor.
struct Intent {
  glm::dvec3 p{0, 0, 0};
  double press = 0;
};

class SimulatedStylus final : public Device {
 public:
  SimulatedStylus(const HandModel& hand, HandPath path, double tick, std::uint64_t seed)
      : tick_(tick),
        damping_(hand.damping),
        late_ticks_(hand.late_ticks),
        frame_(FrameFor(path.press_direction_D)),
        held_(MotionOver(hand.mass, hand.stiffness, hand.damping, tick)),
        pressed_(MotionOver(hand.mass, 0, hand.damping, tick)),
        relax_(CriticalMotion(hand, tick)),
        tremor_(hand.tremor_rms, hand.tremor_low, hand.tremor_high, tick, Random(seed).Bits()),
        drift_(hand.drift, hand.drift_wavelength, relax_, Random(~seed).Bits()),
        repeats_(path.repeats && path.points.back().time > path.points.front().time),
        points_(std::move(path.points)),
        forces_(static_cast<std::size_t>(hand.late_ticks) + 1, glm::dvec3(0, 0, 0)) {
    for (HandPoint& point : points_) point.p_D = point.p_D * frame_;
    intent_ = {points_.front().p_D, points_.front().press};
    p_ = intent_.p;
    shake_ = tremor_.Next();
    aim_ = p_ + shake_;
  }

  DeviceLimits Limits() const noexcept override {
    DeviceLimits limits;
    limits.damping = damping_;
    limits.late_ticks = late_ticks_;
    return limits;
  }

  DeviceStatus Read(DeviceState& state) noexcept override {
    if (begun_) Advance();
    begun_ = true;
    state = DeviceState{};
    state.time = static_cast<double>(ticks_) * tick_;
    state.p_D = frame_ * p_;
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    written_ = IsFinite(f_D) ? f_D * frame_ : glm::dvec3(0, 0, 0);
    return DeviceStatus::kOk;
  }

 private:
  Intent IntentAt(double time) noexcept {
    while (repeats_ && time - lap_begin_ > points_.back().time) {
      lap_begin_ += points_.back().time - points_.front().time;
      next_ = 0;
    }
    time -= lap_begin_;
    while (next_ < points_.size() && points_[next_].time <= time) ++next_;
    if (next_ == 0) return {points_.front().p_D, points_.front().press};
    const HandPoint& a = points_[next_ - 1];
    if (next_ == points_.size()) return {a.p_D, a.press};
    const HandPoint& b = points_[next_];
    const double share = (time - a.time) / (b.time - a.time);
    return {a.p_D + share * (b.p_D - a.p_D), a.press + share * (b.press - a.press)};
  }

  /// The force written `late_ticks` ticks ago; keeps the one written now.
  glm::dvec3 ArrivingForce() noexcept {
    forces_[slot_] = written_;
    slot_ = slot_ + 1 == forces_.size() ? 0 : slot_ + 1;
    return forces_[slot_];
  }

  /// Moves one axis on a spring and damper whose other end moves evenly from `from` to `to`.
  void Follow(int axis, double from, double to, double force) noexcept {
    const double aim_speed = (to - from) / tick_;
    double x = p_[axis] - from;
    double v = v_[axis] - aim_speed;
    Move(held_, x, v, force);
    p_[axis] = to + x;
    v_[axis] = aim_speed + v;
  }

  /// Moves the height by what pushes, which down to `lowest` is all that acts.
  void Press(double lowest, double force) noexcept {
    if (p_.z >= lowest) return Move(pressed_, p_.z, v_.z, force);
    double below = p_.z - lowest;
    Move(held_, below, v_.z, force);
    p_.z = lowest + below;
  }

  void Advance() noexcept {
    ++ticks_;
    const glm::dvec3 force = ArrivingForce();
    const Intent intent = IntentAt(static_cast<double>(ticks_) * tick_);
    const glm::dvec3 shake = tremor_.Next();
    const double press = 0.5 * (intent_.press + intent.press);
    const bool pressing = press > 0;
    if (pressing) {
      if (!pressing_) drift_.Begin();
      drift_.Travel(glm::dvec2(intent.p) - glm::dvec2(intent_.p));
    } else {
      drift_.Relax();
      if (pressing_) {  // the hand lifts from where it is
        height_offset_ = p_.z - (intent_.p.z + shake_.z);
        height_rate_ = 0;
        aim_.z = p_.z;
      }
      Move(relax_, height_offset_, height_rate_, 0);
      if (std::abs(height_offset_) + std::abs(height_rate_) < 1e-12) {  // before denormals
        height_offset_ = height_rate_ = 0;
      }
    }
    glm::dvec3 aim = intent.p + shake + glm::dvec3(drift_.offset(), height_offset_);
    Follow(0, aim_.x, aim.x, force.x);
    Follow(1, aim_.y, aim.y, force.y);
    if (pressing) {
      Press(intent.p.z - kFarthest, force.z - press);
    } else {
      Follow(2, aim_.z, aim.z, force.z);
    }
    aim_ = aim;
    shake_ = shake;
    intent_ = intent;
    pressing_ = pressing;
  }

  double tick_ = 0;
  double damping_ = 0;
  int late_ticks_ = 0;
  glm::dmat3 frame_{1.0};
  TickMotion held_, pressed_, relax_;
  Tremor tremor_;
  Drift drift_;
  bool repeats_ = false;
  double lap_begin_ = 0;            ///< when the path began last, repetitions counted [s]
  std::vector<HandPoint> points_;   ///< in the frame of FrameFor
  std::vector<glm::dvec3> forces_;  ///< not yet arrived, a ring buffer
  std::size_t slot_ = 0;
  std::size_t next_ = 0;  ///< first point later than now
  std::uint64_t ticks_ = 0;
  bool begun_ = false;
  bool pressing_ = false;
  Intent intent_;
  glm::dvec3 written_{0, 0, 0};
  glm::dvec3 p_{0, 0, 0}, v_{0, 0, 0};
  glm::dvec3 aim_{0, 0, 0}, shake_{0, 0, 0};
  double height_rate_ = 0;    ///< [m/s]
  double height_offset_ = 0;  ///< of the height held over the path's [m]
};

}  // namespace

std::unique_ptr<Device> MakeSimulatedStylus(const HandModel& hand, HandPath path, double tick,
                                            std::uint64_t seed) {
  CheckArguments(hand, path, tick);
  return std::make_unique<SimulatedStylus>(hand, std::move(path), tick, seed);
}

}  // namespace moontrace

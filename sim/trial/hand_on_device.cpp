#include "sim/trial/hand_on_device.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "devices/hand/simulated_stylus.h"
#include "sim/loop/device_feel.h"
#include "sim/loop/loop_types.h"
#include "sim/loop/pressing.h"

namespace moontrace {

namespace {

/// What carries the hand on a device without height: a stiff, damped rest at the paper's level.
constexpr double kRestStiffness = 2000;  // [N/m]
constexpr double kRestDamping = 20;      // [N s/m]
/// Higher than this above the paper the hand has let the press go: half of what a plan lifts.
constexpr double kLetGo = 0.001;  // [m]

/// The delay is the profile's.
HandModel WithoutDelay(HandModel hand, const DeviceProfile* profile) {
  if (profile != nullptr) hand.late_ticks = 0;
  return hand;
}

std::size_t DelayOf(const DeviceProfile* profile, double tick) {
  return profile == nullptr ? 0 : static_cast<std::size_t>(std::lround(profile->delay / tick));
}

}  // namespace

HandOnDevice::HandOnDevice(const Setup& setup, const Pose& X_WP)
    : HandOnDevice(MakeSimulatedStylus(WithoutDelay(setup.hand, setup.profile), setup.path,
                                       setup.tick, setup.seed),
                   setup, X_WP) {}

HandOnDevice::HandOnDevice(std::unique_ptr<Device> hand, const Setup& setup, const Pose& X_WP)
    : tick_(setup.tick),
      rounded_(setup.profile != nullptr),
      late_(DelayOf(setup.profile, setup.tick) + 1, glm::dvec3(0, 0, 0)),
      stylus_(std::move(hand)),
      limits_(rounded_ ? LimitsOf(*setup.profile, setup.tick) : stylus_->Limits()),
      X_WP_(X_WP),
      on_page_(setup.on_page),
      press_(setup.press),
      tip_(limits_) {
  if (!rounded_) return;
  step_ = setup.profile->position_step;
  period_ = std::max(1L, std::lround(1 / (setup.profile->rate * setup.tick)));
}

/// What carries a hand that is down on a device without height.
glm::dvec3 HandOnDevice::Support() noexcept {
  const glm::dvec3 up = X_WP_.R[2];
  const double height = FromWorld(X_WP_, p_W_).z;
  const double rate = ticks_ > 0 ? (height - height_) / tick_ : 0;
  height_ = height;
  return std::max(0.0, -kRestStiffness * height - kRestDamping * rate) * up;
}

/// What the device reports, and what its readings say of the tip.
DeviceState HandOnDevice::ReadRounded(double time) noexcept {
  const bool fresh = ticks_ % period_ == 0;
  if (fresh) {
    glm::dvec3 p = p_W_;
    if (!limits_.measures.z) p -= FromWorld(X_WP_, p_W_).z * X_WP_.R[2];
    reading_.p_D = step_ > 0 ? step_ * glm::round(p / step_) : p;
  }
  tip_.Advance(tick_, fresh, reading_.p_D);
  DeviceState tip;
  tip.time = time;
  tip.p_D = tip_.p();
  tip.v_D = tip_.v();
  tip.velocity_known = true;
  return tip;
}

/// From the page's coordinates to the world; the plane that touches the page there is the page for
/// what the device lacks.
void HandOnDevice::GoAlong(const Scene& scene, DeviceState& tip) noexcept {
  const PagePoint point = scene.PointOn(tip.p_D);
  const bool fast = glm::distance(point.p_W, p_W_) > kFastestPage * tick_;
  let_go_ = let_go_ || (fast && ticks_ > 0 && scene.page_goes());
  if (let_go_) {
    moves_ = glm::dmat3(0.0);
    tip.p_D = p_W_;
    return;
  }
  moves_ = point.moves;
  const glm::dvec3 up = glm::normalize(moves_[2]), along = glm::normalize(moves_[0]);
  X_WP_.R = glm::dmat3(along, glm::cross(up, along), up);
  X_WP_.p = point.p_W - X_WP_.R * tip.p_D;
  tip.p_D = point.p_W;
}

DeviceState HandOnDevice::Read(const Scene& scene, const TickResult* last,
                               const TextureField& field) noexcept {
  DeviceState tip;
  stylus_->Read(tip);
  if (on_page_) GoAlong(scene, tip);
  p_W_ = tip.p_D;
  const glm::dvec3 from_W = way_W_;
  way_W_ = p_W_;
  jumped_ = ticks_ == 0;
  if (rounded_) tip = ReadRounded(tip.time);
  if (rounded_ && !limits_.measures.z) {
    const double height = FromWorld(X_WP_, p_W_).z;
    const bool down = height <= kLetGo;
    jumped_ = jumped_ || down != pressed_;
    pressed_ = down;
    tip = Pressed(tip, X_WP_, last, down ? press_ : 0, scene.options(), field);
    way_W_ += (FromWorld(X_WP_, tip.p_D).z - height) * X_WP_.R[2];
  }
  work_ = glm::dot(felt_, way_W_ - from_W);
  return tip;
}

glm::dvec3 HandOnDevice::Given(glm::dvec3 force_W) const noexcept {
  if (!rounded_) return force_W;
  for (int axis = 0; axis < 3; ++axis) {
    if (!limits_.pushes[axis]) force_W[axis] = 0;
  }
  return force_W;
}

void HandOnDevice::Write(glm::dvec3 force_W, double stored) noexcept {
  if (jumped_) {
    energy_.Rebase(stored);
  } else {
    energy_.Add(work_, stored);
  }
  if (ticks_ % period_ == 0) taken_ = force_W;
  late_[static_cast<std::size_t>(ticks_) % late_.size()] = taken_;
  felt_ = late_[static_cast<std::size_t>(ticks_ + 1) % late_.size()];
  const bool carried = rounded_ && !limits_.measures.z;
  const glm::dvec3 acting_W = carried ? Given(felt_) + Support() : Given(felt_);
  stylus_->Write(on_page_ ? acting_W * moves_ : acting_W);  // work is the same in both coordinates
  ++ticks_;
}

SceneOptions HeldOn(const DeviceProfile& profile, const SceneOptions& options, double proxy_mass) {
  return HeldBy(LimitsOf(profile, options.tick), options, proxy_mass);
}

}  // namespace moontrace

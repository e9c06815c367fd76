#include "sim/bench/sampled_device.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace moontrace {

SampledModel ModelOf(const DeviceProfile& profile, double hand_mass, double tick) {
  SampledModel model;
  model.mass = hand_mass;
  model.damping = profile.limits.damping;
  model.tick = tick;
  model.period = std::max(1, static_cast<int>(std::lround(1 / (profile.rate * tick))));
  model.delay = static_cast<int>(std::lround(profile.delay / tick));
  model.position_step = profile.position_step;
  return model;
}

SampledDevice::SampledDevice(const SampledModel& model) : model_(model) {
  model_.delay = std::clamp(model.delay, 0, static_cast<int>(kMostDelay) - 1);
  for (int axis = 0; axis < 3; ++axis) {
    motion_[static_cast<std::size_t>(axis)] =
        MotionOver(model.mass, model.stiffness[axis], model.damping, model.tick);
  }
  late_.fill({0, 0, 0});
}

DeviceStatus SampledDevice::Read(DeviceState& state) noexcept {
  if (tick_ % model_.period != 0) return DeviceStatus::kNoNewData;
  state = DeviceState{};
  state.time = static_cast<double>(tick_) * model_.tick;
  state.p_D = p_;
  const double step = model_.position_step;
  if (step > 0) state.p_D = step * glm::round(p_ / step);
  return DeviceStatus::kOk;
}

void SampledDevice::Advance(glm::dvec3 force, glm::dvec3 hand_force, glm::dvec3 aim) noexcept {
  if (tick_ % model_.period == 0) taken_ = force;
  late_[static_cast<std::size_t>(tick_) % kMostDelay] = taken_;
  felt_ = tick_ < model_.delay ? glm::dvec3(0, 0, 0)
                               : late_[static_cast<std::size_t>(tick_ - model_.delay) % kMostDelay];
  for (int axis = 0; axis < 3; ++axis) {
    double x = p_[axis] - aim[axis];
    Move(motion_[static_cast<std::size_t>(axis)], x, v_[axis], felt_[axis] + hand_force[axis]);
    p_[axis] = aim[axis] + x;
  }
  ++tick_;
}

}  // namespace moontrace

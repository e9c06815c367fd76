#include "sim/bench/device_rig.h"

#include "sim/loop/pressing.h"

namespace moontrace {

namespace {

SampledModel WithHand(const DeviceProfile& profile, const HandModel& hand,
                      glm::dvec3 hand_stiffness, double tick) {
  SampledModel model = ModelOf(profile, hand.mass, tick);
  model.stiffness = hand_stiffness;
  return model;
}

}  // namespace

SceneOptions SceneFor(const DeviceProfile& profile) {
  SceneOptions options;
  const CouplingGains coupling = CouplingOf(profile);
  options.coupling_stiffness = coupling.stiffness;
  options.coupling_damping = coupling.damping;
  return options;
}

DeviceRig::DeviceRig(const DeviceProfile& profile, const HandModel& hand, glm::dvec3 hand_stiffness,
                     const TextureField& field, const SceneOptions& options)
    : limits_(LimitsOf(profile, options.tick)),
      tick_(options.tick),
      press_(hand.press),
      field_(field),
      scene_(Scene::Load("", options)),
      safety_(limits_, options.tick),
      device_(WithHand(profile, hand, hand_stiffness, options.tick)),
      tip_(limits_) {
  scene_.SetField(&field_);
}

void DeviceRig::Step(glm::dvec3 hand_force, glm::dvec3 aim) {
  SafetyInput input;
  input.status = device_.Read(state_);
  if (!limits_.measures.z) state_.p_D.z = 0;
  tip_.Advance(tick_, input.status == DeviceStatus::kOk, state_.p_D);
  DeviceState tip = state_;
  tip.p_D = tip_.p();
  tip.v_D = tip_.v();
  tip.velocity_known = true;
  if (!limits_.measures.z) {
    tip = Pressed(tip, scene_.X_WP(), ticks_ > 0 ? &felt_ : nullptr, press_, scene_.options(),
                  field_);
  }
  felt_ = scene_.Tick(tip, delivered_);
  input.force = felt_.force_W;
  input.device = state_;
  input.time = static_cast<double>(ticks_) * tick_;
  input.physics_fault = felt_.fault;
  safe_ = safety_.Advance(input);
  delivered_ = IsWhole(safe_.force, input.force * glm::dvec3(limits_.pushes));
  device_.Advance(safe_.force, hand_force, aim);
  ++ticks_;
}

void DeviceRig::Follow(glm::dvec3 p, glm::dvec3 next) {
  device_.Place(p, {0, 0, 0});
  Step({0, 0, 0}, p);
  device_.Place(next, {0, 0, 0});
}

}  // namespace moontrace

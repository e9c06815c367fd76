#include "sim/loop/pressing.h"

#include <algorithm>

namespace moontrace {

namespace {
constexpr double kLifted = 0.005;    ///< above the paper [m]
constexpr double kLiftSpeed = 0.05;  ///< at which the tip goes there: no jerk on the proxy [m/s]
}  // namespace

DeviceState Pressed(const DeviceState& world, const Pose& X_WP, const TickResult* last,
                    double press, const SceneOptions& options, const TextureField& field) noexcept {
  glm::dvec3 tip_P = FromWorld(X_WP, world.p_D);
  glm::dvec3 v_P{0, 0, 0};
  if (world.velocity_known) {
    v_P = TurnFromWorld(X_WP, world.v_D);
  } else if (last != nullptr) {
    v_P = (tip_P - last->tip_P) / options.tick;
  }
  v_P.z = 0;
  press = std::min(press, CarriedPress(options.surface, field));
  if (!(press > 0)) {
    const double from = last != nullptr ? last->tip_P.z : kLifted;
    tip_P.z = std::min(kLifted, from + kLiftSpeed * options.tick);
    v_P.z = (tip_P.z - from) / options.tick;
  } else if (options.rendering == Rendering::kProxy && options.coupling_stiffness > 0) {
    tip_P.z = (last != nullptr ? last->proxy_P.z : 0) - press / options.coupling_stiffness;
  } else {  // no proxy: the tip itself, as deep as the press takes it on level paper
    tip_P.z = field.SampleAt(tip_P).displacement - press / options.surface.stiffness;
  }
  DeviceState pressed = world;
  pressed.p_D = ToWorld(X_WP, tip_P);
  pressed.v_D = TurnToWorld(X_WP, v_P);
  pressed.velocity_known = true;
  return pressed;
}

}  // namespace moontrace

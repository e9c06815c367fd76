#pragma once

#include <type_traits>
#include <vector>

#include "sim/physics/coupling.h"
#include "sim/physics/friction.h"
#include "sim/physics/model_loader.h"
#include "sim/physics/passivity.h"
#include "sim/physics/scene.h"

namespace moontrace {

/// What a tick leaves for the next one, besides MuJoCo's state. Doubles only: a record stores its
/// bytes as they are.
struct TickMemory {
  double started = 0;         ///< 1 when a tick came before: the rest holds
  double stored_jumped = 0;   ///< 1 when the stored energy changed by no force: a new field
  glm::dvec3 tip_W{0, 0, 0};  ///< [m]
  glm::dvec3 device_force_W{0, 0, 0};  ///< held since the last tick [N]
  glm::dvec3 page_force_W{0, 0, 0};    ///< the page's, on proxy or tip, mean of the last tick [N]
  glm::dvec3 touch_P{0, 0, 0};         ///< where the page was touched [m]
  glm::dvec3 touch_W{0, 0, 0};         ///< where that was in the world [m]
  double through = 0;                  ///< 1 while the page is pressed through
  double deep = 1;                     ///< 1 while below the depth at which that begins
  double page_share = 1;               ///< of the page's force that is given; fades while through
  Friction friction;
  PassivityObserver observer;
};
static_assert(std::is_trivially_copyable_v<TickMemory> && sizeof(TickMemory) % sizeof(double) == 0);

/// Forces of one integration step, and the state they were computed from.
struct StepForces {
  Pose X_WP;
  glm::dvec3 point_W{0, 0, 0};     ///< the proxy, or the tip when direct [m]
  glm::dvec3 velocity_W{0, 0, 0};  ///< of the proxy [m/s]
  glm::dvec3 point_P{0, 0, 0};     ///< [m]
  double depth = 0;                ///< Contact::depth [m]
  double displacement = 0;         ///< of the texture there [m]
  glm::dvec3 page_P{0, 0, 0};      ///< page's force, friction included [N]
  glm::dvec3 page_W{0, 0, 0};      ///< [N]
  glm::dvec3 pull_W{0, 0, 0};      ///< the coupling's on the proxy, zero when direct [N]
};

struct Scene::Impl {
  Impl(LoadedModel loaded_model, const SceneOptions& scene_options, const std::string& name);

  void SetOptions(const SceneOptions& new_options);
  void SetField(const TextureField* new_field);
  int CheckField(const TextureField* new_field) const;
  void SwapField(const TextureField* new_field, int new_substeps) noexcept;
  void Restart() noexcept;
  void Reset(glm::dvec3 tip_P);
  TickResult Tick(const DeviceState& input, bool delivered) noexcept;

  bool direct() const noexcept { return options.rendering == Rendering::kDirect; }
  glm::dvec3 ProxyPosition() const noexcept;
  glm::dvec3 ProxyVelocity() const noexcept;
  void PlaceProxy(glm::dvec3 p_W, glm::dvec3 v_W) noexcept;

  LoadedModel loaded;
  SceneOptions options;
  Coupling coupling;
  DataPtr d;
  glm::dvec3 lift_W{0, 0, 0};  ///< carries the proxy's weight [N]
  TextureField flat;
  const TextureField* field = &flat;
  int substeps = 1;
  SurfaceLaw law;              ///< of options and field
  double through_depth = 0;    ///< ThroughDepth of the field [m]
  double page_compliance = 0;  ///< greatest velocity per impulse of the page's body [1/kg]
  std::vector<std::string> remarks;
  std::vector<double> caller_qfrc;  ///< the caller's qfrc_applied while ours is added [nv]
  TickMemory memory;

 private:
  StepForces Compute(glm::dvec3 tip_W, glm::dvec3 v_W) noexcept;
  double Observe(glm::dvec3 tip_W, const StepForces& step) noexcept;
  void Integrate(const StepForces& step) noexcept;
  bool IsHeld(const StepForces& step) const noexcept;
  void WatchThrough(const StepForces& step, bool delivered) noexcept;
  void Idle() noexcept;
  TickResult Fail(glm::dvec3 tip_W) noexcept;
};

}  // namespace moontrace

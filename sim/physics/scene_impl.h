#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "sim/physics/coupling.h"
#include "sim/physics/felt_object.h"
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
  glm::dvec3 point_W{0, 0, 0};     ///< the proxy, or the tip when direct [m]
  glm::dvec3 velocity_W{0, 0, 0};  ///< of the proxy [m/s]
  glm::dvec3 touch_T{0, 0, 0};     ///< the point, in the frame of what is touched [m]
  double depth = 0;                ///< Contact::depth [m]
  double sunk = 0;                 ///< below the smooth surface that is touched [m]
  double energy = 0;               ///< that what is touched holds, all of its force given [J]
  glm::dvec3 page_P{0, 0, 0};      ///< force of what is touched, friction included [N]
  glm::dvec3 page_W{0, 0, 0};      ///< [N]
  glm::dvec3 pull_W{0, 0, 0};      ///< the coupling's on the proxy, zero when direct [N]
};

struct Scene::Impl {
  /// `anew`: from the state to which MuJoCo resets, else from that of `data`.
  Impl(LoadedModel loaded_model, DataPtr data, const SceneOptions& scene_options,
       const std::string& name, bool anew);

  void SetOptions(const SceneOptions& new_options);
  void SetField(const TextureField* new_field);
  ReadyPage MakeReady(std::size_t label, const TextureField* field, const Box& text_P) const;
  void Swap(const ReadyPage& page) noexcept;
  void Restart() noexcept;
  void Reset(glm::dvec3 tip_P);
  TickResult Tick(const DeviceState& input, bool delivered) noexcept;

  bool direct() const noexcept { return options.rendering == Rendering::kDirect; }
  /// MuJoCo's contacts act on the proxy.
  bool collides() const noexcept { return options.unlabelled == Unlabelled::kContacts; }
  glm::dvec3 ProxyPosition() const noexcept;
  glm::dvec3 ProxyVelocity() const noexcept;
  void PlaceProxy(glm::dvec3 p_W, glm::dvec3 v_W) noexcept;
  void SetLabel(const LaidLabel& laid);

  /// That carries a label, and which of its labels that is.
  struct Carrier {
    std::size_t object = 0, number = 0;
  };
  Carrier CarrierOf(std::size_t label) const noexcept;
  const FeltObject& page() const noexcept { return objects[page_object]; }
  const LabelOnSolid& page_label() const noexcept { return page().labels[page_number]; }
  /// The page's pose; of a round one, of the plane that touches it below `p_W`.
  Pose PoseOfPage(glm::dvec3 p_W) const noexcept {
    const Pose X_WG = PoseOfGeom(*d, page_geom);
    if (flat && !turned) return {X_WG.R, ToWorld(X_WG, X_GP.p)};
    return PoseOfLabel(X_WG, p_W);
  }
  glm::dvec3 ToPage(glm::dvec3 p_W) const noexcept {
    return flat ? FromWorld(X_WP, p_W) : ToRoundPage(p_W);
  }
  PagePoint PointOn(glm::dvec3 p_P) const noexcept;

  LoadedModel loaded;
  SceneOptions options;
  Coupling coupling;
  DataPtr d;
  glm::dvec3 lift_W{0, 0, 0};       ///< carries the proxy's weight where it is alone [N]
  std::vector<FeltObject> objects;  ///< all that carry labels
  std::size_t page_object = 0;      ///< that carries the page ...
  std::size_t page_number = 0;      ///< ... as this one of its labels
  int page_geom = -1;               ///< that object's geom
  bool pushes = false;              ///< a force can move one of the objects
  bool page_only = true;            ///< there is nothing but a page on a plane
  bool flat = true;                 ///< the page
  bool turned = false;              ///< a flat page, on its geom
  Pose X_GP;                        ///< of a flat page on its geom
  bool rests = false;               ///< a flat page that nothing moves
  Pose X_WP;                        ///< in this step; where it rests, for good
  int substeps = 1;                 ///< of a tick that touches the stiffest object
  int free_substeps = 1;            ///< of one far from everything
  int steps_taken = 0;              ///< that the time step of MuJoCo is set for; 0: for none
  std::vector<std::string> remarks;
  std::vector<double> caller_qfrc;    ///< the caller's qfrc_applied while ours is added [nv]
  std::vector<double> own_qpos;       ///< before a step of RK4 [nq]; of others empty
  std::vector<glm::dvec3> reactions;  ///< force on the tip of each object in this step [N]
  TickMemory memory;
  // more of it, for models that are more than a page
  std::size_t touched = 0;   ///< object that was touched last
  std::vector<Sides> sides;  ///< of each object

 private:
  std::string name_;  ///< of the model, in messages
  void FindObjects();
  void FindPage() noexcept;
  Pose PoseOfLabel(const Pose& X_WG, glm::dvec3 p_W) const noexcept;
  glm::dvec3 ToRoundPage(glm::dvec3 p_W) const noexcept;
  void TakeSteps();
  StepForces Compute(glm::dvec3 tip_W, glm::dvec3 v_W) noexcept;
  StepForces TouchPage(glm::dvec3 point_W, glm::dvec3 velocity_W, glm::dvec3 pull_W) noexcept;
  void TouchObjects(StepForces& step) noexcept;
  Pose FrameOf(std::size_t object) const noexcept;
  double Observe(glm::dvec3 tip_W, const StepForces& step, std::size_t before) noexcept;
  void Integrate(const StepForces& step) noexcept;
  void PushBack(const StepForces& step) noexcept;
  void KeepMomentum() noexcept;
  struct ProxyContact {
    int geom = -1;      ///< the other one
    double depth = -1;  ///< [m]
  };
  ProxyContact CollisionOfProxy() const noexcept;
  glm::dvec3 PullOn(glm::dvec3 stretch_W, glm::dvec3 rate_W) const noexcept;
  void BeginStep() noexcept;
  void FinishStep() noexcept;
  int StepsNow(glm::dvec3 tip_W) const noexcept;
  bool IsHeld(const StepForces& step) const noexcept;
  void WatchThrough(const StepForces& step, bool delivered) noexcept;
  void Idle() noexcept;
  TickResult Fail(glm::dvec3 tip_W) noexcept;
};

}  // namespace moontrace

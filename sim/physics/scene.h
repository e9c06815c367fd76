#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "devices/core/device.h"
#include "sim/physics/coupling.h"
#include "sim/physics/label.h"
#include "sim/physics/label_place.h"
#include "sim/physics/pose.h"
#include "sim/physics/scene_options.h"
#include "textures/field/field.h"

struct mjModel_;
struct mjData_;

namespace moontrace {

/// A point over the page, in the world.
struct PagePoint {
  glm::dvec3 p_W{0, 0, 0};  ///< [m]
  glm::dmat3 moves{1.0};    ///< columns: how it moves as x, y, z of P grow [m/m]
};

/// A page that is ready to be felt, see Scene::MakeReady.
struct ReadyPage {
  std::size_t label = 0;  ///< of the model's, that it lies on
  LabelOnSolid laid;
  Box text_P{};      ///< what its text covers [m]
  int substeps = 1;  ///< of a tick that touches its geom
};

/// A MuJoCo model that carries Moon: owns model and data, but where they are lent; knows the geoms
/// with labels, the proxy and the handle. One of the labels is the page P; the tip feels all of
/// them. One thread at a time; two scenes share nothing.
class Scene {
 public:
  /// Loads an MJCF file; an empty path means the shipped `models/page.xml`. A model without a body
  /// named `moontrace_proxy` gets `models/proxy.xml` inserted. Throws InputError: the file does not
  /// load, a label names no geom or one without a chart, no label at all, a proxy that is not
  /// three free slides that nothing else holds, a tilt of a page that can move, friction too high
  /// for the greatest slope (mu * s_max >= 0.9), h^2 k_eff / m >= 1 even with 64 sub-steps (16
  /// where what carries labels rests).
  static Scene Load(const std::string& model_path, const SceneOptions& options);
  /// The same from MJCF text (a record's model.xml); `name` stands in messages.
  static Scene FromXml(const std::string& xml, const std::string& name,
                       const SceneOptions& options);
  /// On a model and data of the caller's, who keeps them: both outlive their use here. The model
  /// has a proxy; `xml` is what it was made of, for records. Begins in the state that `d` is in,
  /// for which mj_fwdPosition has been called. The model is changed as Load changes its own: time
  /// step, flags, the solvers' scale. No tilt. Throws as Load.
  static Scene Bind(mjModel_* m, mjData_* d, std::string xml, const std::string& name,
                    const SceneOptions& options);

  /// Other options for the model that is loaded, which begins anew as Load leaves it: on flat
  /// paper, the proxy above it. Tick, tilt and label are the model's own by now and stay. Throws
  /// InputError as Load; then the scene is of no more use.
  void SetOptions(const SceneOptions& options);

  /// Sets what is felt on the page from now on. Checks the bounds of Load against this field (so
  /// call it outside the tick); `field` must outlive its use here.
  void SetField(const TextureField* field);

  /// Sets what is felt on another label than the page; its field must outlive its use here. Outside
  /// the tick. Throws as SetField.
  void SetLabel(const LaidLabel& laid);

  /// What is to be felt on a label (nullptr: flat paper), which becomes the page P, made ready
  /// without setting anything; `text_P` as in SceneOptions. Throws as SetField. Any thread, also
  /// while another ticks, but none that swaps.
  ReadyPage MakeReady(std::size_t label, const TextureField* field, const Box& text_P) const;
  /// SetField for the tick: unchecked, without an allocation, lock or exception. What was felt on
  /// the page until now stays there, if another label is the page from now on. The next tick starts
  /// afresh, see Restart.
  void Swap(const ReadyPage& page) noexcept;
  /// The next tick starts afresh, as the first did: the proxy at the tip, no spring stretched. For
  /// a tip that was not moved by a hand: another device, another place of the page.
  void Restart() noexcept;

  /// One tick: coupling and page force into qfrc_applied between mj_step1 and mj_step2, removed
  /// again. The device's frame D is the world's. After a fault the force is zero. `delivered`: the
  /// last tick's force was given whole. While it is not, as it ramps in, a hand sinks without
  /// pressing too hard, and is not taken to be through. No allocation, lock or exception.
  TickResult Tick(const DeviceState& input, bool delivered = true) noexcept;

  /// Puts everything at rest with the proxy at the tip, friction and observer cleared.
  void Reset(glm::dvec3 tip_P);

  const std::vector<Label>& labels() const;  ///< of the model's <custom>, in order
  const Label& page_label() const;           ///< that is the page P
  /// Where the page lies now. A round one: where the plane lies that touches it below the tip, so
  /// that near the tip P is as on paper, and at the tip exact.
  Pose X_WP() const;
  /// Exact; in a round page no deeper than 1.6 times GreatestDepth, whatever the depth.
  PagePoint PointOn(glm::dvec3 p_P) const noexcept;
  glm::dvec2 page_extent() const;     ///< ExtentOf (label_place.h) of the page [m]
  std::vector<Solid> solids() const;  ///< that the labels lie on, one for each
  bool page_is_flat() const;
  /// The page's own body can move: on joints or led, or quite freely.
  bool page_goes() const;
  bool page_falls() const;
  /// Something that carries a label can move: no force bound holds.
  bool page_moves() const;
  const SceneOptions& options() const;
  /// The MJCF that MuJoCo was given, number for number: includes expanded, proxy inserted, folders
  /// of meshes and textures absolute. What a record keeps. (MuJoCo's own saving rounds to six
  /// digits, which would end bit-equal replay.)
  const std::string& model_xml() const;
  /// One-line remarks for the user (time step, proxy inserted, sub-steps).
  const std::vector<std::string>& remarks() const;
  int substeps() const;
  double proxy_mass() const;  ///< that the coupling moves [kg]
  /// ForceBound (coupling.h) of this scene [N]; infinite where the page moves.
  double force_bound(const Movement& movement = {}) const;
  /// Press at which half the depth of the page's grooves is left, or more (surface.h) [N].
  double groove_press() const;
  double carried_press() const;  ///< CarriedPressOn (solid_contact.h) of the page [N]

  /// Everything a replay must start from: MuJoCo's integration state, coupling, friction, observer.
  std::vector<double> State() const;
  void SetState(const std::vector<double>& state);

  /// How far a geom has given way, as a button does, on the one joint of its body that has limits:
  /// 0 where it is in the model as it is loaded, 1 at the farther limit; 0 of every other geom.
  double gives(int geom) const noexcept;

  /// Where label `number` lies: MuJoCo's number of its geom, and its chart with what is felt there.
  int geom_of(std::size_t number) const;
  const LabelOnSolid& laid(std::size_t number) const;

  const mjModel_* model() const;
  mjData_* data();
  const mjData_* data() const;

  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

 private:
  struct Impl;
  explicit Scene(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace moontrace

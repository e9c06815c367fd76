#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "devices/core/profile.h"
#include "devices/core/tip_estimate.h"
#include "devices/hand/hand.h"
#include "sim/physics/passivity.h"
#include "sim/physics/scene.h"

namespace moontrace {

/// A simulated hand as a device of some profile reports it: its true place is rounded to the
/// profile's steps and read at its rate, and a force that is written is held for a period and felt
/// after its delay (which takes the place of the hand's own). What the scene is given is found from
/// the readings as the real loop finds it (TipEstimate; Pressed where the device has no height).
/// Without a profile the hand is read exactly and in every tick.
///
/// A tick is Read, Scene::Tick of what that gave, Write. Same hand, path, profile, seed and forces:
/// same bytes. The device's frame is the world's.
class HandOnDevice {
 public:
  struct Setup {
    HandModel hand;
    HandPath path;  ///< in the world's frame, or the page's
    double tick = 0.001;
    std::uint64_t seed = 1;                  ///< of tremor and drift
    const DeviceProfile* profile = nullptr;  ///< copied; null: exact
    /// Of a device without height: what presses while the hand is down [N].
    double press = 1;
    /// The path is in P, of a page that moves or is round: the hand goes along with the page under
    /// it, as one does who holds on. Then its mass and springs act in coordinates of the page.
    /// It lets go, and stays where it is, once that is faster than a hand.
    bool on_page = false;
  };
  /// The simulated stylus. Throws std::invalid_argument as MakeSimulatedStylus.
  HandOnDevice(const Setup& setup, const Pose& X_WP);
  /// Any hand, that reads its true place in every tick and, on a profile, feels without a delay of
  /// its own. Of the setup hand, path and seed do not count.
  HandOnDevice(std::unique_ptr<Device> hand, const Setup& setup, const Pose& X_WP);

  /// The next tick's input for the scene, which carries `field`; `last` is what its tick before
  /// gave, null at first.
  DeviceState Read(const Scene& scene, const TickResult* last, const TextureField& field) noexcept;
  /// The force on the hand, frame W [N], and what its rendering has stored (TickResult::stored).
  void Write(glm::dvec3 force_W, double stored) noexcept;

  /// The share of a force that the device gives: its axes of force, frame W [N].
  glm::dvec3 Given(glm::dvec3 force_W) const noexcept;

  /// Where the device says that the tip is, frame W, made of its readings [m]; without a profile
  /// where it is.
  glm::dvec3 reported_W() const noexcept { return rounded_ ? tip_.p() : p_W_; }

  glm::dvec3 p_W() const noexcept { return p_W_; }  ///< where the hand truly is [m]
  /// The page went away under the hand.
  bool let_go() const noexcept { return let_go_; }
  /// Energy put out so far by what is rendered, by the hand's true way and the force that it felt
  /// (PassivityObserver) [J]. For a page that rests; a guiding push counts as rendered. On a device
  /// without height the press does the work along it, and each lift or landing begins the balance
  /// anew: nobody moved the tip there.
  double energy_out() const noexcept { return energy_.energy_out(); }

 private:
  DeviceState ReadRounded(double time) noexcept;
  glm::dvec3 Support() noexcept;
  void GoAlong(const Scene& scene, DeviceState& tip) noexcept;

  double tick_;
  bool rounded_;                  ///< a profile was given
  std::vector<glm::dvec3> late_;  ///< forces that have yet to act, a ring of ticks [N]
  std::unique_ptr<Device> stylus_;
  DeviceLimits limits_;
  Pose X_WP_;
  bool on_page_;
  glm::dmat3 moves_{1.0};  ///< PagePoint::moves, on the page
  bool let_go_ = false;
  double press_;
  double step_ = 0;  ///< [m]
  long period_ = 1;  ///< [ticks]
  long ticks_ = 0;
  TipEstimate tip_;
  DeviceState reading_;        ///< newest, rounded
  glm::dvec3 p_W_{0, 0, 0};    ///< [m]
  double height_ = 0;          ///< of the hand over the paper [m]
  glm::dvec3 taken_{0, 0, 0};  ///< newest force that the device took [N]
  glm::dvec3 felt_{0, 0, 0};   ///< since the last tick [N]
  glm::dvec3 way_W_{0, 0, 0};  ///< the hand, at the height that is felt [m]
  bool pressed_ = false;       ///< down, on a device without height
  bool jumped_ = true;         ///< was put elsewhere in this tick
  double work_ = 0;            ///< on the hand over the last tick [J]
  PassivityObserver energy_;
};

/// The options of a scene for that profile: HeldBy (sim/loop/device_feel.h) at the scene's tick.
SceneOptions HeldOn(const DeviceProfile& profile, const SceneOptions& options, double proxy_mass);

}  // namespace moontrace

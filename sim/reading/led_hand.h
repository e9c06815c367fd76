#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/profile.h"
#include "devices/hand/hand.h"
#include "devices/hand/led_stylus.h"
#include "sim/physics/label_place.h"
#include "sim/physics/pose.h"
#include "sim/physics/scene.h"
#include "sim/physics/scene_options.h"
#include "sim/reader/reader_knowledge.h"
#include "sim/reading/senses.h"
#include "sim/trial/hand_on_device.h"
#include "textures/field/field.h"

namespace moontrace {

/// A hand at a page, its device, and what its mind is told.
struct LedHandSetup {
  const TextureField* field = nullptr;  ///< of the paper; must outlive the hand
  std::string model_path;               ///< MJCF; empty = the shipped page
  std::vector<LaidLabel> others;        ///< labels of the model beside the page
  SceneOptions scene;
  HandModel hand;
  bool press_given = true;  ///< else of an object at most Scene::groove_press
  Muscle muscle;
  Senses senses;
  /// What the hand is on; none: a tip that is read exactly, in every tick. Must measure and push
  /// along the paper (CanBeReadOn); without a height a mind goes by walls alone.
  std::optional<DeviceProfile> device;
  /// On a device its stiffness is what the page is felt through there, whatever stands here.
  ReaderKnowledge knowledge;
  double page_turn = 0;           ///< of the sheet under the hand, counter-clockwise [rad]
  glm::dvec2 start_P{0, 0};       ///< where the hand is put [m]
  std::uint64_t hand_seed = 1;    ///< of tremor and drift
  std::uint64_t reader_seed = 1;  ///< of what its mind does by chance
};

/// The sheet lies turned under the hand, whose frame begins where the hand was put.
class SheetUnderHand {
 public:
  SheetUnderHand(const Pose& X_WP, glm::dvec2 start_P, double turn)
      : X_WP_(X_WP), start_P_(start_P), c_(std::cos(turn)), s_(std::sin(turn)) {}
  glm::dvec2 ToPage(glm::dvec2 p) const noexcept {
    return start_P_ + glm::dvec2(c_ * p.x + s_ * p.y, c_ * p.y - s_ * p.x);
  }
  /// The page is round or moves, and the hand goes along: its coordinates are the page's, wherever
  /// that is. `scene` outlives this.
  void GoAlong(const Scene* scene) noexcept { scene_ = scene; }
  glm::dvec3 ToWorldFrame(glm::dvec3 p) const noexcept {
    const glm::dvec3 p_P(ToPage(glm::dvec2(p)), p.z);
    return scene_ != nullptr ? scene_->PointOn(p_P).p_W : ToWorld(X_WP_, p_P);
  }
  /// The force on a hand at `p`: its work is the same in both coordinates.
  glm::dvec3 ToPageFrame(glm::dvec3 f_W, glm::dvec3 p) const noexcept {
    if (scene_ == nullptr) return TurnFromWorld(X_WP_, f_W);
    return f_W * scene_->PointOn({ToPage(glm::dvec2(p)), p.z}).moves;
  }
  /// A place in the world, as the hand has it.
  glm::dvec3 FromWorldFrame(glm::dvec3 p_W) const noexcept {
    const glm::dvec3 p_P = FromWorld(scene_ != nullptr ? scene_->X_WP() : X_WP_, p_W);
    return ToHandFrame({p_P.x - start_P_.x, p_P.y - start_P_.y, p_P.z});
  }
  glm::dvec3 ToHandFrame(glm::dvec3 f_P) const noexcept {
    return {c_ * f_P.x - s_ * f_P.y, s_ * f_P.x + c_ * f_P.y, f_P.z};
  }

 private:
  Pose X_WP_;
  const Scene* scene_ = nullptr;
  glm::dvec2 start_P_;
  double c_, s_;
};

/// A hand at a real scene that a mind leads by touch alone, tick by tick: the hand's place goes to
/// the scene, the scene's force one tick late to the hand, both late to the mind, whose will moves
/// the hand. On a device scene and mind get the place by its readings, in its steps, and the hand
/// feels after its delay (HandOnDevice). Same setup and actions: same bytes.
class LedHand {
 public:
  /// Throws InputError as Scene::Load.
  explicit LedHand(const LedHandSetup& setup);
  ~LedHand();
  LedHand(const LedHand&) = delete;
  LedHand& operator=(const LedHand&) = delete;

  /// What its mind is told: the setup's, with what the hand finds of device and object.
  const ReaderKnowledge& knowledge() const { return knowledge_; }
  double tick() const { return tick_; }  ///< [s]

  /// The next tick: what the mind gets, and no more. Then Lead.
  ReaderInput Feel();
  void Lead(const ReaderAction& action);

  const TickResult& felt() const { return felt_; }  ///< what the mind is not given
  const Scene& scene() const { return scene_; }
  /// A place in the hand's own frame, on the page [m].
  glm::dvec2 ToPage(glm::dvec2 p) const { return sheet_.ToPage(p); }

 private:
  class Stylus;
  void PutHand(const LedHandSetup& setup, const HandModel& hand);
  void Tell(const LedHandSetup& setup, double press);

  double tick_ = 1e-3;
  const TextureField* field_ = nullptr;
  Scene scene_;
  std::optional<ReaderFace> face_;  ///< that carries the page, frame P
  glm::dvec2 start_P_{0, 0};        ///< [m]
  SheetUnderHand sheet_;
  Stylus* stylus_ = nullptr;  ///< in `device_`
  std::optional<HandOnDevice> device_;
  ReaderKnowledge knowledge_;
  LateSenses senses_;
  UnsurePlace unsure_;
  TickResult felt_;
  bool begun_ = false;
};

}  // namespace moontrace

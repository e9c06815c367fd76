#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/profile.h"
#include "devices/hand/hand.h"
#include "lessons/guide/guidance.h"
#include "sim/console/console.h"
#include "sim/physics/label_place.h"
#include "sim/physics/page_field.h"
#include "sim/physics/scene_options.h"
#include "sim/physics/scene_push.h"
#include "sim/trial/plan.h"
#include "sim/trial/trial_result.h"
#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

class Scene;

/// The push of a trial: what people asked for, and the gains that follow from it. None with `mode`
/// off or help 0.
struct TrialGuidance {
  GuidanceMode mode = GuidanceMode::kOff;
  double help = 0;      ///< 0-10, for people and records
  GuidanceGains gains;  ///< that decide
  bool on() const { return mode != GuidanceMode::kOff && help > 0; }
};

/// A push of that kind and strength, from the shipped table.
TrialGuidance GuidanceAt(GuidanceMode mode, double help);

/// Along the strokes of a page, in writing order.
GuidancePlan PlanOf(const TrialGuidance& guidance, const std::vector<IntendedStroke>& strokes);

/// Everything that decides one simulated trial: one page, traced once. Same setup, same bytes.
struct TrialSetup {
  const Script* script = nullptr;  ///< must outlive the trial
  const TextPage* page = nullptr;  ///< must outlive the trial
  TypeStyle style;
  bool blank = false;  ///< the same plan on paper without grooves
  /// The page's own (PageField), where somebody else looks at it too; none: the trial builds it.
  std::shared_ptr<const TextureField> field;
  std::string model_path;         ///< MJCF; empty = the shipped page
  std::vector<LaidLabel> others;  ///< labels of the model beside the page
  SceneOptions scene;
  HandModel hand;
  /// On what device the hand is: its readings, delay, coupling and peak force (HandOnDevice); none:
  /// it is read exactly.
  std::optional<DeviceProfile> device;
  PlanOptions plan;        ///< `plan.press` counts, not the hand's
  TrialGuidance guidance;  ///< along the page's strokes; off: none
  std::uint64_t seed = 1;
  double path_spacing = 0;  ///< of the tip's path kept for a picture [m]; 0: none is kept
  const std::atomic<bool>* stop = nullptr;  ///< looked at every tick; set: Interrupted is thrown
  /// Called each simulated second with the share done, 0 to 1.
  std::function<void(double done)> alive;
  TickWatch watch;                                           ///< none: costs nothing
  double longest = std::numeric_limits<double>::infinity();  ///< ends then, if not before [s]
  /// Called with each piece of work in which MuJoCo runs, which it does; none: it is just done.
  std::function<void(const std::function<void()>& work)> around;
};

/// How the trial is to be recorded (sim/trial/record.h).
struct RecordRequest {
  std::string folder;
  std::string parameters_json;  ///< enough to build page and field again
  bool also_csv = false;
};

/// Page -> field -> scene -> plan -> hand -> ticks -> score, and the record if asked for. Throws
/// InputError (model, friction, sizes), LackError (record folder), Interrupted.
TrialResult RunTrial(const TrialSetup& setup, const RecordRequest* record = nullptr);
/// The same in a scene that is there already, which begins anew as Scene::Reset has it. The setup
/// has a field, which the scene carries from then on; its `model_path` does not count, and its
/// `scene` and `device` are those that this scene was made for.
TrialResult RunTrial(const TrialSetup& setup, Scene& scene, const RecordRequest* record = nullptr);

/// The hand that comes with the program (devices/hand.toml).
HandModel ShippedHand();

/// Whether direct rendering stays quiet (design section 4, point 4): the sideways stiffness felt,
/// k s^2 + F s/r, against what damping b holds when forces act T_eff later, 2 b / T_eff; T_eff is
/// one period, and two more for each tick the device answers late.
struct DirectBound {
  double felt = 0;  ///< [N/m]
  double held = 0;  ///< [N/m]
  bool Holds() const { return felt <= held; }
};
DirectBound BoundOfDirect(const TextureField& field, const Surface& surface, double press,
                          const DeviceLimits& limits, double tick);
/// The same of a simulated hand on a page that is rendered directly, if it does not stay quiet.
std::optional<DirectBound> BuzzOfDirect(const SceneOptions& scene, const TextureField& field,
                                        const HandModel& hand, double press);

}  // namespace moontrace

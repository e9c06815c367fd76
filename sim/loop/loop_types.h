#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "devices/core/device.h"
#include "sim/safety/safety.h"
#include "textures/field/field.h"

namespace moontrace {

/// Where a device's frame D stands in the world: p_W = R (scale p_D) + origin. Positions and
/// velocities are scaled, forces are not.
struct DevicePlace {
  glm::dmat3 R_WD{1.0};
  double scale = 1;              ///< distance in the world per distance of the device
  glm::dvec3 origin_W{0, 0, 0};  ///< of D [m]
};

/// A reading as the world has it; time and buttons stay.
inline DeviceState ToWorld(const DevicePlace& place, const DeviceState& state) noexcept {
  DeviceState moved = state;
  moved.p_D = place.R_WD * (place.scale * state.p_D) + place.origin_W;
  moved.v_D = place.R_WD * (place.scale * state.v_D);
  return moved;
}

/// A force of the world in the device's frame.
inline glm::dvec3 ForceToDevice(const DevicePlace& place, glm::dvec3 f_W) noexcept {
  return f_W * place.R_WD;
}

/// A hand that traces moves by 0.1 m/s, and by 0.6 where it is lifted from below a page. What
/// carries it off faster is a page that turns or slides away under its press. Ours [m/s].
inline constexpr double kFastestPage = 1.5;

/// What a loop depends on besides scene, page and device.
struct LoopOptions {
  double rate = 1000;  ///< kSlowestRate to kFastestRate [Hz]; the scene's tick is its inverse
  double press = 1;    ///< for devices that do not measure z [N]
  bool hold_to_feel = false;  ///< force only while the first button is held
  /// The device's frame is laid on the page, wherever that is and however it is bent, in place of
  /// the world: of the simulated hand, and of what moves in the page's plane. DevicePlace is in
  /// frame P then.
  bool on_page = false;
};

/// What happened. A safety event is reported when it begins, at most once a second.
enum class LoopEventKind : std::uint8_t {
  kSafety,       ///< see `safety`
  kDeviceBack,   ///< a lost device was opened again
  kWentOn,       ///< after a stop
  kSay,          ///< the button asked where the tip is
  kBookmark,     ///< the button asked to keep the place
  kPageChanged,  ///< another page is felt from now on
  kThrough,      ///< the tip was pressed through the paper
  kPageBack,     ///< after a change under the hand: the page lies where it lay, the tip is lifted
  kModelMoved,   ///< the label that is felt now was out of the device's reach
  kPageGone,     ///< the page went away under the hand, faster than kFastestPage: a stop follows
};
struct LoopEvent {
  LoopEventKind kind = LoopEventKind::kSafety;
  SafetyEvent safety = SafetyEvent::kNotANumber;  ///< valid if kSafety
  double time = 0;                                ///< since the loop began [s]
  std::uint32_t page = 0;                         ///< PageChange::page
  glm::dvec3 tip_P{0, 0, 0};                      ///< [m]
};

/// One tick for scoring.
struct LoopSample {
  double time = 0;            ///< since the loop began [s]
  std::uint32_t page = 0;     ///< PageChange::page
  glm::dvec3 tip_P{0, 0, 0};  ///< [m]
  /// As commanded, after safety; of a device without motors what would be felt [N].
  glm::dvec3 force_P{0, 0, 0};
  /// The guiding push within `force_P`, after safety; zero on a device without motors, which cannot
  /// be pushed [N].
  glm::dvec3 guidance_P{0, 0, 0};
  double energy_out = 0;  ///< TickResult::energy_out [J]
  bool in_contact = false;
  bool through = false;  ///< TickResult::through
  bool fault = false;    ///< MuJoCo's
};

/// The newest tick, for viewers and voices.
struct LoopSnapshot {
  std::uint64_t tick = 0;                       ///< number, from 1
  double time = 0;                              ///< since the loop began [s]
  std::uint32_t page = 0;                       ///< PageChange::page
  DeviceState device;                           ///< frame D
  bool present = false;                         ///< a device is there
  bool stopped = false;                         ///< waits for GoOn
  glm::dvec3 tip_P{0, 0, 0}, proxy_P{0, 0, 0};  ///< [m]
  glm::dvec3 force_D{0, 0, 0};                  ///< commanded [N]
  glm::dvec3 force_P{0, 0, 0};                  ///< as LoopSample::force_P
  glm::dvec3 guidance_P{0, 0, 0};               ///< as LoopSample::guidance_P
  glm::dvec2 target_P{0, 0};                    ///< GuidanceResult::target_P, the tip without one
  bool guided = false;                          ///< a plan of a push is in use
  bool guidance_done = false;                   ///< it has been followed to its end
  double depth = 0;                             ///< > 0 in contact [m]
  int geom = -1;                                ///< TickResult::geom
  double gives = 0;                             ///< Scene::gives of it
  glm::dvec3 heat{0, 0, 0};                     ///< SafetyResult::heat
  std::array<std::uint64_t, kSafetyEvents> safety_counts{};
};

/// Where a page goes under a resting hand: the point `to_P` + `ratio` (tip - `from_P`) of the new
/// page comes to lie under the tip, which is at `tip` on the old one. With the same letter's
/// reference points and the ratio of sizes, the very place of the letter that was felt stays under
/// the tip; with ratio 0 the point `to_P` itself.
struct PageAnchor {
  glm::dvec2 from_P{0, 0}, to_P{0, 0};  ///< [m]
  double ratio = 0;
};

/// Another page for a running loop.
struct PageChange {
  std::shared_ptr<const TextureField> field;  ///< may be looked at elsewhere too
  std::uint32_t page = 0;                     ///< any number; samples and events carry it
  Box text_P{};                               ///< what its text covers [m], SceneOptions::text_P
  /// The label of the model that it lies on; none: that of the page before. What was felt there
  /// stays, and must outlive the loop.
  std::optional<std::size_t> label;
  /// Behind a change of the label: where the device stands to that page, frame P. One that is laid
  /// on the page (LoopOptions::on_page) stands so, the anchor holds. Another stays where it is in
  /// the world, if it reaches the anchor's `to_P` there; otherwise the model is moved so.
  std::optional<DevicePlace> place_P;
  std::optional<PageAnchor> anchor;  ///< without: the page lies where the first one lay
  /// The page raised at its far edge from now on [rad], as SceneOptions::tilt; none: as it is. The
  /// tip keeps its height over the paper. Of a device that does not measure z, which lies in the
  /// page's plane, it changes nothing.
  std::optional<double> tilt;
  /// A device that comes with the page (a simulated hand with other plans), or none.
  std::unique_ptr<Device> device;
};

}  // namespace moontrace

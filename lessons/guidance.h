#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "lessons/guidance_mode.h"
#include "lessons/intended_strokes.h"

namespace moontrace {

/// What a mode does at a help level. Lengths that scale with letters are in groove widths.
struct GuidanceGains {
  double stiffness = 0;         ///< [N/m]
  double damping = 0;           ///< across the stroke [N s/m]
  double dead_zone_widths = 0;  ///< [groove widths]
  double cap = 1.5;             ///< greatest force [N]
  double bead_speed = 0.02;     ///< along the stroke [m/s]
  double leash = 0.006;         ///< the bead waits for a tip farther behind [m]
  double cue_amplitude = 0;     ///< of kCorridor's vibration [N]
};

/// Help 0-10 -> gains for every mode, from `lessons/guidance.toml` (ours).
class GuidanceTable {
 public:
  /// Throws InputError: file:line:column, cause, nearest key.
  static GuidanceTable Load(const std::string& path);
  static GuidanceTable Shipped();
  /// Help between whole levels is interpolated; 0 is no push at all.
  GuidanceGains GainsOf(GuidanceMode mode, double help) const;

 private:
  std::vector<std::vector<GuidanceGains>> levels_;  ///< [mode][help]
};

/// Where the push leads: the centre lines of strokes in writing order, cut into lines and arcs with
/// arc lengths, made ready so that a tick searches only near the last arc length.
struct GuidancePath;

/// Everything of a push that does not change while it lasts; immutable, shared by threads.
struct GuidancePlan {
  GuidanceMode mode = GuidanceMode::kOff;
  GuidanceGains gains;
  std::shared_ptr<const GuidancePath> path;  ///< frame P
};

/// Strokes as the path of a push. `speeds`: none, the gains' even speed.
std::shared_ptr<const GuidancePath> MakeGuidancePath(const std::vector<IntendedStroke>& strokes);
/// A recorded way of a hand, led along at its own times [s]: the tutor's stroke.
std::shared_ptr<const GuidancePath> MakeRecordedPath(const std::vector<double>& times,
                                                     const std::vector<glm::dvec3>& tips_P,
                                                     double width);

/// What a push remembers from tick to tick.
struct GuidanceState {
  std::size_t stroke = 0;  ///< that is followed
  double s = 0;            ///< arc length on it, of the nearest point [m]
  double bead = 0;         ///< arc length of the bead on it [m]
  double ramp = 0;         ///< 0-1, rises over 0.3 s
  double phase = 0;        ///< of the corridor's cue [rad]
  bool done = false;       ///< the last stroke has been followed to its end
};

struct GuidanceResult {
  glm::dvec3 force_P{0, 0, 0};  ///< on the tip [N]
  glm::dvec2 target_P{0, 0};    ///< nearest point of the stroke, or the bead [m]
  double error = 0;             ///< signed offset, > 0 to the left of the way [m]
};

/// One tick of a push: a pure function of plan, state, tip and time; allocates nothing, throws
/// nothing. Never above the cap; zero where a number is not finite. `v_P` [m/s], `tick` [s].
GuidanceResult Guide(const GuidancePlan& plan, GuidanceState& state, glm::dvec3 tip_P,
                     glm::dvec3 v_P, double tick) noexcept;

}  // namespace moontrace

#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lessons/measure/scoring.h"

namespace moontrace {

/// One point of the tip's path.
struct PathPoint {
  glm::dvec3 tip_P{0, 0, 0};  ///< [m]
  TracePhase phase = TracePhase::kAir;
  bool in_contact = false;
};

/// What a simulated trial gave.
struct TrialResult {
  TraceScore score;
  double energy_out = 0;  ///< put out by sampling, greatest seen, by the readings [J]
  /// The same by the hand's true way, where a device's readings are another; none with a push.
  std::optional<double> true_energy_out;
  /// ForceBound (sim/physics/coupling.h) of a device that moves evenly; infinite on a page that can
  /// move [N].
  double force_bound = 0;
  double force_per_acceleration = 0;  ///< that the bound grows by [N / (m/s^2)]
  double carried_press = 0;           ///< that the page carries, the least of the pages [N]
  std::size_t through = 0;            ///< times that the tip was pressed through the paper
  double first_through = 0;           ///< when, since the page's beginning; 0: never [s]
  /// When the page went away under the hand, faster than that can follow, since the page's
  /// beginning: the trial ends there [s].
  std::optional<double> page_gone;
  double duration = 0;          ///< simulated [s]
  double real_time_factor = 0;  ///< simulated over elapsed time; the only value that varies
  double stroke_length = 0;     ///< of all intended strokes, a dot counting one width [m]
  std::size_t ticks = 0;
  std::size_t faults =
      0;  ///< ticks at which MuJoCo warned or the tip was too far off: no force there
  std::size_t held = 0;  ///< those at which something else in the model pushed the proxy
  /// Times that the tip left the page, more than 0.1 mm above it, and came back within a line of
  /// text.
  std::size_t lifts_within_lines = 0;
  std::size_t lines = 0;  ///< of text
  /// Where links were left (link_meter.h), once for each; none where nobody planned to follow them.
  std::optional<std::vector<Excursion>> links_left;
  double mean_guidance = 0;  ///< size of the push, over the whole time [N]
  double guidance_work = 0;  ///< that it did on the tip; below 0 where it held it back [J]
  std::vector<PathPoint> path;
  std::vector<std::string> remarks;  ///< the scene's, one line each
};

/// Totals of several pages traced one after the other (merged_metrics.h); greatest values and
/// counts over all. `letters` and `left_at` are left empty, `links_left` counts. `real_time_factor`
/// is of the whole.
TrialResult Merged(const std::vector<TrialResult>& pages);

}  // namespace moontrace

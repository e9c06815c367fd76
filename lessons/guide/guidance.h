#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "lessons/course/guidance_mode.h"
#include "lessons/guide/guidance_table.h"

namespace moontrace {

struct GuidancePath;  // guidance_path.h

/// Everything about a push that does not change while it lasts; immutable, shared by threads.
struct GuidancePlan {
  GuidanceMode mode = GuidanceMode::kOff;
  GuidanceGains gains;
  std::shared_ptr<const GuidancePath> path;  ///< where it leads; frame P
};

/// What a push remembers from tick to tick. A fresh one begins at the first stroke's start.
struct GuidanceState {
  std::size_t stroke = 0;   ///< that is followed, or whose start the push leads to
  bool in_transit = false;  ///< leading from the end of the last stroke to the start of this one
  bool captured = false;    ///< the tip has come to `stroke`
  bool at_end = false;      ///< and has followed it to its end
  double s = 0;             ///< arc length on it, of the nearest point [m]
  double bead = 0;          ///< arc length of the bead on it; in transit, on the line there [m]
  double rest = 0;          ///< since `at_end` [s]
  double ramp = 0;          ///< 0-1, rises over 0.3 s
  double phase = 0;         ///< of the corridor's cue, in turns, 0 to 1
  double time = 0;          ///< of a recorded path [s]
  bool done = false;        ///< the last stroke has been followed to its end
  bool begun = false;       ///< `tip_P` is known
  glm::dvec2 tip_P{0, 0};   ///< in the last tick [m]
  glm::dvec2 from_P{0, 0};  ///< where the transit began [m]
};

struct GuidanceResult {
  glm::dvec3 force_P{0, 0, 0};  ///< on the tip, in the page's plane [N]
  glm::dvec2 target_P{0, 0};    ///< nearest point of the stroke, or the bead [m]
  double error = 0;             ///< signed offset, > 0 to the left of the path [m]
};

/// One tick of a push: a pure function of plan, state, tip and time; allocates nothing, throws
/// nothing. Never above the cap; zero where a number is not finite. `v_P` [m/s], `tick` [s].
///
/// With e the tip's offset from the target, k, b, r0 the gains, all within the cap, in the page's
/// plane only, whether the tip touches the page or not:
///
/// - attract: -k (|e| - r0) e/|e| beyond r0, and -b of the velocity along e. The target is the
///   nearest point near the last one: a window of two widths of the same stroke is searched, and
///   the target moves no more than twice the tip's path and 0.1 mm a tick (at 1 kHz). So it never
///   jumps to a crossing stroke, and where the nearest point jumps (the middle of a ring, the
///   inside of a hairpin) it slides round: force is continuous on any continuous path of the tip.
/// - rail: the same with r0 = 0 and its own gains.
/// - bead: the same, e from a bead that moves along at its speed, waits while the tip is farther
///   than the leash and not ahead, and keeps up with a tip that is ahead: it never holds a hand
///   back. On a recorded path it moves by the recorded times and only waits.
/// - amplify: +k e, shrinking to zero over half a width at the letter's box (of its strokes, one
///   width larger); zero outside.
/// - corridor: a vibration of 100 Hz along e beyond the corridor's edge, growing over half a width,
///   with a mean of zero.
///
/// From stroke to stroke, in writing order: a stroke is taken up where the tip comes within one
/// width of its start; until then attract, rail and bead draw to the start. It is done once its end
/// is nearest, within half a width along and a width across; after 0.15 s, or at once when the tip
/// is lifted by 1 mm, those three lead on in a straight line to the next start, as a bead, through
/// the air or over the paper. Amplify and corridor give nothing there, and take up the stroke, or
/// the one after it, wherever the tip comes within a width of it. Dots are strokes without length;
/// fills are followed along their centre arcs. After the last stroke the push fades out (`done`).
GuidanceResult Guide(const GuidancePlan& plan, GuidanceState& state, glm::dvec3 tip_P,
                     glm::dvec3 v_P, double tick) noexcept;

}  // namespace moontrace

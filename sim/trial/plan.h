#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "devices/hand/hand.h"
#include "lessons/measure/scoring.h"
#include "sim/physics/pose.h"
#include "sim/trial/line_walk.h"

namespace moontrace {

/// How the oracle moves. It knows the strokes; what it cannot know is where drift and tremor take
/// the hand.
struct PlanOptions {
  double speed = 0.040;               ///< along a stroke, greatest [m/s]
  double air_speed = 0.200;           ///< between strokes [m/s]
  double clearance = 0.004;           ///< height of the approach above the paper [m]
  double press = 1.0;                 ///< [N]
  std::optional<double> ridge_press;  ///< on ridges [N]; none: as on grooves
  double settle = 0.10;               ///< rest after landing, before moving on [s]
  double dot_rest = 0.15;             ///< rest on a dot [s]
  bool repeats = false;               ///< at the end back to the beginning, and over again
};

/// A plan and what the hand is doing at each moment of it.
struct Plan {
  HandPath path_W;
  struct Span {
    double begin = 0, end = 0;  ///< [s]
    TracePhase phase = TracePhase::kAir;
    std::size_t stroke = 0;
  };
  std::vector<Span> spans;  ///< ascending, without gaps
  double duration = 0;      ///< [s]
};

/// For each walk: through the air to above its start and down (kAir, then
/// kEntry), press, settle, follow it (kStroke, with a short rest at its end), lift (kLift). A dot
/// is pressed and rested on. From stroke to stroke of one walk it goes over the page (kTravel);
/// before each, and at the quarters of a ring, it eases its press in the groove, so that its drift
/// is gone as it is after a landing. Where a link leaves a ring, the aim leans into the ring while
/// that is traced, and out of it where it is left; beside a fill, which leaves a ring no inner
/// wall, it leans against the outer one.
/// Corners of more than 20 degrees are turned at rest, curves at the speed that `TimeRun` allows.
/// Behind a corner the aim leans outwards, away from the leg it came by, until the two grooves have
/// parted: a hand that has drifted would slide back. A closed smooth stroke by itself is followed
/// w/4 beyond its start. Points lie 5 ms apart at most while the aim moves. `X_WP` says where the
/// page lies. Without strokes the hand rests above the origin.
Plan MakePlan(const std::vector<IntendedStroke>& strokes, const std::vector<Walk>& walks,
              const PlanOptions& options, const Pose& X_WP);

/// The plan of each stroke by itself.
Plan MakeOraclePlan(const std::vector<IntendedStroke>& strokes, const PlanOptions& options,
                    const Pose& X_WP);

}  // namespace moontrace

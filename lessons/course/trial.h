#pragma once

#include <cstdint>
#include <string>

#include "lessons/course/course.h"
#include "lessons/course/guidance_mode.h"

namespace moontrace {

/// One finished piece of work of a learner: a row of the records. Progress depends on nothing else
/// (learning.h), so that it can be computed from the rows at any time.
struct Trial {
  std::int64_t time = 0;  ///< when it ended, Unix time [s]
  std::string lesson;     ///< id
  std::size_t step = 0;   ///< of the lesson, from 0
  StepKind kind = StepKind::kTrace;
  /// What was shown; two joined by a line feed at kPick (shown first, then the other) and kSame.
  /// Empty: no work, but a mark: the learner has ended the step (`right`) or come to it.
  std::string item;
  double size = 0;  ///< of its letters [m]
  GuidanceMode guidance = GuidanceMode::kOff;
  int help = 0;        ///< 0-10; guided if > 0 and a mode is on
  bool probe = false;  ///< unguided by plan, in a guided block
  bool scaled =
      false;  ///< larger or smaller in the hand than on the page: never counts for mastery
  bool simulated = false;  ///< the learner is the program's own

  /// Of kRecognise, kTest: what was said; empty where nothing was asked.
  std::string answer;
  bool right = false;  ///< of an answer; of kTrace: coverage and error within the rule
  double latency = 0;  ///< from the page being felt to the answer [s]

  /// Of kTrace, and of the hand while it explored elsewhere.
  double coverage = 0;      ///< 0-1
  double mean_error = 0;    ///< [m]
  double rms_error = 0;     ///< [m]
  double error_widths = 0;  ///< mean error [groove widths]
  std::int64_t wander_offs = 0;
  double duration = 0;                       ///< [s]
  double log_jerk = 0;                       ///< log dimensionless jerk; 0 where too short
  double spectral_arc = 0;                   ///< SPARC; 0 where too short
  double mean_force = 0, mean_guidance = 0;  ///< [N]
  double guidance_work = 0;                  ///< that the push did on the hand [J]

  bool guided() const { return help > 0 && guidance != GuidanceMode::kOff; }
};

}  // namespace moontrace

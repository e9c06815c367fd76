#pragma once

#include "lessons/course.h"

namespace moontrace {

/// Parameters of the fading rules, from `lessons/guidance.toml` (ours; training-and-ux 1.3).
struct FadeRule {
  enum class Kind { kManual, kLinear, kGate, kAsNeeded } kind = Kind::kGate;
  double linear_step = 0.5;  ///< help lost with each trial
  int gate_good = 2;         ///< good trials in a row that lower help by one
  double forgetting = 0.8;   ///< f_R of assist-as-needed, < 1
  double gain = 2;           ///< g_R [help per groove width of error]
  double dead_zone = 0.3;    ///< error that counts as none [groove widths]
};

/// What fading remembers.
struct FadeState {
  double help = 0;  ///< 0-10
  int good_run = 0;
};

/// Help of the next trial after one with this mean error [groove widths] that was good or not.
/// Assist-as-needed: help' = f_R help + g_R e (Emken, Benitez, Reinkensmeyer 2007).
FadeState Fade(const FadeRule& rule, FadeState state, double error_widths, bool good);

}  // namespace moontrace

#pragma once

#include <string>
#include <string_view>

#include "lessons/measure/felt_shape.h"
#include "lessons/measure/recogniser.h"
#include "sim/study/two_rate_memory.h"

namespace moontrace {

/// How a learner traces.
struct TracingSkill {
  double press = 0.3;            ///< [N]
  double speed = 0.04;           ///< [m/s]
  double deviation = 6e-3;       ///< of a beginner's aim from the stroke, greatest [m]
  double deviation_share = 0.4;  ///< the same, of the letter's size, where that is less
  double general_share = 0.6;    ///< of the deviation that is the same for all letters
  double restless_share = 0.06;  ///< of a beginner's deviation, varies from trial to trial
  double flank_share = 0.5;      ///< of an error prevented by a flank, felt by its force
  double dependence = 0;         ///< share of what was learnt that is gone when the push is
  int lessons_a_trial = 3;       ///< updates of the motor memory by one trial
};

/// How a learner explores what is on the page (LineExplorer), by touch alone.
struct Exploration {
  double press = 0.2;           ///< [N]
  double spacing_share = 0.17;  ///< between sweeps, of the letter's size
  double margin_share = 0.15;   ///< around the letters, of their size
  double put_share = 0.1;     ///< how far from a line's corner the hand is put at most, of the size
  double unsure = 0.25e-3;    ///< rms error of the place that it feels (UnsurePlace) [m]
  double speed = 0.09;        ///< at size `at_size` [m/s]
  double speed_power = 0.75;  ///< of the size, with which the speed goes
  double at_size = 0.04;      ///< [m]
};

/// Everything that a simulated learner is, besides its hand (devices/hand.toml).
struct LearnerModel {
  TwoRates memory;
  TracingSkill tracing;
  Exploration exploration;
  FeelingRule feeling;
  RecogniserRule recognition;
};

/// Reads a learner from TOML. Throws InputError: file:line:column, cause, nearest key.
LearnerModel LoadLearner(const std::string& path);
LearnerModel ParseLearner(std::string_view text, const std::string& name);
/// The one that comes with the program, `lessons/learner.toml`.
LearnerModel ShippedLearner();

}  // namespace moontrace

#pragma once

namespace moontrace {

/// How fast a hand learns and forgets from trial to trial: x' = A x + B e for a slow and a fast
/// part (Smith, Ghazizadeh, Shadmehr 2006), whose values these are.
struct TwoRates {
  double slow_retention = 0.992, slow_gain = 0.02;  ///< A_s, B_s
  double fast_retention = 0.59, fast_gain = 0.21;   ///< A_f, B_f
  /// Time constants with which the parts fade between sessions [days]; ours, see
  /// `lessons/learner.toml`.
  double slow_days = 60, fast_days = 0.05;
};

/// What a hand has learnt of one thing: the share of an error that it corrects in advance.
struct TwoRateMemory {
  double slow = 0, fast = 0;
  double total() const { return slow + fast; }
};

/// Memory after a trial in which `error` was felt, in units of the whole error; 0: nothing was
/// felt, the hand only forgets.
TwoRateMemory AfterTrial(const TwoRates& rates, TwoRateMemory memory, double error);

/// Memory after `days` without a trial.
TwoRateMemory AfterDays(const TwoRates& rates, TwoRateMemory memory, double days);

}  // namespace moontrace

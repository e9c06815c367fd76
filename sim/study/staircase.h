#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace moontrace {

/// How an adaptive staircase goes (transformed up-down, Levitt 1971): easier after each wrong
/// answer, harder after `down` right ones in a row. It settles where the chance of being right is
/// 0.5^(1/down): 0.500, 0.7071, 0.7937 for 1, 2, 3.
struct StaircaseRule {
  int down = 2;                               ///< 1-3
  double start = 0;                           ///< level of the first trial; a lower level is harder
  double least = 0;                           ///< no level below it
  double most = 1e300;                        ///< nor above it
  bool geometric = true;                      ///< steps are factors, > 1, or differences, > 0
  std::vector<double> steps{1.5, 1.25, 1.1};  ///< one until each reversal; the last one stays
  int discard = 2;          ///< first reversals that do not count for the threshold
  int stop_reversals = 10;  ///< it ends after so many
  int stop_trials = 80;     ///< or after so many trials
};

/// One staircase: show `level()`, give the answer to Add, until `done()`.
///
/// For letters that shrink until a hand no longer knows them: the level is the letters' size [m],
/// `start` the largest, `least` what the device renders. A block of trials takes several
/// staircases by turns (NextStaircase), so that nobody foresees the next size:
///
///     StaircaseRule rule;
///     rule.start = 0.02;
///     rule.least = 0.003;
///     std::vector<Staircase> stairs(2, Staircase(rule));
///     while (const auto next = NextStaircase(stairs, random)) {
///       stairs[*next].Add(AskLetterOfSize(stairs[*next].level()));
///     }
///     // stairs[0].Threshold() is the size that was known with 71 %.
class Staircase {
 public:
  /// Throws std::invalid_argument for a rule that leads nowhere: `down` outside 1-3, no steps or
  /// steps that change nothing, bounds crossed, a level of a geometric one not above 0, nothing to
  /// stop.
  explicit Staircase(StaircaseRule rule);

  double level() const { return level_; }
  bool done() const;
  /// Nothing once it is done.
  void Add(bool right);
  int trials() const { return trials_; }
  /// Levels at which it turned, in order.
  const std::vector<double>& reversals() const { return reversals_; }
  /// Mean of the reversals that count, geometric where the steps are; an even number of them, so
  /// that as many from above as from below. None while there are fewer than two.
  std::optional<double> Threshold() const;

 private:
  void Move(int direction);

  StaircaseRule rule_;
  double level_ = 0;
  int trials_ = 0, right_run_ = 0;
  int direction_ = 0;  ///< of the last move: -1 harder, 1 easier
  std::vector<double> reversals_;
};

/// Which of several staircases comes next, by chance among those that are not done; none when all
/// are. `random` is the seed and goes on with each choice.
std::optional<std::size_t> NextStaircase(const std::vector<Staircase>& staircases,
                                         std::uint64_t& random);

}  // namespace moontrace

#pragma once

namespace moontrace {

/// How well something was remembered (FSRS-6, open-spaced-repetition).
enum class Rating { kAgain = 1, kHard = 2, kGood = 3, kEasy = 4 };

/// Memory of one item by FSRS-6 with its 21 default parameters.
struct Memory {
  double stability = 0;   ///< days after which recall has fallen to 0.9; 0: never reviewed
  double difficulty = 0;  ///< 1-10
  /// Reviews within the same session still to come before days count, 0-2: FSRS knows days only.
  /// A new item has two, of 1 and 10 minutes; one that was forgotten has one, of 10.
  int steps = 0;
};

/// Memory after a review `days` after the last one (ignored at the first; below 1: the same day;
/// what is negative or NaN counts as 0). Good does one short step, Easy all; Hard
/// repeats it, Again goes back: to both of a new item, otherwise to the last.
Memory Review(Memory memory, Rating rating, double days);

/// Probability of recall `days` after the last review, 1 at once; 0 for what was never reviewed.
double Retrievability(Memory memory, double days);

/// Days to the next review: minutes, as a part of a day, while short steps are to come; then the
/// whole days after which recall has fallen to `retention` (0 < retention < 1), 1 to 36500. Due at
/// once, 0, for what was never reviewed.
double NextInterval(Memory memory, double retention = 0.9);

}  // namespace moontrace

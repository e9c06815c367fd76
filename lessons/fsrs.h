#pragma once

namespace moontrace {

/// How well something was remembered (FSRS-6, open-spaced-repetition).
enum class Rating { kAgain = 1, kHard = 2, kGood = 3, kEasy = 4 };

/// Memory of one item by FSRS-6 with its 21 default parameters.
struct Memory {
  double stability = 0;   ///< days after which recall has fallen to 0.9; 0: never reviewed
  double difficulty = 0;  ///< 1-10
};

/// Memory after a review `days` after the last one (ignored at the first).
Memory Review(Memory memory, Rating rating, double days);
/// Probability of recall `days` after the last review; 0 for what was never reviewed.
double Retrievability(Memory memory, double days);
/// Days to the next review at a wanted retention of 0.9, whole days, at least 1.
double NextInterval(Memory memory, double retention = 0.9);

}  // namespace moontrace

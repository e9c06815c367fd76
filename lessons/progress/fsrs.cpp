#include "lessons/progress/fsrs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moontrace {
namespace {

// The default parameters and formulas of FSRS-6, as published by open-spaced-repetition
// (free-spaced-repetition-scheduler, wiki "The Algorithm"; py-fsrs 6, ALGORITHM.md).
constexpr std::array<double, 21> kW{0.212,  1.2931, 2.3065, 8.2956, 6.4133, 0.8334, 3.0194,
                                    0.001,  1.8722, 0.1666, 0.796,  1.4835, 0.0614, 0.2629,
                                    1.6483, 0.6014, 1.8729, 0.5425, 0.0912, 0.0658, 0.1542};

constexpr double kLeastStability = 0.001;
constexpr double kLongestInterval = 36500;                                    ///< [days]
constexpr double kFirstStep = 1.0 / (24 * 60), kLastStep = 10.0 / (24 * 60);  ///< [days]

int Grade(Rating rating) { return static_cast<int>(rating); }

/// So that R(S, S) = 0.9.
double CurveFactor() { return std::pow(0.9, -1 / kW[20]) - 1; }

double FreshDifficulty(Rating rating) { return kW[4] - std::exp(kW[5] * (Grade(rating) - 1)) + 1; }

/// Moves less the harder the item is already, and is drawn back to that of a first Easy, which is
/// not limited to 1-10 there.
double NextDifficulty(double difficulty, Rating rating) {
  const double moved = difficulty - kW[6] * (Grade(rating) - 3) * (10 - difficulty) / 9;
  return std::clamp(kW[7] * FreshDifficulty(Rating::kEasy) + (1 - kW[7]) * moved, 1.0, 10.0);
}

double SameDayStability(double stability, Rating rating) {
  const double growth =
      std::exp(kW[17] * (Grade(rating) - 3 + kW[18])) * std::pow(stability, -kW[19]);
  return stability * (rating >= Rating::kGood ? std::max(growth, 1.0) : growth);
}

double RecalledStability(const Memory& memory, Rating rating, double recall) {
  const double hard = rating == Rating::kHard ? kW[15] : 1;
  const double easy = rating == Rating::kEasy ? kW[16] : 1;
  return memory.stability *
         (1 + std::exp(kW[8]) * (11 - memory.difficulty) * std::pow(memory.stability, -kW[9]) *
                  (std::exp(kW[10] * (1 - recall)) - 1) * hard * easy);
}

/// Never above what a second Again on one day would leave.
double ForgottenStability(const Memory& memory, double recall) {
  const double left = kW[11] * std::pow(memory.difficulty, -kW[12]) *
                      (std::pow(memory.stability + 1, kW[13]) - 1) *
                      std::exp(kW[14] * (1 - recall));
  return std::min(left, memory.stability / std::exp(kW[17] * kW[18]));
}

int NextSteps(const Memory& memory, Rating rating) {
  const bool fresh = !(memory.stability > 0);
  const int before = fresh ? 2 : memory.steps;
  if (rating == Rating::kAgain) return std::max(before, 1);
  if (rating == Rating::kHard) return before;
  return rating == Rating::kEasy ? 0 : std::max(before - 1, 0);
}

}  // namespace

Memory Review(Memory memory, Rating rating, double days) {
  Memory next;
  next.steps = NextSteps(memory, rating);
  if (!(memory.stability > 0)) {
    next.stability = kW[static_cast<std::size_t>(Grade(rating) - 1)];
    next.difficulty = std::clamp(FreshDifficulty(rating), 1.0, 10.0);
    return next;
  }
  const double recall = Retrievability(memory, days);
  if (!(days >= 1)) {
    next.stability = SameDayStability(memory.stability, rating);
  } else if (rating == Rating::kAgain) {
    next.stability = ForgottenStability(memory, recall);
  } else {
    next.stability = RecalledStability(memory, rating, recall);
  }
  next.stability = std::max(next.stability, kLeastStability);
  next.difficulty = NextDifficulty(memory.difficulty, rating);
  return next;
}

double Retrievability(Memory memory, double days) {
  if (!(memory.stability > 0)) return 0;
  if (!(days > 0)) return 1;
  return std::pow(1 + CurveFactor() * days / memory.stability, -kW[20]);
}

double NextInterval(Memory memory, double retention) {
  if (!(memory.stability > 0)) return 0;
  if (memory.steps > 0) return memory.steps > 1 ? kFirstStep : kLastStep;
  const double days = memory.stability / CurveFactor() * (std::pow(retention, -1 / kW[20]) - 1);
  return std::clamp(std::round(days), 1.0, kLongestInterval);
}

}  // namespace moontrace

#include "lessons/measure/smoothness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace moontrace {
namespace {

constexpr double kRate = 1000;  // [Hz]

/// Speeds of the minimum-jerk move (Flash and Hogan 1985) over `way` in `time`, both ends included.
std::vector<double> MinimumJerk(double way, double time, double rate = kRate) {
  const auto steps = static_cast<int>(std::lround(time * rate));
  std::vector<double> speeds;
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    speeds.push_back(30 * way / time * s * s * (1 - s) * (1 - s));
  }
  return speeds;
}

/// The same move twice, the second `later` values after the first.
std::vector<double> Twice(const std::vector<double>& move, std::size_t later) {
  std::vector<double> speeds(move.size() + later);
  for (std::size_t i = 0; i < move.size(); ++i) {
    speeds[i] += move[i];
    speeds[i + later] += move[i];
  }
  return speeds;
}

TEST(NormalisedJerk, OfAMinimumJerkMoveIs720WhateverItsSizeAndTime) {
  for (const double time : {0.5, 1.0, 2.0}) {
    for (const double way : {0.006, 0.1}) {
      // Differences of the fourth-order speed are off by 60 / steps^2, the integral by less.
      EXPECT_NEAR(NormalisedJerk(MinimumJerk(way, time), kRate), 720, 1e-4);
    }
  }
  EXPECT_NEAR(NormalisedJerk(MinimumJerk(0.02, 1, 100), 100), 720, 0.05);
}

TEST(LogJerk, OfAMinimumJerkMoveIsTheClosedForm) {
  const double expected = -std::log(720 / (1.875 * 1.875));
  EXPECT_NEAR(expected, -5.3220, 5e-5);
  for (const double time : {0.5, 1.0, 2.0}) {
    EXPECT_NEAR(LogJerk(MinimumJerk(0.02, time), kRate), expected, 1e-6);
  }
}

TEST(LogJerk, IsFartherFromZeroForTwoMovesThanForOne) {
  const std::vector<double> move = MinimumJerk(0.02, 1);
  EXPECT_LT(LogJerk(Twice(move, 1000), kRate), LogJerk(move, kRate) - 1);
}

// The reference's values, which were worked out with another program.
TEST(SpectralArc, GivesTheReferenceValues) {
  for (const double time : {0.5, 1.0, 2.0}) {
    EXPECT_NEAR(SpectralArc(MinimumJerk(0.02, time), kRate), -1.4024, 5e-5);
  }
  const std::vector<double> move = MinimumJerk(0.02, 1);
  EXPECT_NEAR(SpectralArc(Twice(move, 500), kRate), -1.6206, 5e-5);   // overlapping by half
  EXPECT_NEAR(SpectralArc(Twice(move, 1201), kRate), -2.7029, 5e-5);  // 200 zeros between
}

TEST(SpectralArc, HardlyDependsOnTheRate) {
  // Where the threshold is met is known to one bin of the padded spectrum.
  EXPECT_NEAR(SpectralArc(MinimumJerk(0.02, 1, 100), 100), -1.4024, 0.005);
}

TEST(SpeedPeaks, CountsSubmovements) {
  const std::vector<double> move = MinimumJerk(0.02, 1);
  EXPECT_EQ(SpeedPeaks(move), 1u);
  EXPECT_EQ(SpeedPeaks(Twice(move, 700)), 2u);
  EXPECT_EQ(SpeedPeaks(Twice(move, 250)), 1u);  // grown into one
}

TEST(SpeedPeaks, PassesOverRipplesBelowTheProminence) {
  std::vector<double> speeds = MinimumJerk(0.02, 1);
  const double peak = 1.875 * 0.02;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    speeds[i] += 0.02 * peak * std::sin(0.5 * static_cast<double>(i));
  }
  EXPECT_EQ(SpeedPeaks(speeds), 1u);
}

TEST(SpeedPeaks, AMoveThatEndsAtSpeedHasItsPeak) {
  EXPECT_EQ(SpeedPeaks({0, 1, 2, 3, 4, 5, 6, 7}), 1u);
}

TEST(Smoothness, IsZeroWhereItCannotBeTold) {
  for (const std::vector<double>& speeds :
       {std::vector<double>{}, std::vector<double>(6, 1.0), std::vector<double>(100, 0.0)}) {
    const Smoothness none = SmoothnessOf(speeds, kRate);
    EXPECT_EQ(none.normalised_jerk, 0);
    EXPECT_EQ(none.log_jerk, 0);
    EXPECT_EQ(none.spectral_arc, 0);
    EXPECT_EQ(none.peaks, 0);
  }
}

TEST(Smoothness, OfAnEvenSpeedIsFinite) {
  const Smoothness even = SmoothnessOf(std::vector<double>(100, 0.02), kRate);
  EXPECT_TRUE(std::isfinite(even.log_jerk));
  EXPECT_TRUE(std::isfinite(even.spectral_arc));
  EXPECT_EQ(even.peaks, 1);
}

}  // namespace
}  // namespace moontrace

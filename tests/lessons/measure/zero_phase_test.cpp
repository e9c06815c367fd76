#include "lessons/measure/zero_phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRate = 100, kCutoff = 10;  // [Hz]

std::vector<double> Sine(double frequency, std::size_t size = 1000) {
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i) {
    values.push_back(std::sin(2 * kPi * frequency * static_cast<double>(i) / kRate));
  }
  return values;
}

/// Share of the middle of `before` that is left in `after`, in phase with it.
double Gain(const std::vector<double>& after, const std::vector<double>& before) {
  double both = 0, square = 0;
  for (std::size_t i = 300; i < 700; ++i) {
    both += after[i] * before[i];
    square += before[i] * before[i];
  }
  return both / square;
}

// |H|^2 of a Butterworth filter of second order by the bilinear transform, both ways together.
double Expected(double frequency) {
  const double ratio = std::tan(kPi * frequency / kRate) / std::tan(kPi * kCutoff / kRate);
  return 1 / (1 + std::pow(ratio, 4));
}

TEST(ZeroPhaseLowPass, HasTheGainOfItsClosedFormWithoutDelay) {
  for (const double frequency : {1.0, 5.0, 10.0, 20.0, 40.0}) {
    const std::vector<double> before = Sine(frequency);
    const std::vector<double> after = ZeroPhaseLowPass(before, kRate, kCutoff);
    ASSERT_EQ(after.size(), before.size());
    const double gain = Gain(after, before);
    EXPECT_NEAR(gain, Expected(frequency), 1e-6) << frequency;
    for (std::size_t i = 300; i < 700; ++i) ASSERT_NEAR(after[i], gain * before[i], 1e-6);
  }
  EXPECT_DOUBLE_EQ(Expected(kCutoff), 0.5);
}

TEST(ZeroPhaseLowPass, LeavesRestAndEvenMotionAsTheyAre) {
  std::vector<double> ramp;
  for (int i = 0; i < 50; ++i) ramp.push_back(3 + 0.1 * i);
  const std::vector<double> after = ZeroPhaseLowPass(ramp, kRate, kCutoff);
  // What is left of the start after three periods of the cut-off.
  for (std::size_t i = 0; i < ramp.size(); ++i) EXPECT_NEAR(after[i], ramp[i], 1e-3);
  for (const double value : ZeroPhaseLowPass(std::vector<double>(20, 7.0), kRate, kCutoff)) {
    EXPECT_NEAR(value, 7, 1e-12);
  }
}

TEST(ZeroPhaseLowPass, IsTheSameBackwardsInTheMiddle) {
  std::vector<double> values = Sine(3);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.001 * static_cast<double>(i % 7);
  std::vector<double> backwards(values.rbegin(), values.rend());
  const std::vector<double> one = ZeroPhaseLowPass(values, kRate, kCutoff);
  std::vector<double> other = ZeroPhaseLowPass(backwards, kRate, kCutoff);
  std::reverse(other.begin(), other.end());
  for (std::size_t i = 300; i < 700; ++i) EXPECT_NEAR(one[i], other[i], 1e-9);
}

TEST(ZeroPhaseLowPass, GivesBackWhatItCannotFilter) {
  EXPECT_TRUE(ZeroPhaseLowPass({}, kRate, kCutoff).empty());
  EXPECT_EQ(ZeroPhaseLowPass({4}, kRate, kCutoff), std::vector<double>{4});
  const std::vector<double> values{1, 5, 2};
  EXPECT_EQ(ZeroPhaseLowPass(values, 20, 10), values);
}

}  // namespace
}  // namespace moontrace

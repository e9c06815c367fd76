#include "lessons/measure/movement_meter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace moontrace {
namespace {

constexpr double kDistance = 0.02;  // [m]

/// Where a minimum-jerk move over kDistance within `time` is (Flash and Hogan 1985).
double PlaceAt(double at, double time) {
  const double s = at / time;
  return kDistance * s * s * s * (10 - 15 * s + 6 * s * s);
}

MovementMeter Moved(double time, double rate, double noise = 0) {
  MovementMeter meter;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i <= std::lround(time * rate); ++i) {
    const double at = i / rate;
    const glm::dvec2 off(noise * normal(random), noise * normal(random));
    // Along a slanting line, and not from time 0.
    meter.Add(100 + at, PlaceAt(at, time) * glm::dvec2(0.6, 0.8) + off);
  }
  return meter;
}

TEST(MovementMeter, KeepsTheFiguresOfAMinimumJerkMove) {
  for (const double rate : {100.0, 1000.0, 10000.0}) {
    const Smoothness smooth = Moved(1, rate).Measure();
    // At start and end the jerk jumps by 60 D/T^3; the filter rounds each jump over about
    // 1 / (2 pi 10 Hz) = 16 ms, which takes about 3600 x 0.016 = 57 from the integral of 720.
    EXPECT_NEAR(smooth.normalised_jerk, 720, 2 * 57) << rate;
    EXPECT_NEAR(smooth.log_jerk, -5.3220, 2 * 57 / 640.0) << rate;
    EXPECT_NEAR(smooth.spectral_arc, -1.4024, 0.02) << rate;
    EXPECT_EQ(smooth.peaks, 1) << rate;
  }
}

TEST(MovementMeter, IsNotMisledByTheNoiseOfADevice) {
  const Smoothness smooth = Moved(1, 1000, 2e-5).Measure();
  // Unfiltered differences of this noise alone would give the jerk a million times the move's.
  EXPECT_NEAR(smooth.log_jerk, -5.3220, 1);
  EXPECT_NEAR(smooth.spectral_arc, -1.4024, 0.05);
  EXPECT_EQ(smooth.peaks, 1);
}

TEST(MovementMeter, TellsTheSameAsTheWholeTrackAtOnce) {
  // 100 Hz: each bin holds one sample, so the grid is the track itself.
  std::vector<double> x, y;
  MovementMeter meter;
  for (int i = 0; i < 400; ++i) {
    x.push_back(0.01 * std::sin(0.05 * i));
    y.push_back(0.01 * std::cos(0.08 * i));
    meter.Add(0.01 * i, {x.back(), y.back()});
  }
  meter.Add(4, {0, 0});  // closes the last bin
  x = ZeroPhaseLowPass(x, 100, 10);
  y = ZeroPhaseLowPass(y, 100, 10);
  std::vector<double> speeds;
  for (std::size_t i = 1; i < x.size(); ++i) {
    speeds.push_back(100 * std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]));
  }
  const Smoothness online = meter.Measure();
  const Smoothness offline = SmoothnessOf(speeds, 100);
  EXPECT_NEAR(online.normalised_jerk, offline.normalised_jerk, 1e-6 * offline.normalised_jerk);
  EXPECT_NEAR(online.log_jerk, offline.log_jerk, 1e-6);
  EXPECT_NEAR(online.spectral_arc, offline.spectral_arc, 1e-6);
  EXPECT_EQ(online.peaks, offline.peaks);
}

TEST(MovementMeter, FillsSmallGapsAndRefusesGreatOnes) {
  MovementMeter meter;
  for (int i = 0; i <= 1000; ++i) {
    if (i > 400 && i < 480) continue;
    ASSERT_TRUE(meter.Takes(0.001 * i));
    meter.Add(0.001 * i, {PlaceAt(0.001 * i, 1), 0});
  }
  EXPECT_NEAR(meter.duration(), 1, 0.021);
  EXPECT_FALSE(meter.Takes(1.2));
}

TEST(MovementMeter, IsFullAfterItsLongestTime) {
  MovementMeter meter;
  int i = 0;
  while (meter.Takes(0.001 * i) && i < 60000) {
    meter.Add(0.001 * i, {1e-5 * i, 0});
    ++i;
  }
  EXPECT_NEAR(0.001 * i, MovementMeter::kLongest, 0.2);
  EXPECT_NEAR(meter.duration(), 0.001 * i, 0.021);
  EXPECT_TRUE(std::isfinite(meter.Measure().log_jerk));
  meter.Clear();
  EXPECT_TRUE(meter.Takes(1000));
  EXPECT_EQ(meter.duration(), 0);
}

TEST(MovementMeter, HasNothingToTellOfAShortMove) {
  MovementMeter meter;
  for (int i = 0; i < 150; ++i) meter.Add(0.001 * i, {1e-5 * i, 0});
  EXPECT_EQ(meter.duration(), 0);
  EXPECT_EQ(meter.Measure().log_jerk, 0);
}

TEST(MovementMeter, PassesOverTimesThatDoNotGoOn) {
  MovementMeter meter = Moved(1, 1000);
  const double before = meter.duration();
  meter.Add(100, {5, 5});
  meter.Add(101, {5, 5});
  EXPECT_EQ(meter.duration(), before);
}

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

/// A scripted hand, a sample each ms.
class Hand {
 public:
  void Go(double speed, double time) {
    for (int i = 0; i < std::lround(1000 * time); ++i) {
      time_ += 0.001;
      x_ += 0.001 * speed;
      const double shake = tremor * std::sin(2 * kPi * 10 * time_);
      const PauseMeter::Step step = meter.Add(time_, {x_, shake});
      pauses += step.began;
      paused += step.time;
    }
  }
  PauseMeter meter;
  double tremor = 0;  // at 10 Hz [m]
  int pauses = 0;
  double paused = 0;  // [s]

 private:
  double time_ = 0, x_ = 0;
};

TEST(PauseMeter, CountsRestsOfMoreThanThreeTenths) {
  Hand hand;
  hand.Go(0.02, 1);
  hand.Go(0, 0.5);
  hand.Go(0.02, 1);
  hand.Go(0, 0.2);
  hand.Go(0.02, 1);
  hand.Go(0, 1);
  EXPECT_EQ(hand.pauses, 2);
  // Up to 0.6 mm of the way before and after belong to it: 30 ms at 20 mm/s.
  EXPECT_NEAR(hand.paused, 1.5, 3 * 0.03 + 0.002);
}

TEST(PauseMeter, SpeedBelowV0IsAPauseAndAboveIsNone) {
  Hand slow;
  slow.Go(0.9 * PauseMeter::kSpeed, 5);
  EXPECT_EQ(slow.pauses, 1);
  EXPECT_NEAR(slow.paused, 5, 0.01);
  Hand fast;
  fast.Go(1.1 * PauseMeter::kSpeed, 5);
  EXPECT_EQ(fast.pauses, 0);
  EXPECT_EQ(fast.paused, 0);
}

TEST(PauseMeter, IsNotEndedByTremor) {
  Hand hand;
  hand.tremor = 1.4e-4;  // the shipped hand's 0.1 mm rms: up to 9 mm/s
  hand.Go(0.02, 1);
  hand.Go(0, 2);
  hand.Go(0.02, 1);
  EXPECT_EQ(hand.pauses, 1);
  EXPECT_NEAR(hand.paused, 2, 0.07);
}

TEST(PauseMeter, ABreakBeginsAnew) {
  Hand hand;
  hand.Go(0, 0.25);
  hand.meter.Break();
  hand.Go(0, 0.25);
  EXPECT_EQ(hand.pauses, 0);
  hand.Go(0, 0.25);
  hand.meter.Break();
  hand.Go(0, 0.5);
  EXPECT_EQ(hand.pauses, 2);
}

}  // namespace
}  // namespace moontrace

#include "lessons/measure/movement_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "lessons/measure/zero_phase.h"

namespace moontrace {
namespace {

constexpr double kWay = 0.02;  // [m]

/// Where a minimum-jerk move over kWay within `time` is (Flash and Hogan 1985).
double PlaceAt(double at, double time) {
  const double s = at / time;
  return kWay * s * s * s * (10 - 15 * s + 6 * s * s);
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

}  // namespace
}  // namespace moontrace

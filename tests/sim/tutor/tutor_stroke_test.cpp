#include "sim/tutor/tutor_stroke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace moontrace {
namespace {

constexpr double kTick = 1e-3;      // [s]
constexpr double kBar = 1e-4;       // [m], of recorded against played back (issue 4: 0.1 mm)
constexpr double kPressed = -1e-4;  // [m]

/// A J of 20 mm: a straight stem, then a hook, at a speed that a hand has, with its tremor.
glm::dvec3 WayOfJ(double t, double duration) {
  constexpr double kStem = 0.015, kHook = 0.005;  // [m]
  const double tau = t / duration;
  const double share = tau * tau * tau * (10 + tau * (-15 + 6 * tau));  // minimum jerk
  const double s = share * (kStem + std::numbers::pi * kHook);
  glm::dvec3 p(0.1, 0.1, kPressed);
  if (s < kStem) {
    p.y -= s;
  } else {
    const double angle = (s - kStem) / kHook;
    p += glm::dvec3(-kHook * (1 - std::cos(angle)), -kStem - kHook * std::sin(angle), 0);
  }
  const double tremor = 1e-4 * std::sin(2 * std::numbers::pi * 9 * t);
  return p + glm::dvec3(tremor, 0.5 * tremor, 0.1 * tremor);
}

TEST(StrokeRecorder, GivesBackTheWayAndItsTimes) {
  constexpr double kDuration = 2;
  StrokeRecorder recorder;
  const double begin = 17.25;  // of a loop that has run for a while
  for (int i = -500; i <= 2500; ++i) {
    const double t = i * kTick;
    const bool touches = t >= 0 && t <= kDuration;
    glm::dvec3 tip_P = WayOfJ(std::clamp(t, 0.0, kDuration), kDuration);
    if (!touches) tip_P.z += 0.01;
    recorder.Add(begin + t, tip_P, touches);
  }
  const auto stroke = recorder.Stroke();
  ASSERT_TRUE(stroke);
  EXPECT_EQ(stroke->times.front(), 0);
  EXPECT_NEAR(stroke->times.back(), kDuration, kTick);  // less than a step, rounding besides
  double worst = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double t = i * kTick;
    worst = std::max(worst, glm::length(TipAt(*stroke, t) - WayOfJ(t, kDuration)));
  }
  EXPECT_LT(worst, kBar);
  EXPECT_LT(worst, 2.1e-5);               // what its declaration promises, and rounding
  EXPECT_LT(stroke->times.size(), 400U);  // of 2001: thinned
  EXPECT_GT(stroke->times.size(), 50U);   // and not to a polygon
  for (std::size_t i = 1; i < stroke->times.size(); ++i) {
    EXPECT_GT(stroke->times[i], stroke->times[i - 1]);
  }
}

TEST(StrokeRecorder, KeepsARestAndAStraightLineInFewPoints) {
  StrokeRecorder recorder;
  for (int i = 0; i <= 3000; ++i) {  // 1 s along, 1 s at rest, 1 s on
    const double t = i * kTick;
    const double x = t < 1 ? t : (t < 2 ? 1 : t - 1);
    recorder.Add(t, {0.02 * x, 0, kPressed}, true);
  }
  const auto stroke = recorder.Stroke();
  ASSERT_TRUE(stroke);
  EXPECT_LE(stroke->times.size(), 40U);  // kLookAhead may cut the rest
  EXPECT_NEAR(TipAt(*stroke, 1.5).x, 0.02, 2e-5);
  EXPECT_NEAR(TipAt(*stroke, 3).x, 0.04, 1e-12);
}

TEST(StrokeRecorder, BridgesShortLiftsAndKeepsLongOnes) {
  const auto recorded = [](double lift) {
    StrokeRecorder recorder;
    for (int i = 0; i <= 2000; ++i) {
      const double t = i * kTick;
      const bool lifted = t > 1 && t < 1 + lift;
      recorder.Add(t, {0.01 * t, 0, lifted ? 0.005 : kPressed}, !lifted);
    }
    return *recorder.Stroke();
  };
  const RecordedStroke bridged = recorded(0.1), kept = recorded(0.5);
  EXPECT_NEAR(TipAt(bridged, 1.05).z, kPressed, 1e-6);
  EXPECT_NEAR(TipAt(bridged, 1.05).x, 0.0105, 2e-5);
  EXPECT_NEAR(TipAt(kept, 1.25).z, 0.005, 2e-5);
  EXPECT_EQ(kept.times.back(), 2);
}

TEST(StrokeRecorder, GivesNothingWhereThereWasNoStroke) {
  StrokeRecorder none, air, moment, still;
  EXPECT_FALSE(none.Stroke());
  for (int i = 0; i < 1000; ++i) {
    const double t = i * kTick;
    air.Add(t, {t, 0, 0.01}, false);
    moment.Add(t, {t, 0, 0}, i > 500 && i < 550);
    still.Add(t, {0.1, 0.1, kPressed}, true);
  }
  EXPECT_FALSE(air.Stroke());
  EXPECT_FALSE(moment.Stroke());
  EXPECT_FALSE(still.Stroke());
}

TEST(StrokeRecorder, LeavesOutWhatIsNoNumberOrNotInTime) {
  StrokeRecorder clean, dirty;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * kTick;
    clean.Add(t, {0.02 * t, 0, kPressed}, true);
    dirty.Add(t, {0.02 * t, 0, kPressed}, true);
    dirty.Add(t + 0.2 * kTick, {nan, 0, 0}, true);
    dirty.Add(t - 0.5, {0.5, 0, 0}, true);
    dirty.Add(t, {0.5, 0, 0}, true);
    dirty.Add(infinite, {0.5, 0, 0}, true);
  }
  EXPECT_EQ(dirty.Stroke()->times, clean.Stroke()->times);
}

TEST(StrokeRecorder, StopsAtItsLongest) {
  StrokeRecorder recorder(1);
  for (int i = 0; i <= 3000; ++i) recorder.Add(5 + i * kTick, {1e-5 * i, 0, kPressed}, true);
  EXPECT_TRUE(recorder.full());
  EXPECT_NEAR(recorder.Stroke()->times.back(), 1, 1.5 * kTick);
}

}  // namespace
}  // namespace moontrace

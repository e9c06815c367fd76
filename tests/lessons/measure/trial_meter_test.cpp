#include "lessons/measure/trial_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "lessons/measure/movement_meter.h"

namespace moontrace {
namespace {

constexpr double kTick = 0.001, kWidth = 1.2e-3, kLength = 0.020;  // [s], [m], [m]

const std::vector<IntendedStroke> kStraight{
    {StrokeKind::kStroke, {Line{{0, 0}, {kLength, 0}}}, kWidth, 0}};

/// A minimum-jerk move along a line that is `aside` of the stroke, in 1 s, pushed by `push`; the
/// hand is above the page for 2 s before.
Trial Measured(double aside, glm::dvec3 push, double press = 1) {
  TrialMeter meter(kStraight, 1, kTick);
  TraceSample sample;
  sample.tip_P = {0, aside, 0.01};
  for (int i = 0; i < 2000; ++i) {
    sample.time = kTick * i;
    meter.Add(sample, {0, 0, 0});
  }
  sample.in_contact = true;
  sample.phase = TracePhase::kStroke;
  sample.force_P = {0, 0, press};
  for (int i = 0; i <= 1000; ++i) {
    const double s = 0.001 * i;
    sample.time = 2 + s;
    sample.tip_P = {kLength * s * s * s * (10 - 15 * s + 6 * s * s), aside, -1e-4};
    meter.Add(sample, push);
  }
  Trial trial;
  meter.Fill(trial);
  EXPECT_EQ(meter.Coverage(), trial.coverage);
  return trial;
}

TEST(TrialMeter, FillsInWhatAHandDid) {
  const double d = 0.25e-3;
  const Trial trial = Measured(d, {0, 0, 0}, 0.7);
  EXPECT_NEAR(trial.coverage, 1, 1e-12);
  EXPECT_NEAR(trial.mean_error, d, 1e-15);
  EXPECT_NEAR(trial.rms_error, d, 1e-15);
  EXPECT_NEAR(trial.error_widths, d / kWidth, 1e-12);
  EXPECT_EQ(trial.wander_offs, 0);
  EXPECT_NEAR(trial.duration, 1, 1e-9);  // the time above the page is not the trial's
  EXPECT_NEAR(trial.mean_force, 0.7, 1e-12);
  // The move's own figures within what the stated filter takes (movement_meter_test.cpp).
  EXPECT_NEAR(trial.log_jerk, -5.3220, 0.18);
  EXPECT_NEAR(trial.spectral_arc, -1.4024, 0.02);
}

TEST(TrialMeter, OfAnUnguidedHandNoPushIsTold) {
  const Trial trial = Measured(0, {0, 0, 0});
  EXPECT_EQ(trial.mean_guidance, 0);
  EXPECT_EQ(trial.guidance_work, 0);
}

TEST(TrialMeter, APushAlongTheWayDoesForceTimesWayAsWork) {
  const Trial along = Measured(0, {0.3, 0.4, 0});
  EXPECT_NEAR(along.mean_guidance, 0.5, 1e-12);
  // The first tick's push grows from nothing, over no way yet; the way down is across the push.
  EXPECT_NEAR(along.guidance_work, 0.3 * kLength, 1e-9);
  EXPECT_NEAR(Measured(0, {-0.3, 0, 0}).guidance_work, -0.3 * kLength, 1e-9);
  EXPECT_NEAR(Measured(0, {0, 0.4, 0}).guidance_work, 0, 1e-12);
}

TEST(TrialMeter, KnowsNothingOfAPageThatWasNeverTouched) {
  TrialMeter meter(kStraight, 1, kTick);
  Trial trial;
  meter.Fill(trial);
  EXPECT_EQ(trial.coverage, 0);
  EXPECT_EQ(trial.duration, 0);
  EXPECT_EQ(trial.log_jerk, 0);
  EXPECT_EQ(trial.mean_force, 0);
}

TEST(TrialMeter, StaysFiniteWhateverADeviceSays) {
  TrialMeter meter(kStraight, 1, kTick);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TraceSample sample;
  sample.in_contact = true;
  sample.phase = TracePhase::kStroke;
  for (int i = 0; i < 500; ++i) {
    sample.time = kTick * i;
    sample.tip_P = {i % 7 == 0 ? nan : 4e-5 * i, 0, 0};
    sample.force_P = {0, 0, i % 5 == 0 ? nan : 1.0};
    meter.Add(sample, {i % 11 == 0 ? nan : 0.1, 0, 0});
  }
  Trial trial;
  meter.Fill(trial);
  for (const double value :
       {trial.coverage, trial.mean_error, trial.log_jerk, trial.spectral_arc, trial.mean_force,
        trial.mean_guidance, trial.guidance_work, trial.duration}) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace moontrace

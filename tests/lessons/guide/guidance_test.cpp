#include "lessons/guide/guidance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "tests/lessons/guidance_fixture.h"

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr GuidanceMode kAllModes[] = {GuidanceMode::kOff,     GuidanceMode::kAttract,
                                      GuidanceMode::kRail,    GuidanceMode::kBead,
                                      GuidanceMode::kAmplify, GuidanceMode::kCorridor};

IntendedStroke LongLine() { return GuideStroke({Line{{0, 0}, {0.04, 0}}}); }

/// A state in which the tip has come to the start of the first stroke and the ramp is over.
GuidanceState Arrived(const GuidancePlan& plan) {
  GuidanceState state;
  HoldTip(plan, state, PointAt(plan.path->strokes[0], 0), 400);
  return state;
}

TEST(Attract, PullsByStiffnessTimesTheWayBeyondTheDeadZone) {
  GuidancePlan plan = GuidePlan(GuidanceMode::kAttract, {LongLine()});
  plan.gains.dead_zone_widths = 0.5;
  GuidanceState state = Arrived(plan);
  MoveTip(plan, state, {0, 0}, {0.02, 0}, 500);
  for (const double off : {0.0008, 0.002, 0.005}) {
    const GuidanceResult left = HoldTip(plan, state, {0.02, off}, 100);
    EXPECT_NEAR(left.force_P.y, -200 * (off - 0.0007), 1e-9);
    EXPECT_NEAR(left.force_P.x, 0, 1e-9);  // free along the stroke
    EXPECT_NEAR(left.error, off, 1e-12);
    EXPECT_NEAR(HoldTip(plan, state, {0.02, -off}, 100).error, -off, 1e-12);
  }
  for (const double off : {0.0, 0.0003, 0.00069}) {
    EXPECT_EQ(HoldTip(plan, state, {0.02, off}, 100).force_P, glm::dvec3(0, 0, 0));
  }
}

TEST(Attract, DampsAcrossTheStrokeOnlyOutsideTheDeadZone) {
  GuidancePlan plan = GuidePlan(GuidanceMode::kAttract, {LongLine()});
  plan.gains.dead_zone_widths = 0.5;
  plan.gains.damping = 2;
  GuidanceState state = Arrived(plan);
  MoveTip(plan, state, {0, 0}, {0.02, 0}, 500);
  HoldTip(plan, state, {0.02, 0.002}, 100);
  const glm::dvec3 v{0.05, 0.03, 0};
  EXPECT_NEAR(Guide(plan, state, {0.02, 0.002, 0}, v, kGuideTick).force_P.y,
              -200 * 0.0013 - 2 * 0.03, 1e-9);
  EXPECT_NEAR(Guide(plan, state, {0.02, 0.002, 0}, v, kGuideTick).force_P.x, 0, 1e-9);
  HoldTip(plan, state, {0.02, 0.0005}, 100);
  EXPECT_EQ(Guide(plan, state, {0.02, 0.0005, 0}, v, kGuideTick).force_P, glm::dvec3(0, 0, 0));
}

TEST(Rail, HasNoDeadZone) {
  const GuidancePlan plan = GuidePlan(GuidanceMode::kRail, {LongLine()});
  GuidanceState state = Arrived(plan);
  MoveTip(plan, state, {0, 0}, {0.02, 0}, 500);
  EXPECT_NEAR(HoldTip(plan, state, {0.02, 1e-5}, 100).force_P.y, -200 * 1e-5, 1e-9);
}

TEST(Guide, RampsInOverThreeTenthsOfASecond) {
  const GuidancePlan plan = GuidePlan(GuidanceMode::kRail, {LongLine()});
  GuidanceState state;
  double last = 0;
  for (int i = 1; i <= 300; ++i) {
    const double force = glm::length(HoldTip(plan, state, {0, 0.001}, 1).force_P);
    EXPECT_GE(force, last - 1e-12);
    EXPECT_LT(i > 1 ? 0 : force, 1e-4);
    EXPECT_NEAR(i == 150 ? force : 0.1, 0.1, 1e-3);  // 3u^2 - 2u^3 at a half
    last = force;
  }
  EXPECT_NEAR(last, 0.2, 1e-9);
}

TEST(Guide, IsNeverAboveTheCapOrOutOfThePlane) {
  const IntendedStroke ring = GuideStroke({Arc{{0.01, 0.01}, 0.006, 0, 2 * kPi}});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-0.03, 0.05), speed(-1, 1);
  for (const GuidanceMode mode : kAllModes) {
    GuidancePlan plan = GuidePlan(mode, {ring, LongLine()});
    plan.gains.damping = 3;
    plan.gains.stiffness = 400;
    plan.gains.cue_amplitude = 5;
    GuidanceState state;
    for (int i = 0; i < 3000; ++i) {
      const glm::dvec3 force = Guide(plan, state, {anywhere(random), anywhere(random), 0},
                                     {speed(random), speed(random), 0}, kGuideTick)
                                   .force_P;
      EXPECT_LE(glm::length(force), 1.5 + 1e-12);
      EXPECT_EQ(force.z, 0);
    }
  }
}

TEST(Guide, WhatIsNoNumberGivesZeroAndARampInAfterwards) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const GuidanceMode mode : kAllModes) {
    const GuidancePlan plan = GuidePlan(mode, {LongLine()});
    for (const double bad : {nan, infinity, -infinity}) {
      GuidanceState state = Arrived(plan);
      EXPECT_EQ(Guide(plan, state, {bad, 0, 0}, {0, 0, 0}, kGuideTick).force_P, glm::dvec3(0));
      EXPECT_EQ(Guide(plan, state, {0, 0, bad}, {0, 0, 0}, kGuideTick).force_P, glm::dvec3(0));
      EXPECT_EQ(Guide(plan, state, {0, 0, 0}, {0, bad, 0}, kGuideTick).force_P, glm::dvec3(0));
      EXPECT_EQ(Guide(plan, state, {0, 0, 0}, {0, 0, 0}, bad).force_P, glm::dvec3(0));
      EXPECT_LT(glm::length(HoldTip(plan, state, {0, 0.001}, 1).force_P), 1e-3);
      const GuidanceResult later = HoldTip(plan, state, {0.0, 0.0005}, 1000);
      EXPECT_TRUE(std::isfinite(later.force_P.x) && std::isfinite(later.force_P.y));
    }
  }
}

TEST(Guide, WithoutAModeOrAPathPushesNothing) {
  GuidanceState state;
  GuidancePlan plan = GuidePlan(GuidanceMode::kOff, {LongLine()});
  EXPECT_EQ(HoldTip(plan, state, {0, 0.01}, 500).force_P, glm::dvec3(0));
  plan = GuidePlan(GuidanceMode::kRail, {});
  EXPECT_EQ(HoldTip(plan, state, {0, 0.01}, 500).force_P, glm::dvec3(0));
  plan.path = nullptr;
  EXPECT_EQ(HoldTip(plan, state, {0, 0.01}, 500).force_P, glm::dvec3(0));
}

TEST(Amplify, PushesAwayWithinTheCapAndNotOutsideTheLettersBox) {
  const IntendedStroke bar = GuideStroke({Line{{0, 0}, {0.02, 0}}});
  const IntendedStroke stem = GuideStroke({Line{{0, 0}, {0, 0.01}}});
  GuidancePlan plan = GuidePlan(GuidanceMode::kAmplify, {bar, stem});
  plan.gains.stiffness = 100;
  plan.gains.cap = 0.3;
  GuidanceState state = Arrived(plan);
  MoveTip(plan, state, {0, 0}, {0.01, 0}, 500);
  EXPECT_NEAR(HoldTip(plan, state, {0.01, 0.002}, 100).force_P.y, 100 * 0.002, 1e-9);
  EXPECT_NEAR(HoldTip(plan, state, {0.01, 0.004}, 50).force_P.y, 0.3, 1e-9);
  // the box goes from one width below the bar to one above the stem's end
  EXPECT_EQ(HoldTip(plan, state, {0.01, -kGuideWidth}, 50).force_P, glm::dvec3(0));
  EXPECT_EQ(HoldTip(plan, state, {0.01, -0.004}, 50).force_P, glm::dvec3(0));
}

TEST(Corridor, VibratesOutsideWithNothingLeftInTheMean) {
  GuidancePlan plan = GuidePlan(GuidanceMode::kCorridor, {LongLine()});
  plan.gains.stiffness = 0;
  plan.gains.dead_zone_widths = 0.5;
  plan.gains.cue_amplitude = 0.4;
  GuidanceState state = Arrived(plan);
  MoveTip(plan, state, {0, 0}, {0.02, 0}, 500);
  EXPECT_EQ(HoldTip(plan, state, {0.02, 0.0006}, 10).force_P, glm::dvec3(0));
  HoldTip(plan, state, {0.02, 0.002}, 50);
  glm::dvec3 sum(0);
  double greatest = 0;
  for (int i = 0; i < 10; ++i) {  // one period of 100 Hz
    const glm::dvec3 force = HoldTip(plan, state, {0.02, 0.002}, 1).force_P;
    sum += force;
    greatest = std::max(greatest, glm::length(force));
  }
  EXPECT_LT(glm::length(sum), 1e-12);
  EXPECT_GT(greatest, 0.35);
  EXPECT_LE(greatest, 0.4);
}

}  // namespace
}  // namespace moontrace

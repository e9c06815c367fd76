// The moving bead: its time, its patience, and recorded ways.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "lessons/guide/guidance.h"
#include "tests/lessons/guidance_fixture.h"

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;

GuidancePlan BeadPlan(const std::vector<IntendedStroke>& strokes) {
  GuidancePlan plan = GuidePlan(GuidanceMode::kBead, strokes);
  plan.gains.damping = 1;
  plan.gains.bead_speed = 0.02;
  plan.gains.leash_widths = 4;
  return plan;
}

/// 30 mm with a bend.
IntendedStroke Bend() {
  return GuideStroke({Line{{0, 0}, {0.01, 0}}, Arc{{0.01, 0.01}, 0.01, -kPi / 2, 1},
                      Line{{0.01 + 0.01 * std::sin(1.0), 0.01 - 0.01 * std::cos(1.0)},
                           {0.01 + 0.01 * std::sin(1.0) + 0.01 * std::cos(1.0),
                            0.01 - 0.01 * std::cos(1.0) + 0.01 * std::sin(1.0)}}});
}

TEST(Bead, TakesLengthOverSpeedWithAHandThatFollows) {
  const GuidancePlan plan = BeadPlan({Bend()});
  GuidanceState state;
  PassiveHand hand;
  int ticks = 0;
  double worst = 0;
  while (state.bead < 0.03 - 1e-12 && ticks < 10000) {
    const GuidanceResult result = Guide(plan, state, {hand.p, 0}, {hand.v, 0}, kGuideTick);
    hand.Push(result.force_P);
    worst = std::max(worst, std::abs(result.error));
    ++ticks;
  }
  EXPECT_NEAR(ticks * kGuideTick, 0.03 / 0.02, kGuideTick + 1e-9);
  EXPECT_LT(worst, kGuideWidth / 2);  // and the hand has stayed in the groove's width
  for (int i = 0; i < 1000 && !state.done; ++i) {
    hand.Push(Guide(plan, state, {hand.p, 0}, {hand.v, 0}, kGuideTick).force_P);
  }
  EXPECT_TRUE(state.done);
}

TEST(Bead, WaitsForAHandThatIsHeldAndThenGoesOn) {
  const GuidancePlan plan = BeadPlan({Bend()});
  GuidanceState state;
  const GuidanceResult result = HoldTip(plan, state, {0, 0}, 3000);
  EXPECT_NEAR(state.bead, plan.gains.leash_widths * kGuideWidth, 0.02 * kGuideTick + 1e-12);
  EXPECT_LE(glm::length(result.force_P), plan.gains.cap);
  EXPECT_GT(result.force_P.x, 0.5);
  PassiveHand hand;
  for (int i = 0; i < 3000 && !state.done; ++i) {
    hand.Push(Guide(plan, state, {hand.p, 0}, {hand.v, 0}, kGuideTick).force_P);
  }
  EXPECT_TRUE(state.done);
}

TEST(Bead, NeverHoldsBackAHandThatIsAhead) {
  const GuidancePlan plan = BeadPlan({GuideStroke({Line{{0, 0}, {0.04, 0}}})});
  GuidanceState state;
  HoldTip(plan, state, {0, 0}, 10);
  const GuidanceResult result = MoveTip(plan, state, {0, 0}, {0.03, 0}, 300);  // 100 mm/s
  EXPECT_GT(result.force_P.x, -1e-9);
  EXPECT_GE(state.bead, 0.03 - 1e-9);
}

TEST(Bead, DrawsAHandFromStrokeToStrokeToTheEnd) {
  const GuidancePlan plan = BeadPlan(
      {GuideStroke({Line{{0, 0}, {0.01, 0}}}), GuideStroke({Line{{0.01, 0.01}, {0, 0.01}}})});
  GuidanceState state;
  PassiveHand hand;
  int ticks = 0;
  while (!state.done && ticks < 10000) {
    hand.Push(Guide(plan, state, {hand.p, 0}, {hand.v, 0}, kGuideTick).force_P);
    ++ticks;
  }
  // two strokes and the way between, 10 mm each, and a rest of 0.15 s at either end; each of the
  // three may be a tick longer
  EXPECT_NEAR(ticks * kGuideTick, 3 * 0.01 / 0.02 + 2 * 0.15, 0.006);
}

TEST(RecordedBead, KeepsTheTutorsTimesWithinATick) {
  // 10 mm in 0.5 s, a rest of 1 s, 10 mm in 2 s, at 100 Hz
  std::vector<double> times;
  std::vector<glm::dvec3> tips;
  for (int i = 0; i <= 350; ++i) {
    const double t = 0.01 * i;
    const double x = t < 0.5 ? 0.02 * t : t < 1.5 ? 0.01 : 0.01 + 0.005 * (t - 1.5);
    times.push_back(7 + t);
    tips.push_back({x, 0.001 * std::sin(100 * x), 0});
  }
  GuidancePlan plan = BeadPlan({});
  plan.path = MakeRecordedPath(times, tips, kGuideWidth);
  GuidanceState state;
  PassiveHand hand;
  int ticks = 0;
  while (state.time < 3.5 - 1e-12 && ticks < 10000) {
    const GuidanceResult result = Guide(plan, state, {hand.p, 0}, {hand.v, 0}, kGuideTick);
    hand.Push(result.force_P);
    ++ticks;
    // the bead is where the tutor was at that time: between samples 10 ms apart on a gentle wave
    const double t = ticks * kGuideTick;
    const double x = t < 0.5 ? 0.02 * t : t < 1.5 ? 0.01 : 0.01 + 0.005 * (t - 1.5);
    ASSERT_LT(glm::distance(result.target_P, {x, 0.001 * std::sin(100 * x)}), 1e-4);
  }
  EXPECT_NEAR(ticks * kGuideTick, 3.5, kGuideTick + 1e-9);
}

TEST(RecordedBead, WaitsToo) {
  GuidancePlan plan = BeadPlan({});
  plan.path = MakeRecordedPath({0, 1}, {{0, 0, 0}, {0.05, 0, 0}}, kGuideWidth);
  GuidanceState state;
  const GuidanceResult result = HoldTip(plan, state, {0, 0}, 3000);
  EXPECT_NEAR(result.target_P.x, 4 * kGuideWidth, 0.05 * kGuideTick + 1e-12);
  EXPECT_LE(glm::length(result.force_P), plan.gains.cap);
}

}  // namespace
}  // namespace moontrace

#include "lessons/guide/fading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace moontrace {
namespace {

FadeRule Rule(FadeRule::Kind kind) {
  FadeRule rule;
  rule.kind = kind;
  return rule;
}

/// Emken, Benitez, Reinkensmeyer 2007: a constant demand is met by robot and human, each of which
/// learns from the error that is left. No dead zone.
struct Shared {
  double assistance = 0, error = 0;
};
Shared Settled(double forgetting) {
  const double demand = 10, human_gain = 0.1, human_forgetting = 0.98;
  FadeRule rule = Rule(FadeRule::Kind::kAsNeeded);
  rule.forgetting = forgetting;
  rule.gain = 0.5;
  rule.dead_zone = 0;
  FadeState robot;
  double human = 0, error = demand;
  for (int trial = 0; trial < 5000; ++trial) {
    error = demand - robot.help - human;
    robot = FadeHelp(rule, robot, error, false);
    human = human_forgetting * human + human_gain * error;
  }
  return {robot.help, error};
}

TEST(FadeHelp, AsNeededSettlesAtTheClosedForm) {
  // training-and-ux.md 1.7, item 3: e = d / (1 + g_R/(1-f_R) + g_H/(1-f_H)), help = g_R e / (1-f_R)
  const Shared forgets = Settled(0.8);
  EXPECT_NEAR(forgets.assistance, 2.941, 5e-4);
  EXPECT_NEAR(forgets.error, 1.176, 5e-4);
  const Shared quickly = Settled(0.5);
  EXPECT_NEAR(quickly.assistance, 1.429, 5e-4);
  EXPECT_NEAR(quickly.error, 1.429, 5e-4);
}

TEST(FadeHelp, ARobotThatForgetsNothingDoesItAll) {
  EXPECT_NEAR(Settled(1).assistance, 9.99, 0.011);
}

TEST(FadeHelp, AsNeededIsExactlyZeroInTheEndWithinTheDeadZone) {
  const FadeRule rule = Rule(FadeRule::Kind::kAsNeeded);
  FadeState state{10, 0};
  int trials = 0;
  while (state.help > 0 && trials < 100) {
    const double before = state.help;
    state = FadeHelp(rule, state, rule.dead_zone, true);
    EXPECT_LT(state.help, before);
    ++trials;
  }
  EXPECT_EQ(state.help, 0);
  EXPECT_EQ(trials, 24);  // 10 x 0.8^n first falls below 0.05 at n = 24
}

TEST(FadeHelp, AsNeededAsksOnlyForTheErrorBeyondTheDeadZone) {
  FadeRule rule = Rule(FadeRule::Kind::kAsNeeded);
  rule.gain = 4;
  rule.dead_zone = 0.25;
  EXPECT_NEAR(FadeHelp(rule, {0, 0}, 0.75, false).help, 2, 1e-12);
  EXPECT_EQ(FadeHelp(rule, {0, 0}, 0.2, false).help, 0);
}

TEST(FadeHelp, LinearTakesItsStepWhateverTheTrialWas) {
  FadeRule rule = Rule(FadeRule::Kind::kLinear);
  rule.linear_step = 0.75;
  FadeState state{2, 0};
  state = FadeHelp(rule, state, 3, false);
  EXPECT_EQ(state.help, 1.25);
  state = FadeHelp(rule, state, 0, true);
  EXPECT_EQ(state.help, 0.5);
  EXPECT_EQ(FadeHelp(rule, state, 0, true).help, 0);
}

TEST(FadeHelp, TheGateOpensAfterGoodTrialsInARowAndClosesAfterABadOne) {
  FadeRule rule = Rule(FadeRule::Kind::kGate);
  rule.gate_good = 2;
  FadeState state{5, 0};
  state = FadeHelp(rule, state, 0.2, true);
  EXPECT_EQ(state.help, 5);
  state = FadeHelp(rule, state, 0.2, true);
  EXPECT_EQ(state.help, 4);
  state = FadeHelp(rule, state, 0.2, true);
  state = FadeHelp(rule, state, 2, false);  // the run is broken
  EXPECT_EQ(state.help, 5);
  state = FadeHelp(rule, state, 0.2, true);
  EXPECT_EQ(state.help, 5);
}

TEST(FadeHelp, ManualLeavesHelpToPeople) {
  EXPECT_EQ(FadeHelp(Rule(FadeRule::Kind::kManual), {7, 0}, 9, false).help, 7);
}

TEST(FadeHelp, HelpStaysBetweenNoneAndTen) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto kind : {FadeRule::Kind::kManual, FadeRule::Kind::kLinear, FadeRule::Kind::kGate,
                          FadeRule::Kind::kAsNeeded}) {
    for (const double error : {-1.0, 0.0, 1e300, std::numeric_limits<double>::infinity(), nan}) {
      for (const double help : {-3.0, 0.0, 10.0, 40.0, nan}) {
        for (const bool good : {true, false}) {
          const double next = FadeHelp(Rule(kind), {help, 1}, error, good).help;
          EXPECT_GE(next, 0);
          EXPECT_LE(next, 10);
        }
      }
    }
  }
}

}  // namespace
}  // namespace moontrace

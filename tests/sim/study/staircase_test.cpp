#include "sim/study/staircase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace moontrace {
namespace {

/// Share right of an observer with threshold 10 and spread 1: a cumulative Gaussian.
double ChanceAt(double level) { return 0.5 * std::erfc((10 - level) / std::sqrt(2.0)); }

StaircaseRule Linear(int down, double step) {
  StaircaseRule rule;
  rule.down = down;
  rule.start = 12;
  rule.least = -1e300;
  rule.geometric = false;
  rule.steps = {step};
  return rule;
}

TEST(Staircase, SettlesWhereLevittSays) {
  // Near the target the level is a random walk that is drawn back; by its rate and its step the
  // mean of N levels has a standard error of about 1.25 / sqrt(N) spreads for one down, 0.5 /
  // sqrt(N) in the chance, and no more than twice that for three: 0.003. Asymmetry of the walk
  // about the target adds some tenths of the step's share of the spread: 0.003. Four and one.
  constexpr int kTrials = 100000;
  const double expected[] = {0.5, 0.7071, 0.7937};
  for (int down = 1; down <= 3; ++down) {
    StaircaseRule rule = Linear(down, 0.02);
    rule.stop_trials = kTrials;
    rule.stop_reversals = kTrials;
    Staircase staircase(rule);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> chance(0, 1);
    double sum = 0;
    int counted = 0;
    while (!staircase.done()) {
      if (staircase.trials() >= 2000) {
        sum += staircase.level();
        ++counted;
      }
      staircase.Add(chance(random) < ChanceAt(staircase.level()));
    }
    EXPECT_EQ(staircase.trials(), kTrials);
    EXPECT_NEAR(ChanceAt(sum / counted), expected[down - 1], 0.015) << down;
  }
}

TEST(Staircase, ThresholdsOfShortRunsAreRightOnAverage) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> chance(0, 1);
  StaircaseRule rule = Linear(2, 0.3);
  rule.steps = {1, 0.5, 0.3};
  double sum = 0;
  constexpr int kRuns = 400;
  for (int run = 0; run < kRuns; ++run) {
    Staircase staircase(rule);
    while (!staircase.done()) staircase.Add(chance(random) < ChanceAt(staircase.level()));
    ASSERT_TRUE(staircase.Threshold().has_value());
    sum += *staircase.Threshold();
  }
  // A run's eight reversals scatter by less than a spread: 4 / sqrt(400). Steps that are not small
  // shift the mean by a fraction of one.
  EXPECT_NEAR(sum / kRuns, 10.545, 0.2);  // where the Gaussian is 0.7071
}

TEST(Staircase, FollowsItsStepListFromReversalToReversal) {
  StaircaseRule rule = Linear(1, 0);
  rule.start = 100;
  rule.steps = {16, 4, 1};
  rule.discard = 1;
  Staircase staircase(rule);
  std::vector<double> levels;
  for (const bool right : {true, true, false, false, true, true, false, true}) {
    staircase.Add(right);
    levels.push_back(staircase.level());
  }
  EXPECT_EQ(levels, (std::vector<double>{84, 68, 72, 76, 75, 74, 75, 74}));
  EXPECT_EQ(staircase.reversals(), (std::vector<double>{68, 76, 74, 75}));
  EXPECT_DOUBLE_EQ(staircase.Threshold().value(), 74.5);  // the last even number after the first
}

TEST(Staircase, ThreeDownNeedsThreeInARow) {
  StaircaseRule rule = Linear(3, 1);
  Staircase staircase(rule);
  for (const bool right : {true, true, false, true, true}) staircase.Add(right);
  EXPECT_DOUBLE_EQ(staircase.level(), 13);
  staircase.Add(true);
  EXPECT_DOUBLE_EQ(staircase.level(), 12);
}

TEST(Staircase, GeometricStepsAreFactorsAndSoIsTheMean) {
  StaircaseRule rule;
  rule.down = 1;
  rule.start = 0.012;
  rule.steps = {2};
  rule.discard = 0;
  Staircase staircase(rule);
  staircase.Add(true);
  EXPECT_DOUBLE_EQ(staircase.level(), 0.006);
  staircase.Add(false);
  EXPECT_DOUBLE_EQ(staircase.level(), 0.012);
  EXPECT_FALSE(staircase.Threshold().has_value());
  staircase.Add(true);
  EXPECT_NEAR(staircase.Threshold().value(), std::sqrt(0.006 * 0.012), 1e-15);
}

TEST(Staircase, StaysWithinItsBoundsAndStopsByTrials) {
  StaircaseRule rule = Linear(1, 5);
  rule.least = 3;
  rule.most = 14;
  rule.stop_trials = 10;
  Staircase always(rule), never(rule);
  while (!always.done()) always.Add(true);
  while (!never.done()) never.Add(false);
  EXPECT_EQ(always.level(), 3);
  EXPECT_EQ(never.level(), 14);
  EXPECT_EQ(always.trials(), 10);
  EXPECT_FALSE(always.Threshold().has_value());
  always.Add(false);
  EXPECT_EQ(always.trials(), 10);
}

TEST(Staircase, StopsByReversals) {
  StaircaseRule rule = Linear(1, 1);
  rule.stop_reversals = 3;
  Staircase staircase(rule);
  for (int i = 0; i < 10; ++i) staircase.Add(i % 2 == 0);
  EXPECT_TRUE(staircase.done());
  EXPECT_EQ(staircase.trials(), 4);
}

TEST(Staircase, RefusesRulesThatLeadNowhere) {
  std::vector<StaircaseRule> rules(7, Linear(1, 1));
  rules[0].down = 4;
  rules[1].steps = {};
  rules[2].steps = {1, 0};
  rules[3].least = 13;
  rules[4].geometric = true;  // a factor of 1
  rules[5].stop_trials = 0;
  rules[6].most = 11;
  for (const StaircaseRule& rule : rules) EXPECT_THROW(Staircase{rule}, std::invalid_argument);
}

TEST(NextStaircase, TakesThoseThatAreOpenByChanceAndTheSameForASeed) {
  StaircaseRule longer = Linear(1, 1), shorter = Linear(1, 1);
  longer.stop_trials = shorter.stop_trials = 100;
  longer.stop_reversals = shorter.stop_reversals = 1000;
  shorter.stop_trials = 20;
  const auto run = [&](std::uint64_t random) {
    std::vector<Staircase> stairs{Staircase(longer), Staircase(shorter)};
    std::vector<std::size_t> order;
    while (const auto next = NextStaircase(stairs, random)) {
      order.push_back(*next);
      stairs[*next].Add(true);
    }
    return order;
  };
  const std::vector<std::size_t> order = run(1);
  EXPECT_EQ(order.size(), 120u);
  EXPECT_EQ(order, run(1));
  EXPECT_NE(order, run(2));
  // Both among the first 20: the chance that one side is missing is 2^-19.
  EXPECT_NE(std::count(order.begin(), order.begin() + 20, 0u), 0);
  EXPECT_NE(std::count(order.begin(), order.begin() + 20, 1u), 0);
}

}  // namespace
}  // namespace moontrace

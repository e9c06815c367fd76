#include "sim/safety/still_tip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;
constexpr double kStill = 0.25;

DeviceLimits Limits(double friction = 0) {
  DeviceLimits limits;
  limits.still = kStill;
  limits.friction = friction;
  limits.workspace_D = {0.06, 0.06, 0.06};
  return limits;
}

/// A hand that means to press with `press` on a device of `step`, whose friction holds it as far as
/// it can: the tip moves only as far as the hand, a spring of 300 N/m, and the motors overcome it.
struct RestingHand {
  double press = 1;      ///< [N]
  double friction = 0;   ///< [N]
  double step = 117e-6;  ///< [m], 10 bits of a stick's 120 mm
  double x = 0;          ///< [m]

  double Report(double motors) {
    constexpr double kStiffness = 300;
    const double pull = press - motors - kStiffness * x;
    if (std::abs(pull) > friction) x += (pull - std::copysign(friction, pull)) / kStiffness;
    return step * std::round(x / step);
  }
};

/// Seconds until it is said to be stuck, and the least share on the way; at most 60 s.
struct Seen {
  double stuck_after = -1;
  double least_share = 1;
};
Seen Rest(RestingHand hand, double force, const DeviceLimits& limits) {
  StillTip tip(limits);
  Seen seen;
  for (int n = 1; n <= 60000 && seen.stuck_after < 0; ++n) {
    tip.Advance(kTick, true, {hand.Report(tip.share() * force), 0, 0}, force);
    seen.least_share = std::min(seen.least_share, tip.share());
    if (tip.stuck()) seen.stuck_after = n * kTick;
  }
  return seen;
}

TEST(StillTip, IsStuckOnceTheForceIsGoneAndItHasNotMoved) {
  StillTip tip(Limits());
  int n = 0;
  for (; n < 5000 && !tip.stuck(); ++n) tip.Advance(kTick, true, {0.01, 0, 0}, 1);
  EXPECT_NEAR(n * kTick, kStill + StillTip::kYieldTime, 0.01);
  EXPECT_EQ(tip.share(), 0);
  for (n = 0; n < 5000; ++n) tip.Advance(kTick, true, {0.01, 0, 0}, 1);
  EXPECT_TRUE(tip.stuck());
  tip.Advance(kTick, true, {0.011, 0, 0}, 1);
  EXPECT_FALSE(tip.stuck());
  EXPECT_EQ(tip.share(), 1);
}

// The page presses with 1 N and so does the hand: it rests. Taking s of it away moves the hand by
// s / 300 N/m, and half a step, 58 um, is reported as another place: 0.018 N. The share sinks by
// 0.001 a tick, and the first report that differs turns it.
TEST(StillTip, AHandAtRestOnCoarseStepsHardlyFeelsIt) {
  const Seen seen = Rest({}, 1, Limits());
  EXPECT_EQ(seen.stuck_after, -1);
  EXPECT_LT(seen.least_share, 1);  // it was asked
  EXPECT_GT(seen.least_share, 0.97);
}

// Friction of 0.5 N may hold the tip against a hand that pulls back by as much already, so that the
// motors have to give 1 N less before it moves, and half a step, 0.018 N: 0.18 N are left of 1.2.
TEST(StillTip, AHandAtRestOnMuchFrictionIsNoFault) {
  RestingHand hand;
  hand.press = 1.2;
  hand.friction = 0.5;
  const Seen seen = Rest(hand, 1.2, Limits(0.5));
  EXPECT_EQ(seen.stuck_after, -1);
  EXPECT_GT(seen.least_share, 0.14);
}

TEST(StillTip, AForceThatFrictionMayHoldIsNotJudged) {
  EXPECT_EQ(Rest({0, 0.5}, 0.99, Limits(0.5)).least_share, 1);
  EXPECT_EQ(Rest({0, 0}, 0.19, Limits()).least_share, 1);
}

TEST(StillTip, NorATipThatMayLieAgainstAStop) {
  StillTip tip(Limits());
  for (int n = 0; n < 5000; ++n) tip.Advance(kTick, true, {0.01, -0.0595, 0}, 1);
  EXPECT_EQ(tip.share(), 1);
}

TEST(StillTip, NorADeviceThatCannotStickNorOneThatIsSilent) {
  StillTip never((DeviceLimits()));
  StillTip silent(Limits());
  silent.Advance(kTick, true, {0, 0, 0}, 1);
  for (int n = 0; n < 5000; ++n) {
    never.Advance(kTick, true, {0, 0, 0}, 1);
    silent.Advance(kTick, false, {0, 0, 0}, 1);
  }
  EXPECT_EQ(never.share(), 1);
  EXPECT_EQ(silent.share(), 1);
}

TEST(StillTip, AnotherPlaceBringsTheForceBackSmoothly) {
  StillTip tip(Limits());
  for (int n = 0; n < 750; ++n) tip.Advance(kTick, true, {0.01, 0, 0}, 1);
  EXPECT_NEAR(tip.share(), 0.5, 0.01);
  double before = tip.share();
  for (int n = 1; n <= 60; ++n) {
    tip.Advance(kTick, true, {0.01 + 1e-4 * n, 0, 0}, 1);
    EXPECT_LE(tip.share() - before, kTick / StillTip::kReturnTime + 1e-12);
    before = tip.share();
  }
  EXPECT_EQ(tip.share(), 1);
}

}  // namespace
}  // namespace moontrace

#include "sim/safety/motor_heat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;
constexpr double kHold = 0.006;  // the longest a force stands: a tick and the watchdog's time
constexpr double kPeak = 5, kContinuous = 1, kTau = 10;

MotorHeat Motor() { return {kPeak, kContinuous, kTau, kHold}; }

/// Presses for `seconds` as hard as `wanted` and the ceiling let; returns the last force given.
double Press(MotorHeat& motor, double wanted, double seconds) {
  double given = 0;
  for (int n = 0; n < static_cast<int>(seconds / kTick + 0.5); ++n) {
    given = std::min(wanted, motor.Ceiling());
    motor.Advance(given, kTick);
  }
  return given;
}

TEST(MotorHeat, RisesAsTheClosedFormUnderAHeldForce) {
  MotorHeat motor = Motor();
  Press(motor, 2, 0.2);
  // h' = (4 - h) / tau from cold; per-tick updates are exact, so only rounding differs
  EXPECT_NEAR(motor.heat(), 4 * (1 - std::exp(-0.2 / kTau)), 1e-12);
  MotorHeat coarse = Motor();
  coarse.Advance(2, 0.2);
  EXPECT_NEAR(coarse.heat(), motor.heat(), 1e-12);
}

TEST(MotorHeat, IsLostWithTheTimeConstant) {
  MotorHeat motor = Motor();
  motor.Advance(2, 1);
  const double warm = motor.heat();
  motor.Advance(0, kTau);
  EXPECT_NEAR(motor.heat(), warm / std::exp(1.0), 1e-12);
}

TEST(MotorHeat, ContinuousForceForEverEndsAtTheLimit) {
  MotorHeat motor = Motor();
  EXPECT_EQ(Press(motor, kContinuous, 20 * kTau), kContinuous);
  EXPECT_NEAR(motor.heat(), 1, 3e-9);  // exp(-20) = 2e-9 is left
  EXPECT_LE(motor.heat(), 1);
}

// Twice the continuous force: from cold h = 4 (1 - exp(-t/tau)) until the ceiling, c^2 = 25 - 24 h,
// has come down to 4 N^2 at h = 7/8, t1 = tau ln(32/25). From there the force is the ceiling and
// h' = 25 (1 - h) / tau, so 1 - h = exp(-25 (t - t1) / tau) / 8: never above 1.
TEST(MotorHeat, TwiceTheContinuousForceFollowsTheClosedFormAndNeverPassesTheLimit) {
  MotorHeat motor = Motor();
  const double t1 = kTau * std::log(32.0 / 25.0);
  double greatest = 0, t = 0;
  for (int n = 0; n < 100000; ++n) {
    const double closed =
        t < t1 ? 4 * (1 - std::exp(-t / kTau)) : 1 - std::exp(-25 * (t - t1) / kTau) / 8;
    // the ceiling of a tick's beginning stands over it: late by a tick at most, in which h moves by
    // at most 4 dt / tau
    ASSERT_NEAR(motor.heat(), closed, 4 * kTick / kTau) << t;
    motor.Advance(std::min(2.0, motor.Ceiling()), kTick);
    greatest = std::max(greatest, motor.heat());
    t += kTick;
  }
  EXPECT_LE(greatest, 1);
  EXPECT_NEAR(motor.Ceiling(), kContinuous, 1e-6);
}

TEST(MotorHeat, PeakForEverNeverPassesTheLimitWhateverTheTimes) {
  for (const double tau : {0.001, 0.01, 0.1, 1.0, 30.0}) {
    for (const double ratio : {0.5, 1.0, 2.0, 20.0, 1000.0}) {
      MotorHeat motor(3, 3 / ratio, tau, kHold);
      double greatest = 0;
      for (int n = 0; n < 20000; ++n) {
        motor.Advance(motor.Ceiling(), kHold);  // even when every tick is as late as it can be
        greatest = std::max(greatest, motor.heat());
      }
      EXPECT_LE(greatest, 1 + 1e-12) << tau << ' ' << ratio;
      EXPECT_LE(motor.Ceiling(), 3 * (1 + 1e-12));
    }
  }
}

TEST(MotorHeat, LowersItsCeilingSmoothlyInTime) {
  MotorHeat motor = Motor();
  double before = motor.Ceiling(), greatest = 0;
  for (int n = 0; n < 60000; ++n) {
    motor.Advance(motor.Ceiling(), kTick);
    greatest = std::max(greatest, before - motor.Ceiling());
    before = motor.Ceiling();
  }
  // |dc/dt| = (f_p^2 - f_c^2) h' / (2 c); at the ceiling h' = 25 (1 - h) / tau and
  // c^2 = 1 + 24 (1 - h), so |dc/dt| = 12 h' / c is greatest when cold: 12 * 2.5 / 5 = 6 N/s.
  // A tick's force is held while c falls: 12 h' dt / (2 c^2) = 6e-4 more in the first tick
  EXPECT_LE(greatest, 6.0 * kTick * 1.001);
  EXPECT_GT(greatest, 5.9 * kTick);
}

TEST(MotorHeat, DoesNotHeatWithoutAContinuousForceOfItsOwn) {
  MotorHeat motor(3, std::numeric_limits<double>::infinity(), 0, kHold);
  motor.Advance(3, 1000);
  EXPECT_EQ(motor.heat(), 0);
  EXPECT_EQ(motor.Ceiling(), 3);
}

TEST(MotorHeat, TakesTheContinuousForceAsCeilingWhereTheTimeConstantIsUnknown) {
  EXPECT_EQ(MotorHeat(3, 1, 0, kHold).Ceiling(), 1);
}

TEST(MotorHeat, GivesNothingForNumbersThatAreNone) {
  const double nan = std::nan("");
  EXPECT_EQ(MotorHeat(nan, 1, 1, kHold).Ceiling(), 0);
  EXPECT_EQ(MotorHeat(3, nan, 1, kHold).Ceiling(), 0);
  EXPECT_EQ(MotorHeat(3, 0, 1, kHold).Ceiling(), 0);
  EXPECT_EQ(MotorHeat().Ceiling(), 0);
}

TEST(MotorHeat, RestsBelowTheContinuousForceAfterAStallThatOverheatedIt) {
  MotorHeat motor = Motor();
  motor.Advance(5, 1);  // nobody looked for a second
  EXPECT_GT(motor.heat(), 1);
  EXPECT_EQ(motor.Ceiling(), 0);
  Press(motor, 5, 30);
  EXPECT_NEAR(motor.heat(), 1, 1e-6);
  EXPECT_NEAR(motor.Ceiling(), kContinuous, 1e-5);
}

}  // namespace
}  // namespace moontrace

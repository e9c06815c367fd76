#include "sim/safety/safety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool Has(const SafetyResult& result, SafetyEvent event) {
  return (result.events >> static_cast<unsigned>(event) & 1U) != 0;
}

DeviceLimits Limits() {
  DeviceLimits limits;
  limits.peak_force = 5;
  return limits;
}

/// A safety stage with the tick's clock and a tip that lies still, ramped in.
class Stage {
 public:
  explicit Stage(const DeviceLimits& limits = Limits(), double tick = kTick)
      : tick_(tick), safety_(limits, tick) {
    for (int i = 0; i < static_cast<int>(0.31 / tick); ++i) Give({0, 0, 0});
  }
  SafetyInput Next(glm::dvec3 force) {
    SafetyInput input;
    input.force = force;
    input.device.p_D = p;
    input.time = time_ += tick_;
    return input;
  }
  SafetyResult Advance(const SafetyInput& input) { return safety_.Advance(input); }
  SafetyResult Give(glm::dvec3 force) { return Advance(Next(force)); }
  std::uint64_t Count(SafetyEvent event) const {
    return safety_.counts()[static_cast<std::size_t>(event)];
  }
  /// Asks for `force` until it is given; the ticks that took, at most 1000.
  int TicksUntil(glm::dvec3 force) {
    int ticks = 0;
    while (ticks < 1000 && glm::distance(Give(force).force, force) > 1e-9) ++ticks;
    return ticks;
  }

  glm::dvec3 p{0, 0, 0};

 private:
  double tick_;
  double time_ = 0;
  Safety safety_;
};

constexpr glm::dvec3 kPress{0, 0, 1};
constexpr glm::dvec3 kZero{0, 0, 0};

TEST(Safety, LetsAPlainForceThrough) {
  Stage stage;
  EXPECT_EQ(stage.Give({0.3, -0.4, 1}).force, glm::dvec3(0.3, -0.4, 1));
  EXPECT_EQ(stage.Give({0.3, -0.4, 1}).events, 0U);
}

TEST(Safety, RampsInAsTheClosedFormAtTheStart) {
  Safety safety(Limits(), kTick, 0.2);
  SafetyInput input;
  input.force = {0, 0, 2};
  for (int n = 0; n <= 200; ++n) {
    input.time = n * kTick;
    const double u = n / 200.0;
    ASSERT_NEAR(safety.Advance(input).force.z, 2 * u * u * (3 - 2 * u), 1e-9) << n;
  }
}

TEST(Safety, RampsInWithin300MillisecondsWhateverIsAsked) {
  Safety safety(Limits(), kTick, 99);
  SafetyInput input;
  input.force = {0, 0, 2};
  for (int n = 0; n <= 300; ++n) {
    input.time = n * kTick;
    safety.Advance(input);
  }
  input.time = 0.301;
  EXPECT_EQ(safety.Advance(input).force.z, 2);
}

TEST(Safety, GivesNothingBeforeTheFirstReport) {
  Safety safety(Limits(), kTick);
  SafetyInput input;
  input.force = kPress;
  input.status = DeviceStatus::kNoNewData;
  for (int n = 0; n < 1000; ++n) {
    input.time = n * kTick;
    ASSERT_EQ(safety.Advance(input).force, kZero);
  }
}

TEST(Safety, ZeroesInTheSameTickWhatIsNoNumberAndRampsInAfter) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int place = 0; place < 4; ++place) {
      Stage stage;
      ASSERT_EQ(stage.Give(kPress).force, kPress);
      SafetyInput input = stage.Next(kPress);
      if (place == 0) input.force.x = bad;
      if (place == 1) input.device.p_D.y = bad;
      if (place == 2) input.time = bad;
      if (place == 3) {
        input.device.velocity_known = true;
        input.device.v_D.z = bad;
      }
      const SafetyResult result = stage.Advance(input);
      EXPECT_EQ(result.force, kZero) << place;
      EXPECT_TRUE(Has(result, SafetyEvent::kNotANumber)) << place;
      const double first = stage.Give(kPress).force.z;
      EXPECT_LT(first, 0.001) << place;
      EXPECT_NEAR(stage.TicksUntil(kPress), 250, 2) << place;
    }
  }
}

TEST(Safety, ZeroesAJumpOf20MillimetresInTheSameTick) {
  Stage stage;
  stage.Give(kPress);
  stage.p.x = 0.02;
  const SafetyResult jump = stage.Give(kPress);
  EXPECT_EQ(jump.force, kZero);
  EXPECT_TRUE(Has(jump, SafetyEvent::kJump));
  EXPECT_FALSE(Has(stage.Give(kPress), SafetyEvent::kJump));
  EXPECT_GT(stage.TicksUntil(kPress), 200);
  EXPECT_EQ(stage.Count(SafetyEvent::kJump), 1U);
}

TEST(Safety, SeesAJumpAfterAGapInReportsToo) {
  Stage stage;
  for (int i = 0; i < 100; ++i) {
    SafetyInput input = stage.Next(kPress);
    input.status = DeviceStatus::kNoNewData;
    stage.Advance(input);
  }
  stage.p.x = 0.02;
  EXPECT_TRUE(Has(stage.Give(kPress), SafetyEvent::kJump));
}

TEST(Safety, TakesAFastHandForAHand) {
  Stage stage;
  for (int i = 0; i < 50; ++i) {
    stage.p.x += 0.0049;  // 4.9 m/s
    ASSERT_EQ(stage.Give({0, 0, 1}).events, 0U);
  }
}

TEST(Safety, ZeroesAVelocityThatNoHandHas) {
  Stage stage;
  SafetyInput input = stage.Next(kPress);
  input.device.velocity_known = true;
  input.device.v_D = {5.1, 0, 0};
  EXPECT_TRUE(Has(stage.Advance(input), SafetyEvent::kJump));
}

TEST(Safety, ZeroesWhileTheDeviceIsLostOrNotReadyAndTakesItBackElsewhere) {
  for (const auto status : {DeviceStatus::kLost, DeviceStatus::kNotReady}) {
    Stage stage;
    stage.Give(kPress);
    for (int i = 0; i < 300; ++i) {
      SafetyInput input = stage.Next(kPress);
      input.status = status;
      ASSERT_EQ(stage.Advance(input).force, kZero);
    }
    stage.p = {0.05, 0, 0};
    const SafetyResult back = stage.Give(kPress);
    EXPECT_EQ(back.events, 0U);
    EXPECT_EQ(back.force, kZero);
    EXPECT_GT(stage.TicksUntil(kPress), 200);
    EXPECT_EQ(stage.Count(SafetyEvent::kDeviceLost) + stage.Count(SafetyEvent::kNotReady), 1U);
  }
}

TEST(Safety, LetsGoAfterTheSilenceOfTheProfileAndComesBackWithAReport) {
  DeviceLimits limits = Limits();
  limits.silence = 0.05;
  Stage stage(limits);
  stage.Give(kPress);
  int given = 0;
  for (int i = 0; i < 100; ++i) {
    SafetyInput input = stage.Next(kPress);
    input.status = DeviceStatus::kNoNewData;
    if (stage.Advance(input).force == kPress) ++given;
  }
  EXPECT_NEAR(given, 50, 1);  // rounding of the clock decides about the last tick
  EXPECT_EQ(stage.Count(SafetyEvent::kSilence), 1U);
  EXPECT_EQ(stage.Give(kPress).events, 0U);
  EXPECT_GT(stage.TicksUntil(kPress), 200);
}

TEST(Safety, BearsSilenceWhereNoForceIsFelt) {
  Stage stage;
  for (int i = 0; i < 2000; ++i) {
    SafetyInput input = stage.Next({0, 0, 0.15});
    input.status = DeviceStatus::kNoNewData;
    ASSERT_EQ(stage.Advance(input).force.z, 0.15);
  }
}

TEST(Safety, ZeroesOnAPhysicsFault) {
  Stage stage;
  stage.Give(kPress);
  SafetyInput input = stage.Next(kPress);
  input.physics_fault = true;
  const SafetyResult result = stage.Advance(input);
  EXPECT_EQ(result.force, kZero);
  EXPECT_TRUE(Has(result, SafetyEvent::kPhysicsFault));
}

TEST(Safety, StopHoldsZeroUntilSomeoneAgrees) {
  Stage stage;
  stage.Give(kPress);
  SafetyInput input = stage.Next(kPress);
  input.stop = true;
  EXPECT_EQ(stage.Advance(input).force, kZero);
  for (int i = 0; i < 2000; ++i) {
    const SafetyResult result = stage.Give(kPress);
    ASSERT_EQ(result.force, kZero);
    ASSERT_TRUE(result.stopped);
  }
  input = stage.Next(kPress);
  input.stop = input.go_on = true;  // agreeing while stop is still asked for
  EXPECT_TRUE(stage.Advance(input).stopped);
  input = stage.Next(kPress);
  input.go_on = true;
  EXPECT_FALSE(stage.Advance(input).stopped);
  EXPECT_GT(stage.TicksUntil(kPress), 200);
  EXPECT_EQ(stage.Count(SafetyEvent::kStopped), 1U);
}

TEST(Safety, HoldToFeelGivesForceOnlyWhileHeld) {
  Stage stage;
  stage.Give(kPress);
  SafetyInput input = stage.Next(kPress);
  input.hold = true;
  const SafetyResult result = stage.Advance(input);
  EXPECT_EQ(result.force, kZero);
  EXPECT_EQ(result.events, 0U);
  EXPECT_NEAR(stage.TicksUntil(kPress), 250, 2);
}

TEST(Safety, RampGoesToZeroAtOnceAndTakesAnotherPlaceForNoJump) {
  Stage stage;
  stage.Give(kPress);
  stage.p.x = 0.1;
  SafetyInput input = stage.Next(kPress);
  input.ramp = true;
  const SafetyResult result = stage.Advance(input);
  EXPECT_EQ(result.force, kZero);
  EXPECT_EQ(result.events, 0U);
  EXPECT_NEAR(stage.TicksUntil(kPress), 250, 2);
}

TEST(Safety, RampsInAfterTheWatchdogLetGo) {
  Stage stage;
  stage.Give(kPress);
  for (int i = 0; i < 4; ++i) stage.Next(kPress);
  EXPECT_EQ(stage.Give(kPress).force, kPress);  // 5 ms late or less: the newest position counts
  for (int i = 0; i < 6; ++i) stage.Next(kPress);
  const SafetyResult late = stage.Give(kPress);
  EXPECT_EQ(late.force, kZero);
  EXPECT_TRUE(Has(late, SafetyEvent::kLateLoop));
}

TEST(Safety, CapsEachAxisAtThePeakForce) {
  Stage stage;
  glm::dvec3 force{0, 0, 0};
  for (int i = 0; i < 10; ++i) force = stage.Give({100, -7, 1}).force;
  EXPECT_EQ(force, glm::dvec3(5, -5, 1));
  EXPECT_EQ(stage.Count(SafetyEvent::kForceCap), 1U);
}

TEST(Safety, GivesNothingOnAxesThatTheDeviceDoesNotPush) {
  DeviceLimits limits = Limits();
  limits.pushes = {true, true, false};
  Stage stage(limits);
  const SafetyResult result = stage.Give({1, 1, 3});
  EXPECT_EQ(result.force, glm::dvec3(1, 1, 0));
  EXPECT_EQ(result.ceiling.z, 0);
}

TEST(Safety, SlowsRisesToTheRateAndNeverAFall) {
  Stage stage;  // 3 N/ms
  EXPECT_NEAR(stage.Give({0, 0, 4.5}).force.z, 3, 1e-12);
  EXPECT_NEAR(stage.Give({0, 0, 4.5}).force.z, 4.5, 1e-12);
  EXPECT_EQ(stage.Count(SafetyEvent::kRateCap), 1U);
  EXPECT_EQ(stage.Give({0, 0, 0.1}).force.z, 0.1);
  stage.Give({0, 0, 3.0});
  stage.Give({0, 0, 4.5});
  // a change of sign is a fall to zero, at once, and a rise from there
  EXPECT_NEAR(stage.Give({0, 0, -4.5}).force.z, -3, 1e-12);
}

TEST(Safety, RateIsNeverBelow3NewtonsAMillisecond) {
  DeviceLimits limits = Limits();
  for (const double rate : {0.0, 10.0, kNan, -kInfinity}) {
    limits.force_rate = rate;
    Stage stage(limits);
    EXPECT_NEAR(stage.Give({0, 0, 4.5}).force.z, 3, 1e-12);
  }
  limits.force_rate = 4000;
  Stage stage(limits);
  EXPECT_NEAR(stage.Give({0, 0, 4.5}).force.z, 4, 1e-12);
}

TEST(Safety, CapsThePowerGivenToTheHandAndNotThatTakenFromIt) {
  DeviceLimits limits = Limits();
  limits.peak_power = 0.5;
  for (const bool known : {true, false}) {
    Stage stage(limits);
    auto move = [&](double speed) {
      stage.p.x += speed * kTick;
      SafetyInput input = stage.Next({2, 0, 1});
      input.device.velocity_known = known;
      input.device.v_D = {speed, 0, 0};
      return stage.Advance(input);
    };
    const SafetyResult pushing = move(1);  // 2 N at 1 m/s: four times the cap
    EXPECT_NEAR(pushing.force.x, 0.5, 1e-9) << known;
    EXPECT_NEAR(pushing.force.z, 0.25, 1e-9) << known;
    EXPECT_TRUE(Has(pushing, SafetyEvent::kPowerCap)) << known;
    EXPECT_NEAR(move(-1).force.x, 2, 1e-9) << known;
  }
}

TEST(Safety, RestsTheMotorsUnderTwiceTheContinuousForceAndNeverPassesTheLimit) {
  DeviceLimits limits = Limits();
  limits.continuous_force = 1;
  limits.heat_time = 1;
  Stage stage(limits);
  double greatest = 0, last = 0;
  int began = -1;
  for (int n = 0; n < 20000; ++n) {
    const SafetyResult result = stage.Give({0, 0, 2});
    greatest = std::max(greatest, result.heat.z);
    if (began < 0 && Has(result, SafetyEvent::kResting)) began = n;
    last = result.force.z;
  }
  EXPECT_LE(greatest, 1);
  EXPECT_NEAR(last, 1, 1e-6);
  // 2 N are cut once c^2 = 25 - 24 h < 4, h > 7/8: after ln(32/25) s = 247 ms of 2 N (see
  // motor_heat_test.cpp); the stage has ramped in before, on zero force
  EXPECT_NEAR(began, 1000 * std::log(32.0 / 25.0), 2);
  EXPECT_EQ(stage.Count(SafetyEvent::kResting), 1U);
  // lifting: told until all have cooled to 0.3, tau ln(1 / 0.3) = 1.204 s
  int rested = 0;
  while (rested < 5000 && Has(stage.Give(kZero), SafetyEvent::kResting)) ++rested;
  EXPECT_NEAR(rested, 1204, 3);
  EXPECT_EQ(stage.Count(SafetyEvent::kResting), 1U);
}

TEST(Safety, CountsWhatComesAgainAfterAWhileAgain) {
  Stage stage;
  for (int i = 0; i < 3; ++i) {
    for (int n = 0; n < 5; ++n) stage.Give({kNan, 0, 0});
    for (int n = 0; n < 20; ++n) stage.Give(kZero);
    stage.Give({kNan, 0, 0});  // within 0.1 s: the same occurrence
    for (int n = 0; n < 150; ++n) stage.Give(kZero);
  }
  EXPECT_EQ(stage.Count(SafetyEvent::kNotANumber), 3U);
}

}  // namespace
}  // namespace moontrace

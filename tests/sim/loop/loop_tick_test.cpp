#include "sim/loop/loop_tick.h"

#include <cmath>
#include <glm/glm.hpp>

#include "tests/sim/loop_fixture.h"

namespace moontrace {
namespace {

constexpr glm::dvec3 kZero{0, 0, 0};
// Safety's ramp-in of 250 ms; the proxy, 20 times quicker, has settled by then.
constexpr int kSettled = 400;
// Of the settled force: proxy and coupling ring down as e^(-100 t), long over.
constexpr double kSmall = 1e-3;

/// Pressed until the reading of this number, then `then`.
ScriptedDevice::ReadFunction PressedUntil(int number, ScriptedDevice::ReadFunction then) {
  return [number, then](int n, DeviceState& state) {
    return n < number ? HoldAt(kPressed)(n, state) : then(n, state);
  };
}

ScriptedDevice::ReadFunction Says(DeviceStatus status) {
  return [status](int, DeviceState&) { return status; };
}

TEST_F(LoopTickTest, PressesBack) {
  Begin(HoldAt(kPressed));
  Run(1);
  EXPECT_EQ(log_.last(), kZero);  // ramps in
  Run(kSettled);
  EXPECT_NEAR(log_.last().z, kPressedForce, kSmall);
  const LoopSnapshot snapshot = Newest();
  EXPECT_EQ(snapshot.tip_P, kPressed);
  EXPECT_EQ(snapshot.force_D, log_.last());
  EXPECT_TRUE(snapshot.present);
}

TEST_F(LoopTickTest, ALostDeviceIsGivenZeroAtOnceAndHandedOver) {
  Begin(PressedUntil(kSettled, Says(DeviceStatus::kLost)));
  Run(kSettled);
  ASSERT_NEAR(log_.last().z, kPressedForce, kSmall);
  Run(1);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_TRUE(Told(LoopEventKind::kSafety, SafetyEvent::kDeviceLost));
  EXPECT_FALSE(log_.destroyed);  // not by the tick: destroying may block
  const std::unique_ptr<Device> detached(mail_.detached.exchange(nullptr));
  EXPECT_NE(detached, nullptr);
  Run(500);
  EXPECT_FALSE(Newest().present);
  EXPECT_EQ(Count(SafetyEvent::kDeviceLost), 1U);
}

TEST_F(LoopTickTest, WorkGoesOnWithADeviceOpenedAgain) {
  Begin(PressedUntil(kSettled, Says(DeviceStatus::kLost)));
  Run(kSettled + 10);
  const std::unique_ptr<Device> detached(mail_.detached.exchange(nullptr));
  DeviceLog log;
  // back elsewhere: neither a jump nor a wound-up coupling
  mail_.reopened = new ScriptedDevice(log, HoldAt({0.15, 0.12, -0.001}));
  Run(1);
  EXPECT_EQ(log.last(), kZero);
  EXPECT_TRUE(Told(LoopEventKind::kDeviceBack));
  Run(kSettled);
  EXPECT_NEAR(log.last().z, kPressedForce, kSmall);
  EXPECT_EQ(Count(SafetyEvent::kJump), 0U);
}

TEST_F(LoopTickTest, NoNumberJumpAndMotorsOffGiveZeroInTheSameTick) {
  const std::pair<ScriptedDevice::ReadFunction, SafetyEvent> faults[] = {
      {HoldAt({0.1, NAN, -0.001}), SafetyEvent::kNotANumber},
      {HoldAt({0.12, 0.1, -0.001}), SafetyEvent::kJump},  // 20 mm in a tick
      {Says(DeviceStatus::kNotReady), SafetyEvent::kNotReady}};
  for (const auto& fault : faults) {
    ticks_ = 0;
    log_.reads = 0;
    const auto& bad = fault.first;
    Begin([&bad](int n, DeviceState& state) {
      return n == kSettled ? bad(n, state) : HoldAt(kPressed)(n, state);
    });
    Run(kSettled);
    ASSERT_NEAR(log_.last().z, kPressedForce, kSmall);
    Run(1);
    EXPECT_EQ(log_.last(), kZero);
    EXPECT_EQ(Count(fault.second), 1U);
    EXPECT_EQ(Count(SafetyEvent::kPhysicsFault), 0U);
    Run(2 * kSettled);
    EXPECT_NEAR(log_.last().z, kPressedForce, kSmall);  // and then goes on
  }
}

TEST_F(LoopTickTest, ASilentDeviceIsLetGoAfterItsTime) {
  DeviceLimits limits;
  limits.silence = 0.1;
  Begin(PressedUntil(kSettled, Says(DeviceStatus::kNoNewData)), limits);
  Run(kSettled + 99);
  EXPECT_GT(log_.last().z, 0.2);
  Run(2);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_EQ(Count(SafetyEvent::kSilence), 1U);
}

// Reports go on and tell one place, whatever the force: it is taken back within `still` and the
// second that asks, and comes again once the tip moves.
TEST_F(LoopTickTest, APositionThatDoesNotAnswerToForceGetsNone) {
  DeviceLimits limits;
  limits.still = 0.25;
  const auto moves = [](int n) { return n < 1000 || n >= 4000; };
  Begin(
      [moves](int n, DeviceState& state) {
        return HoldAt(kPressed + glm::dvec3(moves(n) ? 1e-6 * (n % 1000) : 0, 0, 0))(n, state);
      },
      limits);
  Run(1200);
  ASSERT_NEAR(log_.last().z, kPressedForce, 0.01);
  Run(1100);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_TRUE(Told(LoopEventKind::kSafety, SafetyEvent::kStuck));
  Run(1700);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_EQ(Count(SafetyEvent::kStuck), 1U);
  Run(kSettled);
  EXPECT_NEAR(log_.last().z, kPressedForce, 0.01);
}

TEST_F(LoopTickTest, AStopHoldsUntilSomeoneAgreesToGoOn) {
  Begin(HoldAt(kPressed));
  Run(kSettled);
  mail_.stop = true;
  Run(1);
  EXPECT_EQ(log_.last(), kZero);
  Run(1000);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_TRUE(Newest().stopped);
  mail_.go_on = true;
  Run(kSettled);
  EXPECT_NEAR(log_.last().z, kPressedForce, kSmall);
  EXPECT_TRUE(Told(LoopEventKind::kWentOn));
}

TEST_F(LoopTickTest, EachStopIsToldHoweverSoonTheNextComes) {
  Begin(HoldAt(kPressed));
  Run(kSettled);
  for (int i = 0; i < 3; ++i) {
    mail_.stop = true;
    Run(5);
    EXPECT_TRUE(Told(LoopEventKind::kSafety, SafetyEvent::kStopped)) << i;
    mail_.go_on = true;
    Run(5);
  }
}

TEST_F(LoopTickTest, ASecondButtonStops) {
  Begin([](int n, DeviceState& state) {
    state.buttons = n == kSettled ? 2U : 0U;
    return HoldAt(kPressed)(n, state);
  });
  Run(kSettled + 1);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_TRUE(Newest().stopped);
}

TEST_F(LoopTickTest, HoldToFeelNeedsTheButton) {
  LoopOptions options;
  options.hold_to_feel = true;
  Begin(
      [](int n, DeviceState& state) {
        state.buttons = n >= kSettled && n < 3 * kSettled ? 1U : 0U;
        return HoldAt(kPressed)(n, state);
      },
      {}, options);
  Run(kSettled);
  EXPECT_EQ(log_.last(), kZero);
  Run(2 * kSettled);
  EXPECT_NEAR(log_.last().z, kPressedForce, kSmall);
  Run(1);
  EXPECT_EQ(log_.last(), kZero);
}

TEST_F(LoopTickTest, ASilentLoopBeginsAgainFromZero) {
  Begin(HoldAt(kPressed));
  Run(kSettled);
  Run(1, true);
  EXPECT_EQ(log_.last(), kZero);
  Run(100);
  EXPECT_LT(log_.last().z, kPressedForce / 2);  // 100 of the ramp's 250 ms: 0.35 of it
  Run(kSettled);
  EXPECT_NEAR(log_.last().z, kPressedForce, kSmall);
}

TEST_F(LoopTickTest, AnAxisThatDoesNotPushIsGivenNothing) {
  DeviceLimits limits;
  limits.pushes.z = false;
  Begin(HoldAt(kPressed), limits);
  Run(kSettled);
  EXPECT_EQ(log_.last().z, 0);
}

TEST_F(LoopTickTest, WhoHoldsADeviceWithoutMotorsIsToldTheForce) {
  DeviceLimits limits;
  limits.pushes = glm::bvec3(false);
  Begin(HoldAt(kPressed), limits);
  Run(kSettled);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_NEAR(Newest().force_P.z, kPressedForce, kSmall);
}

TEST_F(LoopTickTest, AShortPressAsksWhere) {
  Begin([](int n, DeviceState& state) {
    state.buttons = n < 100 ? 1U : 0U;
    return HoldAt(kPressed)(n, state);
  });
  Run(1000);
  EXPECT_TRUE(Told(LoopEventKind::kSay));
}

TEST_F(LoopTickTest, APageChangeKeepsThePointUnderTheTip) {
  // the tip moves evenly, 10 mm/s along x
  Begin([](int n, DeviceState& state) {
    return HoldAt(kPressed + glm::dvec3(1e-5 * n, 0, 0))(n, state);
  });
  Run(kSettled);
  const TextureField next = GrooveAlongY();
  PostedPage posted;
  posted.ready = tick_->scene().MakeReady(0, &next, {});
  posted.page = 7;
  posted.anchor = PageAnchor{{0.1, 0.1}, {0.05, 0.02}, 2};
  mail_.wanted_page = &posted;
  int ticks = 0;
  double last_force = 1;
  while (mail_.done_page.load() == nullptr) {
    last_force = glm::length(log_.last());
    ASSERT_LT(++ticks, 300);
    Run(1);
  }
  // zero at the swap: the command that stood, and the one of the swap itself
  EXPECT_EQ(last_force, 0);
  EXPECT_EQ(log_.last(), kZero);
  const LoopSnapshot snapshot = Newest();
  EXPECT_EQ(snapshot.page, 7U);
  // Twice the way from the old point, to within what the tip moves in a tick, at twice the size.
  const double tip_x = kPressed.x + 1e-5 * (log_.reads - 1);
  EXPECT_NEAR(snapshot.tip_P.x, 0.05 + 2 * (tip_x - 0.1), 2.1e-5);
  EXPECT_NEAR(snapshot.tip_P.y, 0.02, 1e-12);
  EXPECT_EQ(snapshot.tip_P.z, kPressed.z);
  // and the force is whole again within 300 ms of the wish
  Run(300 - ticks);
  EXPECT_NEAR(log_.last().z, kPressedForce, kSmall);
  EXPECT_TRUE(Told(LoopEventKind::kPageChanged));
  EXPECT_EQ(Count(SafetyEvent::kJump), 0U);
}

TEST_F(LoopTickTest, AShiftedPageGoesBackWhileTheTipIsInTheAir) {
  Begin([](int n, DeviceState& state) {
    return HoldAt(n < 500 ? kPressed : kPressed + glm::dvec3(0, 0, 0.01))(n, state);
  });
  Run(100);
  PostedPage posted;
  posted.ready = tick_->scene().MakeReady(0, &field_, {});
  posted.anchor = PageAnchor{{0.1, 0.1}, {0.05, 0.02}, 1};
  mail_.wanted_page = &posted;
  Run(400);
  EXPECT_NEAR(Newest().tip_P.x, 0.05, 1e-12);
  Run(300);
  EXPECT_NEAR(Newest().tip_P.x, kPressed.x, 1e-12);
  EXPECT_TRUE(Told(LoopEventKind::kPageBack));
}

// A stick cannot be lifted. In the groove the page stays where it is; beside it, on paper that is
// plain here and where the page comes to lie, it goes back after a second.
TEST_F(LoopTickTest, AStickFindsItsPageBackOncePlainPaperIsUnderTheTip) {
  const TextureField groove = GrooveAlongY();
  DeviceLimits stick;
  stick.measures.z = stick.pushes.z = false;
  Begin(
      [](int n, DeviceState& state) {
        return HoldAt({n < 2000 ? 0.1 : 0.104, 0.1, 0})(n, state);
      },
      stick);
  Run(100);
  PostedPage posted;
  posted.ready = tick_->scene().MakeReady(0, &groove, {});
  posted.anchor = PageAnchor{{0.1, 0.1}, {0, 0.02}, 1};  // the groove's middle is under the tip
  mail_.wanted_page = &posted;
  Run(1900);
  EXPECT_NEAR(Newest().tip_P.x, 0, 1e-12);
  Run(900);
  EXPECT_NEAR(Newest().tip_P.x, 0.004, 1e-12);
  Run(200);
  EXPECT_NEAR(Newest().tip_P.x, 0.104, 1e-12);
  EXPECT_TRUE(Told(LoopEventKind::kPageBack));
}

TEST_F(LoopTickTest, APageMayBringItsOwnDevice) {
  Begin(HoldAt(kPressed));
  Run(kSettled);
  DeviceLog log;
  PostedPage posted;
  posted.ready = tick_->scene().MakeReady(0, &field_, {});
  posted.device = std::make_unique<ScriptedDevice>(log, HoldAt({0.02, 0.03, -0.001}));
  mail_.wanted_page = &posted;
  Run(kSettled);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_NEAR(log.last().z, kPressedForce, kSmall);
  EXPECT_NE(posted.device, nullptr);  // the old one, for the publisher to destroy
  EXPECT_EQ(Count(SafetyEvent::kJump), 0U);
}

TEST_F(LoopTickTest, SamplesThatNobodyTakesAreCounted) {
  Begin(HoldAt(kPressed));
  Run(10000);
  std::uint64_t taken = 0;
  LoopSample sample;
  while (mail_.samples.Pop(sample)) ++taken;
  EXPECT_GE(taken, 2000U);  // two seconds
  EXPECT_EQ(taken + mail_.samples.dropped(), 10000U);
}

TEST_F(LoopTickTest, AStickFeelsSlopesAsLateralForce) {
  // A wide groove, slope 5/3 from 2.8 to 4.2 mm beside its middle.
  const TextureField wide = GrooveAlongY({0.014, 0.007, 0.0028});
  DeviceLimits stick;
  stick.measures.z = stick.pushes.z = false;
  LoopOptions options;
  options.press = 0.1;
  Begin(HoldAt({0.0036, 0.1, 0}), stick, options);
  PostedPage posted;
  posted.ready = tick_->scene().MakeReady(0, &wide, {});
  mail_.wanted_page = &posted;
  Run(4000);
  // The press along z balances the page's, whose lateral part is press times slope; the proxy gives
  // way by 0.17 mm and stays on the straight flank.
  EXPECT_NEAR(log_.last().x, -0.1 * 5 / 3, kSmall);
  EXPECT_NEAR(log_.last().y, 0, 1e-9);
  EXPECT_EQ(log_.last().z, 0);
}

TEST_F(LoopTickTest, AStickThatIsLiftedFeelsNothing) {
  DeviceLimits stick;
  stick.measures.z = stick.pushes.z = false;
  Begin(HoldAt({0.1, 0.1, 0.005}), stick);
  Run(kSettled);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_LE(Newest().depth, 0);
}

}  // namespace
}  // namespace moontrace

// The guiding push in the loop's tick: under the safety stage, off at once on a stop, off when the
// page changes, and told in samples and snapshots.

#include "sim/loop/loop_tick.h"

#include <cmath>
#include <glm/glm.hpp>

#include "lessons/guide/guidance_path.h"
#include "sim/loop/device_feel.h"
#include "tests/sim/loop_fixture.h"

namespace moontrace {
namespace {

constexpr glm::dvec3 kZero{0, 0, 0};
constexpr int kSettled = 700;   // ramp-in of safety, 250 ms, and of the push, 300 ms
constexpr double kOff = 0.002;  ///< of the tip beside the stroke [m]

/// A rail along x through the middle of the page, 200 N/m.
GuidancePlan RailPlan() {
  IntendedStroke stroke;
  stroke.spine_P = {Line{{0.1, 0.1 - kOff}, {0.12, 0.1 - kOff}}};
  stroke.width = 0.0014;
  GuidancePlan plan;
  plan.mode = GuidanceMode::kRail;
  plan.gains.stiffness = 200;
  plan.path = MakeGuidancePath({stroke});
  return plan;
}

class LoopPushTest : public LoopTickTest {
 protected:
  void Post(const GuidancePlan* plan) {
    posted_.plan = plan;
    mail_.wanted_push = &posted_;
  }
  LoopSample NewestSample() {
    LoopSample sample;
    while (mail_.samples.Pop(sample)) continue;
    return sample;
  }

  PostedPush posted_;
  GuidancePlan plan_ = RailPlan();
};

TEST_F(LoopPushTest, PushesByTheTipBesideThePage) {
  Begin(HoldAt(kPressed));
  Post(&plan_);
  Run(1);
  EXPECT_EQ(mail_.done_push.load(), &posted_);
  Run(kSettled);
  // The tip, not the proxy: 2 mm beside the stroke's start, where the push draws it to.
  EXPECT_NEAR(log_.last().y, -200 * kOff, 1e-9);
  EXPECT_NEAR(log_.last().z, kPressedForce, 1e-3);
  const LoopSnapshot snapshot = Newest();
  EXPECT_NEAR(snapshot.guidance_P.y, -200 * kOff, 1e-9);
  EXPECT_NEAR(snapshot.force_P.y, -200 * kOff, 1e-9);
  EXPECT_LT(glm::distance(snapshot.target_P, {0.1, 0.1 - kOff}), 1e-12);
  EXPECT_TRUE(snapshot.guided);
  EXPECT_FALSE(snapshot.guidance_done);
  EXPECT_NEAR(NewestSample().guidance_P.y, -200 * kOff, 1e-9);
}

TEST_F(LoopPushTest, WithoutAPlanNothingIsPushed) {
  Begin(HoldAt(kPressed));
  Run(kSettled);
  EXPECT_NEAR(log_.last().y, 0, 1e-9);
  const LoopSnapshot snapshot = Newest();
  EXPECT_EQ(snapshot.guidance_P, kZero);
  EXPECT_FALSE(snapshot.guided);
  EXPECT_EQ(snapshot.target_P, glm::dvec2(kPressed));
}

TEST_F(LoopPushTest, IsZeroInTheTickOfAStopAndRampsInAfterIt) {
  Begin(HoldAt(kPressed));
  Post(&plan_);
  Run(kSettled);
  mail_.stop = true;
  Run(1);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_EQ(Newest().guidance_P, kZero);
  Run(500);
  EXPECT_EQ(Newest().guidance_P, kZero);
  mail_.go_on = true;
  Run(100);
  const double begun = std::abs(Newest().guidance_P.y);
  EXPECT_LT(begun, 0.5 * 200 * kOff);
  Run(kSettled);
  EXPECT_NEAR(Newest().guidance_P.y, -200 * kOff, 1e-9);
}

TEST_F(LoopPushTest, IsFeltOnlyWhileTheButtonIsHeld) {
  LoopOptions options;
  options.hold_to_feel = true;
  Begin(HoldAt(kPressed), {}, options);
  Post(&plan_);
  Run(kSettled);
  EXPECT_EQ(log_.last(), kZero);
  EXPECT_EQ(Newest().guidance_P, kZero);
}

TEST_F(LoopPushTest, SafetysCapsHoldForPageAndPushTogether) {
  DeviceLimits weak;
  weak.peak_force = 0.3;
  plan_.gains.stiffness = 400;
  plan_.gains.cap = 3;
  Begin(HoldAt(kPressed), weak);
  Post(&plan_);
  Run(kSettled);
  EXPECT_LE(std::abs(log_.last().y), 0.3 + 1e-12);
  // and what is told of the push is what could be felt of it
  EXPECT_LE(std::abs(Newest().guidance_P.y), 0.3 + 1e-12);
  EXPECT_GT(Count(SafetyEvent::kForceCap), 0U);
}

TEST_F(LoopPushTest, EndsWhenThePageChangesUntilTheNextPlan) {
  Begin(HoldAt(kPressed));
  Post(&plan_);
  Run(kSettled);
  PostedPage page;
  page.ready = tick_->scene().MakeReady(0, &field_, {});
  page.page = 3;
  mail_.wanted_page = &page;
  Run(kSettled);
  const LoopSnapshot snapshot = Newest();
  EXPECT_EQ(snapshot.page, 3U);
  EXPECT_EQ(snapshot.guidance_P, kZero);
  EXPECT_FALSE(snapshot.guided);
  Post(&plan_);
  Run(kSettled);
  EXPECT_NEAR(Newest().guidance_P.y, -200 * kOff, 1e-9);
}

TEST_F(LoopPushTest, ADeviceWithoutMotorsIsNotPushedAndNothingIsCounted) {
  DeviceLimits limits;
  limits.pushes = glm::bvec3(false);
  Begin(HoldAt(kPressed), limits);
  Post(&plan_);
  Run(kSettled);
  EXPECT_EQ(log_.last(), kZero);
  const LoopSnapshot snapshot = Newest();
  EXPECT_EQ(snapshot.guidance_P, kZero);
  EXPECT_NEAR(snapshot.force_P.z, kPressedForce, 1e-3);
  EXPECT_NEAR(snapshot.force_P.y, 0, 1e-9);  // what the page would do, and no more
  EXPECT_LT(glm::distance(snapshot.target_P, {0.1, 0.1 - kOff}), 1e-12);  // for viewers
}

TEST_F(LoopPushTest, AFreshPlanBeginsAnew) {
  Begin(HoldAt(kPressed));
  Post(&plan_);
  Run(kSettled);
  GuidancePlan other = plan_;
  other.gains.stiffness = 100;
  Post(&other);
  Run(1);
  EXPECT_LT(std::abs(Newest().guidance_P.y), 1e-3);
  Run(kSettled);
  EXPECT_NEAR(Newest().guidance_P.y, -100 * kOff, 1e-9);
  Post(nullptr);
  Run(1);
  EXPECT_EQ(Newest().guidance_P, kZero);
}

TEST_F(LoopPushTest, ATiltedPageTurnsUnderATipThatKeepsItsHeight) {
  const double tilt = 0.3;
  Begin(HoldAt(kPressed));
  Run(kSettled);
  PostedPage page;
  page.ready = tick_->scene().MakeReady(0, &field_, {});
  page.tilt = tilt;
  page.anchor = PageAnchor{{0.1, 0.1}, {0.1, 0.1}, 1};
  mail_.wanted_page = &page;
  Run(2 * kSettled);
  EXPECT_LT(glm::distance(Newest().tip_P, kPressed), 1e-12);
  // the page's normal as the device has it: (0, -sin, cos) of a far edge raised by the tilt
  const glm::dvec3 force = log_.last();
  EXPECT_NEAR(force.y, -kPressedForce * std::sin(tilt), 1e-3);
  EXPECT_NEAR(force.z, kPressedForce * std::cos(tilt), 1e-3);
  EXPECT_EQ(Count(SafetyEvent::kJump), 0U);
  // level again
  page.tilt = 0;
  mail_.wanted_page = &page;
  Run(2 * kSettled);
  EXPECT_NEAR(log_.last().y, 0, 1e-6);
  EXPECT_LT(glm::distance(Newest().tip_P, kPressed), 1e-12);
}

TEST_F(LoopPushTest, APageThatWasTiltedUnderTheTipGoesBackOnlyWhereItIsNotFelt) {
  // 4 mm above the paper, 50 mm beyond the workspace's middle: tilted about that, the page would
  // come up to meet the tip
  Begin([](int n, DeviceState& state) {
    return HoldAt(n < 1500 ? glm::dvec3(0, 0.05, 0.004) : glm::dvec3(0, 0.05, 0.03))(n, state);
  });
  Run(100);
  PostedPage page;
  page.ready = tick_->scene().MakeReady(0, &field_, {});
  page.tilt = 0.3;
  mail_.wanted_page = &page;
  Run(1300);
  EXPECT_NEAR(Newest().tip_P.z, 0.004, 1e-12);
  EXPECT_EQ(log_.last(), kZero);
  Run(1000);
  EXPECT_TRUE(Told(LoopEventKind::kPageBack));
  EXPECT_NEAR(Newest().tip_P.z, 0.03 * std::cos(0.3) - 0.05 * std::sin(0.3), 1e-9);
}

TEST(HeldBy, KeepsAPushWithinWhatTheDeviceRenders) {
  DeviceLimits limits;
  limits.stiffness = 300;
  limits.peak_force = 1;
  GuidanceGains gains;
  gains.stiffness = 400;
  gains.cap = 1.5;
  EXPECT_EQ(HeldBy(limits, gains, 1).stiffness, 300);
  EXPECT_EQ(HeldBy(limits, gains, 3).stiffness, 100);
  EXPECT_EQ(HeldBy(limits, gains, 0.5).stiffness, 300);
  EXPECT_EQ(HeldBy(limits, gains, 1).cap, 1);
}

}  // namespace
}  // namespace moontrace

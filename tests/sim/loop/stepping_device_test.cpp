#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "tests/sim/loop_fixture.h"

namespace moontrace {
namespace {

using SteppingDeviceTest = LoopTickTest;

DeviceLimits InSteps(double step) {
  DeviceLimits limits;
  limits.position_step = step;
  return limits;
}

glm::dvec3 Rounded(glm::dvec3 p, double step) { return step * glm::round(p / step); }

// Steps of 64 um, a hand at 20 mm/s on flat paper: from tick to tick the readings go at 64 mm/s or
// not at all, and a damper of 10 N s/m would strike with 0.6 N. An even hand feels nothing
// sideways.
TEST_F(SteppingDeviceTest, IsNotStruckByTheDamperAtEveryStep) {
  constexpr double kStep = 64e-6;
  Begin(
      [](int n, DeviceState& state) {
        state.p_D = Rounded(kPressed + glm::dvec3(0.02, 0.005, 0) * (1e-3 * n), kStep);
        return DeviceStatus::kOk;
      },
      InSteps(kStep));
  Run(500);  // the ramp-in, and the tracker has caught up
  double sum = 0, greatest = 0;
  for (int n = 0; n < 1500; ++n) {
    Run(1);
    const glm::dvec2 sideways(log_.last());
    sum += glm::dot(sideways, sideways);
    greatest = std::max(greatest, glm::length(sideways));
  }
  EXPECT_LT(std::sqrt(sum / 1500), 0.05);
  EXPECT_LT(greatest, 0.12);
  // the height's rounding is half a step at most, on two springs of 1000 N/m in series
  EXPECT_NEAR(log_.last().z, kPressedForce, 500 * kStep / 2 + 0.02);
}

// A hand cannot jump: the loop begins afresh, and where no reading follows the tip is where the
// last one left it.
TEST_F(SteppingDeviceTest, StaysWhereItWasReadAfterAJump) {
  const glm::dvec3 there = kPressed + glm::dvec3(0.05, 0, 0);
  Begin(
      [there](int n, DeviceState& state) {
        if (n > 300) return DeviceStatus::kNoNewData;
        state.p_D = n < 300 ? kPressed : there;
        return DeviceStatus::kOk;
      },
      InSteps(64e-6));
  Run(310);
  EXPECT_EQ(Count(SafetyEvent::kJump), 1U);
  EXPECT_LE(glm::distance(Newest().tip_P, there), TipEstimate::kBand * 64e-6 * std::sqrt(3.0));
}

}  // namespace
}  // namespace moontrace

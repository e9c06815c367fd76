#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec3.hpp>

#include "tests/sim/loop_fixture.h"

namespace moontrace {
namespace {

using SlowDeviceTest = LoopTickTest;

// A stick that is read every 8 ms slides at 50 mm/s over flat paper without friction. Between its
// readings it stands still, so differences tick by tick would be 0.4 m/s in one tick of eight, and
// the coupling's 10 N s/m would strike with 4 N. Spread over its time the speed is the hand's, and
// what is left is the step of 0.4 mm: 0.4 N by the spring (1000 N/m), and by the damper 10 N s/m
// times what the proxy swings by, 0.4 mm sqrt(1000 N/m / 50 g) = 57 mm/s: below 1 N in all.
TEST_F(SlowDeviceTest, IsNotStruckByTheDamperAtEveryReading) {
  Begin([](int n, DeviceState& state) {
    if (n % 8 != 0) return DeviceStatus::kNoNewData;
    state.p_D = kPressed + glm::dvec3(0.05 * 1e-3 * n, 0, 0);
    return DeviceStatus::kOk;
  });
  double greatest = 0;
  for (int n = 0; n < 1000; ++n) {
    Run(1);
    greatest = std::max(greatest, std::abs(log_.last().x));
  }
  EXPECT_GT(greatest, 0.05);  // there is a coupling
  EXPECT_LT(greatest, 1);
  EXPECT_NEAR(log_.last().z, kPressedForce, 0.05);
}

}  // namespace
}  // namespace moontrace

#include "devices/core/smallest_letter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

/// A device that only its stiffness limits.
DeviceProfile Stiff(double stiffness) {
  DeviceProfile profile;
  profile.limits.stiffness = stiffness;
  profile.limits.damping = 0;
  profile.limits.peak_force = 100;
  return profile;
}

// Sizes are tried in steps of 0.1 mm.
constexpr double kStride = 1.01e-4;

TEST(SmallestLetter, FollowsFromTheStiffnessAboveEightMillimetres) {
  // There the flank's slope is (w/2) / (0.3 w) = 5/3: size = press x 5/3 / (K/4).
  EXPECT_NEAR(SmallestLetter(Stiff(500)), 4 * (5.0 / 3) / 500, kStride);
  EXPECT_NEAR(SmallestLetter(Stiff(800), 1), 4 * (5.0 / 3) / 800, kStride);
  EXPECT_NEAR(SmallestLetter(Stiff(500), 0.75), 4 * 0.75 * (5.0 / 3) / 500, kStride);
}

TEST(SmallestLetter, GainsFromTheFlatterGroovesBelowSix) {
  // There the slope is (w/3) / (0.3 w) = 10/9.
  EXPECT_NEAR(SmallestLetter(Stiff(1000)), 4 * (10.0 / 9) / 1000, kStride);
}

TEST(SmallestLetter, NeedsFivePositionStepsOnAFlank) {
  DeviceProfile profile = Stiff(1e5);
  profile.position_step = 100e-6;
  // Flank 0.3 x 0.1165 em above 8 mm: 0.5 mm / 0.03495.
  EXPECT_NEAR(SmallestLetter(profile), 0.5e-3 / 0.03495, kStride);
}

TEST(SmallestLetter, IsInfiniteWhereTheHandIsStrongerThanTheFlank) {
  DeviceProfile profile = Stiff(100);
  // 0.1 N: by the stiffness 4 mm would do, and 12 N/m x 4 mm = 0.05 N is held.
  profile.limits.peak_force = 0.1;
  EXPECT_NEAR(SmallestLetter(profile), 4e-3, kStride);
  // Steps of 400 um ask for 57 mm letters, whose drift pulls with 0.7 N.
  profile.position_step = 400e-6;
  EXPECT_TRUE(std::isinf(SmallestLetter(profile)));
}

TEST(SmallestLetter, DoesNotDependOnADeviceThatPushesNothing) {
  DeviceProfile profile = Stiff(10);
  profile.limits.pushes = {false, false, false};
  EXPECT_EQ(SmallestLetter(profile), 0);
}

}  // namespace
}  // namespace moontrace

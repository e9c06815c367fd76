#include "textures/field/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "textures/base/error.h"

namespace moontrace {
namespace {

// 10 mm letters: w = 1.165 mm, D = w/2, r = 0.2 w
const Profile kGroove{1.165e-3, 0.5825e-3, 0.233e-3};

TEST(Profile, ReachesItsTrueDepthOnTheSpine) {
  EXPECT_DOUBLE_EQ(Evaluate(kGroove, 0).height, kGroove.depth);
  EXPECT_EQ(Evaluate(kGroove, 0).slope, 0);
}

TEST(Profile, IsZeroFromTheRimOn) {
  for (const double d : {0.5 * kGroove.width, 0.6 * kGroove.width, 1.0}) {
    EXPECT_EQ(Evaluate(kGroove, d).height, 0);
    EXPECT_EQ(Evaluate(kGroove, d).slope, 0);
  }
}

TEST(Profile, FollowsTheDesignsThreeFormulas) {
  const double w = kGroove.width, D = kGroove.depth, r = kGroove.rounding;
  const double s = D / (w / 2 - r);
  // magnitudes of design section 4, point 1, worked out at one distance of each part
  EXPECT_NEAR(Evaluate(kGroove, 0.5 * r).height, D - s * 0.25 * r * r / (2 * r), 1e-18);
  EXPECT_NEAR(Evaluate(kGroove, 0.25 * w).height, D - s * r / 2 - s * (0.25 * w - r), 1e-18);
  EXPECT_NEAR(Evaluate(kGroove, 0.45 * w).height, s * 0.05 * w * 0.05 * w / (2 * r), 1e-18);
}

TEST(Profile, IsContinuousWithItsSlopeWhereItsPartsMeet) {
  const double r = kGroove.rounding, half = kGroove.width / 2;
  for (const double knot : {r, half - r, half}) {
    const double step = 1e-12;
    const ProfileSample before = Evaluate(kGroove, knot - step);
    const ProfileSample after = Evaluate(kGroove, knot + step);
    // at most the greatest slope, then the greatest curvature, times the step
    EXPECT_NEAR(before.height, after.height, 2 * step * GreatestSlope(kGroove) * 1.001);
    EXPECT_NEAR(before.slope, after.slope, 2 * step * GreatestCurvature(kGroove) * 1.001);
  }
}

TEST(Profile, SlopeIsTheDerivativeOfTheHeight) {
  const double step = 1e-9;
  for (int i = 1; i < 1000; ++i) {
    const double d = i * 0.55e-3 / 1000 + step;
    const double difference =
        (Evaluate(kGroove, d + step).height - Evaluate(kGroove, d - step).height) / (2 * step);
    // the second derivative jumps at the knots: the difference errs by at most step * s/r / 2
    EXPECT_NEAR(Evaluate(kGroove, d).slope, difference,
                step * GreatestCurvature(kGroove) + 1e-16 / step);
  }
}

TEST(Profile, FillIsFlatAtFullDepthInsideAndZeroOutside) {
  EXPECT_EQ(EvaluateFill(kGroove, -1e-3).height, 0);
  EXPECT_EQ(EvaluateFill(kGroove, 0).height, 0);
  EXPECT_DOUBLE_EQ(EvaluateFill(kGroove, kGroove.width / 2).height, kGroove.depth);
  EXPECT_EQ(EvaluateFill(kGroove, 5e-3).height, kGroove.depth);
  EXPECT_EQ(EvaluateFill(kGroove, 5e-3).slope, 0);
  // the same rim as the groove's
  EXPECT_DOUBLE_EQ(EvaluateFill(kGroove, 0.1e-3).height,
                   Evaluate(kGroove, kGroove.width / 2 - 0.1e-3).height);
}

TEST(ProfileCheck, RefusesWhatCannotBeAGroove) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Profile> broken = {{1e-3, 0.5e-3, 0},     {1e-3, 0.5e-3, 0.3e-3},
                                       {1e-3, 0, 0.2e-3},     {nan, 0.5e-3, 0.2e-3},
                                       {1e-3, -1e-3, 0.2e-3}, {1e-3, INFINITY, 0.2e-3}};
  for (const Profile& profile : broken) EXPECT_THROW(Check(profile), InputError);
  EXPECT_NO_THROW(Check({1e-3, 0.5e-3, 0.25e-3}));
}

}  // namespace
}  // namespace moontrace

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "devices/core/profile.h"
#include "devices/core/tip_estimate.h"
#include "devices/hid/wooden_haptics.h"
#include "tests/source_path.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

/// Encoders sit in the joints: what a count is worth along x, y and z depends on where the arm is.
class ArmSteps : public testing::TestWithParam<const char*> {
 protected:
  ArmSteps()
      : profile_(LoadProfile(SourcePath(std::string("devices/profiles/") + GetParam() + ".toml"))) {
  }

  double CountOf(std::size_t joint) const {
    return kTurn / (arm().counts[joint] * arm().reduction[joint]);
  }
  /// Angles at a tip of frame D, by Newton's method from the workspace's middle.
  ArmAngles AnglesFor(glm::dvec3 p_D) const {
    ArmAngles angles{0, 20 * kDegree, 37 * kDegree};
    for (int i = 0; i < 30; ++i) {
      const glm::dvec3 off = p_D - ArmPosition(arm(), angles);
      const glm::dvec3 turn = glm::inverse(ArmJacobian(arm(), angles)) * off;
      for (std::size_t j = 0; j < 3; ++j) angles[j] += turn[static_cast<int>(j)];
    }
    return angles;
  }
  /// What its encoders say of that tip.
  glm::dvec3 Reading(glm::dvec3 p_D) const {
    ArmAngles angles = AnglesFor(p_D);
    for (std::size_t j = 0; j < 3; ++j) {
      const double counts = (angles[j] - arm().rest[j]) / CountOf(j);
      angles[j] = arm().rest[j] + CountOf(j) * std::round(counts);
    }
    return ArmPosition(arm(), angles);
  }
  const ArmGeometry& arm() const { return profile_.arm; }

  DeviceProfile profile_;
};

// The profile's step is one joint's. Along an axis the joints add: at the workspace's edge up to
// 1.8 steps, so it bounds no axis. What the tracker reckons with is the spread, and roundings of
// different joints add in squares: at most 1.25 steps. Its band of 3 is wide enough.
TEST_P(ArmSteps, AddUpToLessThanTheTrackersBand) {
  double most = 0, spread = 0;
  for (double x = -0.08; x < 0.081; x += 0.04) {
    for (double y = -0.08; y < 0.081; y += 0.04) {
      for (double z = -0.04; z < 0.041; z += 0.04) {
        const glm::dvec3 p(x, y, z);
        if (glm::length(p) > 0.1) continue;
        const ArmAngles angles = AnglesFor(p);
        ASSERT_NEAR(glm::distance(ArmPosition(arm(), angles), p), 0, 1e-9);
        const glm::dmat3 per_radian = ArmJacobian(arm(), angles);
        for (int axis = 0; axis < 3; ++axis) {
          double sum = 0, squares = 0;
          for (int joint = 0; joint < 3; ++joint) {
            const double step =
                std::abs(per_radian[joint][axis]) * CountOf(static_cast<std::size_t>(joint));
            sum += step;
            squares += step * step;
          }
          most = std::max(most, sum);
          spread = std::max(spread, std::sqrt(squares));
        }
      }
    }
  }
  EXPECT_GT(most, 1.3 * profile_.position_step);
  EXPECT_LT(most, 2 * profile_.position_step);
  EXPECT_LT(spread, 1.25 * profile_.position_step);
}

// A proxy of 50 g on the profile's coupling in free air, once with the arm's readings and once with
// exact ones: the sideways force of the one less that of the other.
TEST_P(ArmSteps, AreNotFelt) {
  const CouplingGains coupling = CouplingOf(profile_);
  const double tick = 0.001, proxy = 0.05;
  for (const double speed : {0.002, 0.0193, 0.05}) {
    for (const glm::dvec3 along :
         {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0.8, 0)}) {
      TipEstimate tips[2] = {TipEstimate{glm::dvec3(profile_.position_step)}, TipEstimate()};
      glm::dvec3 p[2] = {Reading({0, 0, 0}), {0, 0, 0}}, v[2] = {};
      double sum = 0, peak = 0;
      for (int n = 0; n < 1000; ++n) {
        const double time = n * tick;  // there and back in 0.8 s, gently
        const glm::dvec3 tip = speed * 0.8 / kTurn * std::sin(kTurn / 0.8 * time) * along;
        tips[0].Advance(tick, true, Reading(tip));
        tips[1].Advance(tick, true, tip);
        glm::dvec3 force[2];
        for (int i = 0; i < 2; ++i) {
          force[i] =
              coupling.stiffness * (tips[i].p() - p[i]) + coupling.damping * (tips[i].v() - v[i]);
          v[i] += tick / proxy * force[i];
          p[i] += tick * v[i];
        }
        if (n < 200) continue;  // the motion begins at full speed
        const glm::dvec2 grit(force[0] - force[1]);
        sum += glm::dot(grit, grit);
        peak = std::max(peak, glm::length(grit));
      }
      EXPECT_LT(std::sqrt(sum / 800), 0.05) << speed << along.x;
      EXPECT_LT(peak, 0.12) << speed << along.x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ArmSteps, testing::Values("woodenhaptics", "polhem"));

}  // namespace
}  // namespace moontrace

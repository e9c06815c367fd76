#include "textures/field/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

const Profile kGroove{1e-3, 0.5e-3, 0.2e-3};

/// A right angle like the letter L, of two lines and dots at ends and corner.
Group Corner(double blend_radius) {
  Group group;
  group.elements = {{Line{{0, 0.01}, {0, 0}}, kGroove},
                    {Line{{0, 0}, {0.01, 0}}, kGroove},
                    {Dot{{0, 0.01}}, kGroove},
                    {Dot{{0, 0}}, kGroove},
                    {Dot{{0.01, 0}}, kGroove}};
  group.blend_radius = blend_radius;
  return group;
}
Texture One(Group group, Relief relief) { return {{{Finish(std::move(group)), relief}}}; }

class CornerJoint : public ::testing::TestWithParam<Relief> {};
INSTANTIATE_TEST_SUITE_P(GroovesAndRidges, CornerJoint,
                         ::testing::Values(Relief::kEngraved, Relief::kEmbossed));

TEST_P(CornerJoint, IsMitredInsideAndRoundOutside) {
  const Texture texture = One(Corner(0), GetParam());
  const double sign = GetParam() == Relief::kEngraved ? -1 : 1;
  // on the bisector both lines are equally near: the height is that of either alone
  const double a = 0.2e-3;
  EXPECT_NEAR(SampleTree(texture, {a, a}).displacement, sign * Evaluate(kGroove, a).height, 1e-15);
  // beside it the nearer line decides
  EXPECT_NEAR(SampleTree(texture, {a, 0.3e-3}).displacement, sign * Evaluate(kGroove, a).height,
              1e-15);
  // outside, the dot: the distance to the corner
  EXPECT_NEAR(SampleTree(texture, {-a, -a}).displacement,
              sign * Evaluate(kGroove, a * std::sqrt(2)).height, 1e-15);
}

TEST(Group, TakesTheLowestNumberedMemberOnACrease) {
  const Texture texture = One(Corner(0), Relief::kEngraved);
  // the first element is the upright line: its gradient points along x
  const Sample sample = SampleTree(texture, {0.2e-3, 0.2e-3});
  EXPECT_GT(sample.gradient.x, 0);
  EXPECT_EQ(sample.gradient.y, 0);
}

TEST(Group, NestsWithoutChangingAnything) {
  const auto corner = Finish(Corner(0));
  Group line, page;
  line.placements = {{corner, {0.02, 0}}};
  page.placements = {{Finish(line), {0, 0.05}}};
  const Texture nested = One(page, Relief::kEngraved);
  const Texture plain = One(Corner(0), Relief::kEngraved);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> near(-1e-3, 11e-3);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 p(near(random), near(random));
    EXPECT_NEAR(SampleTree(nested, p + glm::dvec2(0.02, 0.05)).displacement,
                SampleTree(plain, p).displacement, 1e-15);
  }
}

TEST(Sum, JoinsGroovesAndRidgesContinuously) {
  Group ridge;
  ridge.elements = {{Line{{-0.01, 0.005}, {0.02, 0.005}}, kGroove}};
  Texture both = One(Corner(0), Relief::kEngraved);
  both.layers.push_back({Finish(ridge), Relief::kEmbossed});
  // where a groove and a ridge of equal depth cross on their spines, nothing is left
  EXPECT_NEAR(SampleTree(both, {0, 0.005}).displacement, 0, 1e-15);
  EXPECT_NEAR(SampleTree(both, {0.015, 0.005}).displacement, kGroove.depth, 1e-15);
  EXPECT_NEAR(SampleTree(both, {0, 0.002}).displacement, -kGroove.depth, 1e-15);
}

TEST(Blend, RoundsTheInnerCreaseOnly) {
  const double rho = 0.25e-3;
  const Texture sharp = One(Corner(0), Relief::kEmbossed);
  const Texture round = One(Corner(rho), Relief::kEmbossed);
  // on the bisector, far enough from the corner for full weight: d' = d - rho/4
  const double a = 0.4e-3;
  EXPECT_NEAR(SampleTree(round, {a, a}).displacement, Evaluate(kGroove, a - rho / 4).height, 1e-15);
  // outside the corner, at the ends and along the lines nothing changes
  for (const glm::dvec2 p : {glm::dvec2(-0.2e-3, -0.2e-3), glm::dvec2(0.0102, 0.1e-3),
                             glm::dvec2(0.005, 0.3e-3), glm::dvec2(0.1e-3, -0.3e-3)}) {
    EXPECT_EQ(SampleTree(round, p).displacement, SampleTree(sharp, p).displacement);
  }
}

TEST(Blend, LeavesNoKinkOnTheInnerCrease) {
  const Texture round = One(Corner(0.25e-3), Relief::kEmbossed);
  // across the bisector of full weight the gradient turns over 2 rho, not at once
  const double a = 0.4e-3, step = 1e-9;
  const Sample below = SampleTree(round, {a + step, a - step});
  const Sample above = SampleTree(round, {a - step, a + step});
  // the smooth minimum bends by at most 1/(2 rho) times the flank's slope, per element of step
  const double bend = GreatestSlope(kGroove) / 0.25e-3 + GreatestCurvature(kGroove);
  EXPECT_LT(glm::length(below.gradient - above.gradient), 4 * step * bend);
  const Texture sharp = One(Corner(0), Relief::kEmbossed);
  EXPECT_GT(glm::length(SampleTree(sharp, {a + step, a - step}).gradient -
                        SampleTree(sharp, {a - step, a + step}).gradient),
            0.5 * GreatestSlope(kGroove));
}

}  // namespace
}  // namespace moontrace

#include "textures/field/element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;
const Profile kGroove{1e-3, 0.5e-3, 0.2e-3};

TEST(Line, CoversOnlyPointsWhoseFootLiesOnIt) {
  const Element line{Line{{0, 0}, {0.01, 0}}, kGroove};
  EXPECT_DOUBLE_EQ(Evaluate(line, {0.005, 0}).height, kGroove.depth);
  EXPECT_EQ(Evaluate(line, {-1e-9, 0}).height, 0);
  EXPECT_EQ(Evaluate(line, {0.01 + 1e-9, 0}).height, 0);
  EXPECT_DOUBLE_EQ(Evaluate(line, {0.01, 0.1e-3}).height, Evaluate(kGroove, 0.1e-3).height);
}

TEST(Arc, CoversItsAngleOnly) {
  // upper half circle of radius 5 mm, travelled clockwise
  const Element arc{Arc{{0, 0}, 0.005, kPi, -kPi}, kGroove};
  EXPECT_NEAR(Evaluate(arc, {0, 0.005}).height, kGroove.depth, 1e-18);
  EXPECT_NEAR(Evaluate(arc, {0, 0.0051}).height, Evaluate(kGroove, 0.1e-3).height, 1e-15);
  EXPECT_EQ(Evaluate(arc, {0, -0.005}).height, 0);
  EXPECT_EQ(Evaluate(arc, {0.005, -1e-6}).height, 0);
}

TEST(Dot, IsRoundAroundItsCentre) {
  const Element dot{Dot{{1e-3, 2e-3}}, kGroove};
  for (int i = 0; i < 12; ++i) {
    const glm::dvec2 way(std::cos(i * kPi / 6), std::sin(i * kPi / 6));
    EXPECT_NEAR(Evaluate(dot, glm::dvec2(1e-3, 2e-3) + 0.3e-3 * way).height,
                Evaluate(kGroove, 0.3e-3).height, 1e-15);
  }
}

TEST(Fill, MeasuresFromItsOutlineInwards) {
  // a square of 4 mm: at 0.2 mm from one side and far from the others
  const Fill square{{Line{{0, 0}, {4e-3, 0}}, Line{{4e-3, 0}, {4e-3, 4e-3}},
                     Line{{4e-3, 4e-3}, {0, 4e-3}}, Line{{0, 4e-3}, {0, 0}}}};
  const Element fill{square, kGroove};
  EXPECT_NEAR(Evaluate(fill, {2e-3, 0.2e-3}).height, EvaluateFill(kGroove, 0.2e-3).height, 1e-15);
  EXPECT_EQ(Evaluate(fill, {2e-3, 2e-3}).height, kGroove.depth);
  EXPECT_EQ(Evaluate(fill, {2e-3, -0.1e-3}).height, 0);
  EXPECT_GT(Evaluate(fill, {2e-3, 0.2e-3}).gradient.y, 0);
}

// A crescent is what lies inside one circle and outside another: told here without any outline.
TEST(Fill, OfACrescentEqualsTheDifferenceOfTwoDiscs) {
  const glm::dvec2 c1(0.345, 0.5), c2(0.568, 0.5);
  const double r1 = 0.40325, r2 = 0.364, d = c2.x - c1.x;
  const double x = (d * d + r1 * r1 - r2 * r2) / (2 * d);
  const double y = std::sqrt(r1 * r1 - x * x);
  const double outer = std::atan2(y, x), inner = std::atan2(y, x - d);
  const Fill crescent{{Arc{c1, r1, outer, 2 * kPi - 2 * outer},
                       Arc{c2, r2, 2 * kPi - inner, -(2 * kPi - 2 * inner)}}};
  const Profile profile{0.1165, 0.05825, 0.0233};
  const Element element{crescent, profile};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> anywhere(-0.2, 1.2);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 p(anywhere(random), anywhere(random));
    const double depth = std::min(r1 - glm::length(p - c1), glm::length(p - c2) - r2);
    inside += depth > 0 ? 1 : 0;
    // near the tips the nearest point of the outline is a corner, which the two discs do not know
    const double to_tip = glm::length(p - c1 - glm::dvec2(x, p.y > 0.5 ? y : -y));
    if (to_tip < 0.06) continue;
    EXPECT_NEAR(Evaluate(element, p).height, EvaluateFill(profile, depth).height, 1e-12);
  }
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace moontrace

#include "sim/physics/friction.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "textures/field/surface.h"

namespace moontrace {
namespace {

constexpr double kStiffness = 2000;  // [N/m]
constexpr glm::dvec3 kUp{0, 0, 1};

TEST(Friction, SticksAsASpringBelowTheCone) {
  Friction friction;
  friction.Advance(0.3, kStiffness, {0, 0, 0}, kUp, 1.0);
  const glm::dvec3 f = friction.Advance(0.3, kStiffness, {0.0001, 0, 0}, kUp, 1.0);
  EXPECT_NEAR(f.x, -kStiffness * 0.0001, 1e-12);  // 0.2 N, below 0.3 N
  EXPECT_EQ(f.y, 0);
  EXPECT_EQ(f.z, 0);
}

TEST(Friction, SlidesWithMuTimesTheNormalForceAgainstTheTravel) {
  Friction friction;
  glm::dvec3 f{0, 0, 0};
  for (int i = 0; i <= 100; ++i) {
    f = friction.Advance(0.3, kStiffness, {3e-5 * i, 4e-5 * i, 0}, kUp, 2.0);
  }
  EXPECT_NEAR(f.x, -0.6 * 3 / 5, 1e-9);
  EXPECT_NEAR(f.y, -0.6 * 4 / 5, 1e-9);
}

TEST(Friction, ForgetsTheAnchorWhenLifted) {
  Friction friction;
  friction.Advance(0.3, kStiffness, {0, 0, 0}, kUp, 1.0);
  friction.Advance(0.3, kStiffness, {0.001, 0, 0}, kUp, 1.0);
  EXPECT_EQ(friction.Advance(0.3, kStiffness, {0.002, 0, 0}, kUp, 0.0), glm::dvec3(0, 0, 0));
  EXPECT_EQ(friction.Energy(kStiffness), 0);
  const glm::dvec3 f = friction.Advance(0.3, kStiffness, {0.009, 0, 0}, kUp, 1.0);
  EXPECT_EQ(glm::length(f), 0);  // new contact, no travel yet
}

TEST(Friction, HandsOutNoEnergyOnARandomWalkOverATurningSurface) {
  // With F the force after a move of D, F.D + (energy after - energy before) <= 0 in every step:
  // the spring's energy is convex, and neither the cone nor the turn lengthens the spring.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> one(-1, 1);
  Friction friction;
  glm::dvec3 p{0, 0, 0};
  friction.Advance(0.4, kStiffness, p, kUp, 1.0);
  double before = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 move = 1e-4 * glm::dvec3(one(random), one(random), one(random));
    p += move;
    const glm::dvec3 normal = NormalOf({one(random), one(random)});
    const double press = 1 + one(random);
    const glm::dvec3 f = friction.Advance(0.4, kStiffness, p, normal, press);
    const double energy = friction.Energy(kStiffness);
    ASSERT_LE(glm::dot(f, move) + energy - before, 1e-16) << i;
    ASSERT_LE(glm::length(f), 0.4 * press * (1 + 1e-12));
    ASSERT_NEAR(glm::dot(f, normal), 0, 1e-12);
    before = energy;
  }
}

}  // namespace
}  // namespace moontrace

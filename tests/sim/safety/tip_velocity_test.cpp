#include "sim/safety/tip_velocity.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;

TEST(TipVelocity, IsTheWayOverTheTimeOfEachReadingsPeriod) {
  TipVelocity velocity;
  for (int n = 0; n < 100; ++n) {  // 50 mm/s, read every 8 ms
    velocity.Advance(kTick, n % 8 == 0, {0.05 * n * kTick, 0, 0});
    ASSERT_NEAR(velocity.v().x, n >= 8 ? 0.05 : 0, 1e-12) << n;
  }
}

TEST(TipVelocity, FadesWhereNoReadingComes) {
  TipVelocity velocity;
  velocity.Advance(kTick, true, {0, 0, 0});
  velocity.Advance(kTick, true, {0.001, 0, 0});
  EXPECT_NEAR(velocity.v().x, 1, 1e-12);
  for (int n = 0; n < 10; ++n) velocity.Advance(kTick, false, {0.001, 0, 0});
  EXPECT_NEAR(velocity.v().x, 0.1, 1e-12);  // less than 1 mm in 10 ms
  velocity.Advance(kTick, true, {0.001, 0, 0});
  EXPECT_EQ(velocity.v().x, 0);
}

TEST(TipVelocity, KnowsNoWayToTheFirstReadingNorToOneElsewhere) {
  TipVelocity velocity;
  velocity.Advance(kTick, true, {5, 0, 0});
  EXPECT_EQ(velocity.v(), glm::dvec3(0, 0, 0));
  velocity.Restart();
  velocity.Advance(kTick, true, {7, 0, 0});
  EXPECT_EQ(velocity.v(), glm::dvec3(0, 0, 0));
}

}  // namespace
}  // namespace moontrace

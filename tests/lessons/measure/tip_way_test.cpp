#include "lessons/measure/tip_way.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

TEST(TipWay, KeepsPointsASpacingApartAndTheNewest) {
  TipWay way(0.001);
  for (int i = 0; i <= 105; ++i) way.Add({1e-4 * i, 0});
  const std::vector<glm::dvec2> points = way.Points();
  EXPECT_NEAR(static_cast<double>(points.size()), 12, 1);  // rounding may skip one
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    EXPECT_GE(glm::distance(points[i], points[i - 1]), 0.001);
  }
  EXPECT_EQ(points.back(), glm::dvec2(105e-4, 0));
}

TEST(TipWay, StaysBoundedHoweverLongAndKeepsTheShape) {
  TipWay way(1e-4);
  for (int i = 0; i < 200000; ++i) {  // 200 rad: over 30 times round
    const double angle = 1e-3 * i;
    way.Add(0.01 * glm::dvec2(std::cos(angle), std::sin(angle)));
    if (i % 100 == 0) {
      ASSERT_LE(way.Points().size(), TipWay::kMost);
    }
  }
  for (const glm::dvec2 p : way.Points()) EXPECT_NEAR(glm::length(p), 0.01, 1e-12);
}

TEST(TipWay, OfNothingIsEmpty) { EXPECT_TRUE(TipWay(1e-3).Points().empty()); }

}  // namespace
}  // namespace moontrace

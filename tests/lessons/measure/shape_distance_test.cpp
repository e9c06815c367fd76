#include "lessons/measure/shape_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {
namespace {

using Points = std::vector<glm::dvec2>;

Points Wave(std::size_t count = 60) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.02 * static_cast<double>(i) / static_cast<double>(count - 1);
    points.emplace_back(x, 0.003 * std::sin(500 * x));
  }
  return points;
}

Points Straight(glm::dvec2 from, glm::dvec2 to, int count = 41) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(from + i / (count - 1.0) * (to - from));
  return points;
}

void ExpectAll(const ShapeDistance& distance, double value) {
  EXPECT_NEAR(distance.warped, value, 1e-15);
  EXPECT_NEAR(distance.frechet, value, 1e-15);
  EXPECT_NEAR(distance.hausdorff, value, 1e-15);
}

TEST(ShapeDistance, OfTheSameWayIsZero) { ExpectAll(ShapeDistanceOf(Wave(), Wave()), 0); }

TEST(ShapeDistance, OfALineMovedAsideIsTheShift) {
  const double shift = 0.7e-3;
  ExpectAll(ShapeDistanceOf(Straight({0, 0}, {0.02, 0}), Straight({0, shift}, {0.02, shift})),
            shift);
}

TEST(ShapeDistance, OfConcentricRingsIsTheDifferenceOfRadii) {
  Points inner, outer;
  for (int i = 0; i <= 90; ++i) {
    const glm::dvec2 out(std::cos(0.06 * i), std::sin(0.06 * i));
    inner.push_back(0.006 * out);
    outer.push_back(0.007 * out);
  }
  ExpectAll(ShapeDistanceOf(inner, outer), 0.001);
}

TEST(ShapeDistance, IsTheSameBothWaysRound) {
  const Points a = Wave(50), b = Straight({0, 0.001}, {0.018, -0.002}, 37);
  const ShapeDistance ab = ShapeDistanceOf(a, b), ba = ShapeDistanceOf(b, a);
  EXPECT_NEAR(ab.warped, ba.warped, 1e-15);
  EXPECT_EQ(ab.frechet, ba.frechet);
  EXPECT_EQ(ab.hausdorff, ba.hausdorff);
  EXPECT_GT(ab.warped, 0);
}

TEST(ShapeDistance, OrderMattersToAllButHausdorff) {
  const Points there = Straight({0, 0}, {0.02, 0});
  const Points back(there.rbegin(), there.rend());
  const ShapeDistance reversed = ShapeDistanceOf(there, back);
  EXPECT_EQ(reversed.hausdorff, 0);
  EXPECT_NEAR(reversed.frechet, 0.02, 1e-15);  // the ends are matched with the far ends
  EXPECT_GT(reversed.warped, 0.004);
}

TEST(ShapeDistance, WarpingTakesATableOfPairs) {
  // By hand: 0 2 5 against 0 4; least sum: (0,0) twice 0, then diagonal (2,4) twice 2 and down
  // (5,4) 1, or down (2,0) 2 and diagonal (5,4) twice 1: 4. Over 3 + 2.
  const ShapeDistance d = ShapeDistanceOf({{0, 0}, {2, 0}, {5, 0}}, {{0, 0}, {4, 0}});
  EXPECT_NEAR(d.warped, 4.0 / 5, 1e-15);
  EXPECT_NEAR(d.frechet, 2, 1e-15);
  EXPECT_NEAR(d.hausdorff, 2, 1e-15);
}

TEST(ShapeDistance, OfNothingIsZero) {
  ExpectAll(ShapeDistanceOf({}, Wave()), 0);
  ExpectAll(ShapeDistanceOf(Wave(), {}), 0);
}

TEST(Resampled, PutsPointsEvenlyByArcLengthWhateverTheirDensity) {
  const Points uneven{{0, 0}, {0.001, 0}, {0.001, 0}, {0.009, 0}, {0.010, 0}, {0.010, 0.010}};
  const Points even = Resampled(uneven, 5);
  ASSERT_EQ(even.size(), 5u);
  const Points expected{{0, 0}, {0.005, 0}, {0.010, 0}, {0.010, 0.005}, {0.010, 0.010}};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(glm::distance(even[i], expected[i]), 0, 1e-15);
}

TEST(Resampled, OfOnePointIsThatPoint) {
  EXPECT_EQ(Resampled({{1, 2}}, 3), (Points{{1, 2}, {1, 2}, {1, 2}}));
  EXPECT_TRUE(Resampled({}, 3).empty());
}

}  // namespace
}  // namespace moontrace

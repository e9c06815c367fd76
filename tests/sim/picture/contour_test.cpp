#include "sim/picture/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <numbers>

namespace moontrace {
namespace {

constexpr int kCells = 100;

/// Over the square from -2 to 2.
HeightGrid GridOf(const std::function<double(double, double)>& height) {
  HeightGrid grid{{{-2, -2}, {2, 2}}, kCells, kCells, {}};
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const glm::dvec2 p = glm::dvec2(-2.0) + 4.0 / kCells * glm::dvec2(i, j);
      grid.heights.push_back(height(p.x, p.y));
    }
  }
  return grid;
}

/// Gauss's formula: below zero for a polygon that runs clockwise.
double Area(const std::vector<glm::dvec2>& polygon) {
  double area2 = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    area2 += a.x * b.y - a.y * b.x;
  }
  return area2 / 2;
}

// A chord of one cell, 0.04, lies 0.04^2 / 8 r within a circle; what the sides are cut at errs by
// no more. 2 pi r of it, twice over.
constexpr double kSlack = 2 * 2 * std::numbers::pi * 0.04 * 0.04 / 8 * 2;

TEST(OutlinesAboveZero, GoCounterClockwiseRoundAHillAndClockwiseRoundItsHole) {
  auto outlines = OutlinesAboveZero(
      GridOf([](double x, double y) { return 0.5 - std::abs(std::hypot(x, y) - 1); }));
  ASSERT_EQ(outlines.size(), 2U);
  std::sort(outlines.begin(), outlines.end(),
            [](const auto& a, const auto& b) { return Area(a) < Area(b); });
  EXPECT_NEAR(Area(outlines[0]), -std::numbers::pi * 0.25, kSlack);
  EXPECT_NEAR(Area(outlines[1]), std::numbers::pi * 2.25, kSlack);
}

TEST(OutlinesAboveZero, EndAtTheBox) {
  const auto all = OutlinesAboveZero(GridOf([](double, double) { return 1; }));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(Area(all[0]), 16, 1e-12);
  const auto half = OutlinesAboveZero(GridOf([](double x, double) { return x - 0.5; }));
  ASSERT_EQ(half.size(), 1U);
  EXPECT_NEAR(Area(half[0]), 6, 1e-12);
  EXPECT_TRUE(OutlinesAboveZero(GridOf([](double, double) { return 0; })).empty());
}

TEST(OutlinesAboveZero, JoinHighCornersThatFaceEachOther) {
  // one cell, a saddle: the hexagon without its two low corners
  const auto outlines = OutlinesAboveZero({{{0, 0}, {1, 1}}, 1, 1, {1, -1, -1, 1}});
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_NEAR(Area(outlines[0]), 0.75, 1e-12);
}

}  // namespace
}  // namespace moontrace

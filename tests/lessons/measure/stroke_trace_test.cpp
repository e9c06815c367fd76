#include "lessons/measure/stroke_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

TEST(TipPath, KeepsPointsASpacingApartAndTheNewest) {
  TipPath path(0.001);
  for (int i = 0; i <= 105; ++i) path.Add({1e-4 * i, 0});
  const std::vector<glm::dvec2> points = path.Points();
  EXPECT_NEAR(static_cast<double>(points.size()), 12, 1);  // rounding may skip one
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    EXPECT_GE(glm::distance(points[i], points[i - 1]), 0.001);
  }
  EXPECT_EQ(points.back(), glm::dvec2(105e-4, 0));
}

TEST(TipPath, StaysBoundedHoweverLongAndKeepsTheShape) {
  TipPath path(1e-4);
  for (int i = 0; i < 200000; ++i) {  // 200 rad: over 30 times round
    const double angle = 1e-3 * i;
    path.Add(0.01 * glm::dvec2(std::cos(angle), std::sin(angle)));
    if (i % 100 == 0) {
      ASSERT_LE(path.Points().size(), TipPath::kMost);
    }
  }
  for (const glm::dvec2 p : path.Points()) EXPECT_NEAR(glm::length(p), 0.01, 1e-12);
}

// Moon's longest stroke, the ring of O, is pi em or 27 widths of 0.1165 em long; a trembling tip's
// way along it was up to half as long again. Points are w/8 apart: 8 * 27 * 1.5 = 324.
TEST(TipPath, KeepsAllPointsOfALettersLongestStroke) {
  TipPath path(1);
  for (int i = 0; i < 324; ++i) path.Add({i, 0});
  EXPECT_EQ(path.Points().size(), 324u);
}

TEST(TipPath, OfNothingIsEmpty) { EXPECT_TRUE(TipPath(1e-3).Points().empty()); }

}  // namespace
}  // namespace moontrace

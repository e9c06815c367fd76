#include "textures/fonts/polyline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "tests/textures/stroke_distance.h"

namespace moontrace {
namespace {

double Bend(const Piece& before, const Piece& behind) {
  const glm::dvec2 u = TangentAt(before, Length(before)), v = TangentAt(behind, 0);
  return std::abs(std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v)));
}

TEST(RoundedPolyline, KeepsEndsAndStaysWithinTheTolerance) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= 12; ++i) {
    points.emplace_back(std::cos(0.3 * i), std::sin(0.3 * i));
  }
  const Stroke stroke{StrokeKind::kStroke, RoundedPolyline(points, 0.002)};
  EXPECT_LT(glm::length(StartOf(stroke.pieces.front()) - points.front()), 1e-12);
  EXPECT_LT(glm::length(EndOf(stroke.pieces.back()) - points.back()), 1e-12);
  const double distance = DistanceOf(stroke, points);
  EXPECT_LE(distance, 0.002 + 1e-12);
  EXPECT_GT(distance, 0.0015);  // the tolerance is used, or the fillets are needlessly tight
}

TEST(RoundedPolyline, JoinsGentleBendsWithoutAKinkAndWithoutAGap) {
  const std::vector<Piece> pieces =
      RoundedPolyline({{0, 0}, {1, 0}, {1.8, 0.5}, {2, 1.2}, {2.0, 1.3}, {1.9, 1.4}}, 0.01);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    EXPECT_LT(glm::length(EndOf(pieces[i]) - StartOf(pieces[i + 1])), 1e-9);
    EXPECT_LT(Bend(pieces[i], pieces[i + 1]), 1e-6);
  }
}

TEST(RoundedPolyline, FilletRadiusFollowsTheClosedForm) {
  // A bend by 30 degrees: R = tolerance / (1 / cos 15 - 1), where the lines are long enough.
  const double angle = std::numbers::pi / 6;
  const std::vector<Piece> pieces =
      RoundedPolyline({{-9, 0}, {0, 0}, {9 * std::cos(angle), 9 * std::sin(angle)}}, 0.002);
  ASSERT_EQ(pieces.size(), 3U);
  const Arc& arc = std::get<Arc>(pieces[1]);
  EXPECT_NEAR(arc.radius, 0.002 / (1 / std::cos(angle / 2) - 1), 1e-9);
  EXPECT_NEAR(arc.sweep, angle, 1e-9);
}

TEST(RoundedPolyline, LeavesSharpCornersAndStraightRunsAsTheyAre) {
  const std::vector<Piece> corner = RoundedPolyline({{0, 0}, {1, 0}, {1, 1}}, 0.01);
  EXPECT_EQ(corner, (std::vector<Piece>{Line{{0, 0}, {1, 0}}, Line{{1, 0}, {1, 1}}}));
  EXPECT_EQ(RoundedPolyline({{0, 0}, {1, 0}, {2, 0}}, 0.01).size(), 2U);
  EXPECT_EQ(RoundedPolyline({{0, 0}, {1, 0}, {0, 0}}, 0.01).size(), 2U);  // there and back
}

TEST(RoundedPolyline, IsEmptyWithoutTwoDifferentPoints) {
  EXPECT_TRUE(RoundedPolyline({}, 0.01).empty());
  EXPECT_TRUE(RoundedPolyline({{1, 1}}, 0.01).empty());
  EXPECT_TRUE(RoundedPolyline({{1, 1}, {1, 1}}, 0.01).empty());
}

}  // namespace
}  // namespace moontrace

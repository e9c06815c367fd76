#include "textures/relief/link.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;

double LengthOf(const std::vector<Piece>& path) {
  double length = 0;
  for (const Piece& piece : path) length += Length(piece);
  return length;
}

/// Leaves and arrives as the rays say, without a corner between; to the rounding of sines.
void ExpectSmooth(const std::vector<Piece>& path, const Ray& from, const Ray& to) {
  ASSERT_FALSE(path.empty());
  glm::dvec2 point = from.point, way = from.direction;
  for (const Piece& piece : path) {
    EXPECT_LT(glm::distance(StartOf(piece), point), 1e-12);
    EXPECT_GT(glm::dot(TangentAt(piece, 0), way), 1 - 1e-12);
    point = EndOf(piece);
    way = TangentAt(piece, Length(piece));
  }
  EXPECT_LT(glm::distance(point, to.point), 1e-12);
  EXPECT_GT(glm::dot(way, to.direction), 1 - 1e-12);
}

TEST(ArcLineArc, GoesStraightWhereTheRaysAreOneLine) {
  const std::vector<Piece> path = ArcLineArc({{0, 0}, {1, 0}}, {{3, 0}, {1, 0}}, 1, 1);
  ASSERT_EQ(path.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<Line>(path.front()));
  EXPECT_DOUBLE_EQ(LengthOf(path), 3);
}

// Half a circle, 4 m back, half a circle: a running track.
TEST(ArcLineArc, TurnsBackRoundACircle) {
  const Ray from{{0, 0}, {1, 0}}, to{{-4, 2}, {-1, 0}};
  const std::vector<Piece> path = ArcLineArc(from, to, 1, 1);
  ExpectSmooth(path, from, to);
  EXPECT_NEAR(LengthOf(path), kPi + 4, 1e-12);
  EXPECT_NEAR(ArcLineArcLength(from, to, 1, 1), kPi + 4, 1e-12);
}

TEST(ArcLineArc, IsSmoothForEverySenseAndTwoRadii) {
  const Ray from{{0.3, -0.2}, {0.6, 0.8}}, to{{7, 3}, {0.8, -0.6}};
  for (const double a : {-0.5, 0.5, 1.5}) {
    for (const double b : {-0.7, 0.7}) {
      const std::vector<Piece> path = ArcLineArc(from, to, a, b);
      ExpectSmooth(path, from, to);
      EXPECT_NEAR(LengthOf(path), ArcLineArcLength(from, to, a, b), 1e-12);
    }
  }
}

// Circles of opposite sense whose centres lie nearer than their radii's sum have no inner tangent.
TEST(ArcLineArc, IsNoneWhereTheCirclesOverlap) {
  EXPECT_TRUE(ArcLineArc({{0, 0}, {1, 0}}, {{0, 0.5}, {1, 0}}, 1, -1).empty());
  EXPECT_TRUE(ArcLineArc({{0, 0}, {1, 0}}, {{0, 0}, {1, 0}}, 1, 1).empty());
}

LinkTask Across(double y_of_wall_end) {
  LinkTask task;
  task.from.rays = {{{0, 0}, {1, 0}}};
  task.to.rays = {{{10, 0}, {1, 0}}};
  task.others = {{Line{{5, -9}, {5, y_of_wall_end}}, 0.5}};
  task.half = 0.5;
  task.gap = 0.25;
  task.radius = 1;
  task.room = {{-2, -3}, {12, 3}};
  for (const double y : {-2.0, 2.0}) task.ways.push_back({{5, y}, {1, 0}});
  return task;
}

TEST(FindLink, GoesStraightWhereNothingStands) {
  LinkTask task = Across(-8);
  const std::vector<Piece> path = FindLink(task);
  ExpectSmooth(path, task.from.rays[0], task.to.rays[0]);
  EXPECT_DOUBLE_EQ(LengthOf(path), 10);
}

TEST(FindLink, GoesRoundAWallAtTheGap) {
  const LinkTask task = Across(0.5);
  const std::vector<Piece> path = FindLink(task);
  ExpectSmooth(path, task.from.rays[0], task.to.rays[0]);
  EXPECT_GT(LengthOf(path), 10);
  const double gap = LeastGap(path, task.half, task.others[0], 0, 0, 1e-3);
  EXPECT_GE(gap, task.gap);
  EXPECT_LT(gap, 1.5);  // not as far as the room would let it
}

TEST(FindLink, IsNoneWhereTheWallClosesTheRoom) { EXPECT_TRUE(FindLink(Across(9)).empty()); }

// The end's own stroke does not count over the link's first part, and counts behind it: a link that
// turns back keeps the gap to the stroke that it left.
TEST(FindLink, LeavesItsOwnStrokeAndThenKeepsClearOfIt) {
  LinkTask task;
  const LinkWall own{Line{{-6, 0}, {0, 0}}, 0.5};
  task.from = {{{{0, 0}, {1, 0}}}, {own}, 2.5};
  task.to.rays = {{{-6, 3}, {-1, 0}}};
  task.half = 0.5;
  task.gap = 0.25;
  task.radius = 1;
  task.room = {{-9, -5}, {5, 5}};
  const std::vector<Piece> path = FindLink(task);
  ExpectSmooth(path, task.from.rays[0], task.to.rays[0]);
  EXPECT_LT(LeastGap(path, task.half, own, 0, 0, 1e-3), 0);
  EXPECT_GE(LeastGap(path, task.half, own, 2.5, 0, 1e-3), task.gap);
}

// A link that must get past another crosses it, at 40 degrees or more.
TEST(FindLink, CrossesAnotherLinkButDoesNotRunAlongIt) {
  LinkTask task = Across(-8);
  task.to.rays = {{{10, 1}, {1, 0}}};
  for (double x = 3; x <= 7; x += 0.25) task.crossed.push_back({{x, 0.2}, {1, 0}});
  task.ways.push_back({{2, -1.5}, {0, 1}});
  task.ways.push_back({{2, 1.5}, {1, 0}});
  const std::vector<Piece> path = FindLink(task);
  ExpectSmooth(path, task.from.rays[0], task.to.rays[0]);
  for (const Piece& piece : path) {
    for (double s = 0; s < Length(piece); s += 0.01) {
      const glm::dvec2 p = PointAt(piece, s), way = TangentAt(piece, s);
      for (const Ray& ray : task.crossed) {
        // points between those looked at are half the shortest step away
        if (glm::distance(p, ray.point) < 2 * task.half - 0.1) {
          EXPECT_GT(std::abs(way.y), 0.5);
        }
      }
    }
  }
}

}  // namespace
}  // namespace moontrace

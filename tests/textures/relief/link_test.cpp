#include "textures/relief/link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

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
}

TEST(ArcLineArc, IsSmoothForEverySenseAndTwoRadii) {
  const Ray from{{0.3, -0.2}, {0.6, 0.8}}, to{{7, 3}, {0.8, -0.6}};
  for (const double a : {-0.5, 0.5, 1.5}) {
    for (const double b : {-0.7, 0.7}) {
      const std::vector<Piece> path = ArcLineArc(from, to, a, b);
      ExpectSmooth(path, from, to);
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

// A wall of another link, open where nothing leads: from room's edge to room's edge.
LinkTask PastALink() {
  LinkTask task = Across(-8);
  task.links = {Line{{3, -3}, {6, 3}}};
  return task;
}

TEST(FindLink, DoesNotCrossAnotherLinkUnlessItMay) { EXPECT_TRUE(FindLink(PastALink()).empty()); }

// At 40 degrees or more, wherever their grooves are in touch.
TEST(FindLink, CrossesAnotherLinkSteeply) {
  LinkTask task = PastALink();
  task.may_cross = true;
  const std::vector<Piece> path = FindLink(task);
  ExpectSmooth(path, task.from.rays[0], task.to.rays[0]);
  const glm::dvec2 along = TangentAt(task.links[0], 0);
  bool crosses = false;
  for (const Piece& piece : path) {
    for (double s = 0; s < Length(piece); s += 0.01) {
      if (DistanceTo(task.links[0], PointAt(piece, s)) > 2 * task.half - 0.3) continue;
      const glm::dvec2 way = TangentAt(piece, s);
      EXPECT_GT(std::abs(along.x * way.y - along.y * way.x), 0.64);
      crosses = true;
    }
  }
  EXPECT_TRUE(crosses);
}

// A string drawn tight round the end of another link, at the gap.
TEST(FindLink, GoesRoundTheEndOfAnotherLink) {
  LinkTask task = Across(-8);
  task.links = {Line{{5, -3}, {5, 0.3}}};
  const std::vector<Piece> path = FindLink(task);
  ExpectSmooth(path, task.from.rays[0], task.to.rays[0]);
  double least = 9;
  for (const Piece& piece : path) {
    for (double s = 0; s < Length(piece); s += 1e-3) {
      least = std::min(least, DistanceTo(task.links[0], PointAt(piece, s)));
    }
  }
  EXPECT_GE(least, 2 * task.half + task.gap);
  EXPECT_LT(least, 1.01 * (2 * task.half + task.gap));
}

// A wall right ahead, wider than the room: the sharpest turn, of radius 1, leaves room enough at 1
// more than the 1.25 m that two half widths and the gap need, and none at less.
TEST(FindLink, TurnsBackBeforeAWallAheadIfItIsFarEnough) {
  for (const double wall : {1.25 + 1.01, 1.25 + 0.95, 1.25 + 0.5, 1.25 + 0.05}) {
    LinkTask away;
    away.from.rays = {{{0, 0}, {1, 0}}};
    away.to.rays = {{{-6, 2.5}, {-1, 0}}};
    away.others = {{Line{{wall, -9}, {wall, 9}}, 0.5}};
    away.half = 0.5;
    away.gap = 0.25;
    away.radius = 1;
    away.room = {{-9, -5}, {5, 5}};
    LinkTask back = away;  // the same way travelled the other way round
    back.from.rays = {{{-6, 2.5}, {1, 0}}};
    back.to.rays = {{{0, 0}, {-1, 0}}};
    EXPECT_EQ(FindLink(away).empty(), wall < 1.25 + 1) << wall;
    EXPECT_EQ(FindLink(back).empty(), wall < 1.25 + 1) << wall;
  }
}

TEST(FindLink, TurnsNoSharperThanAllowed) {
  LinkTask task = Across(0.5);
  for (const Piece& piece : FindLink(task)) {
    const std::optional<Arc> arc = ArcOf(piece);
    if (arc) {
      EXPECT_GE(arc->radius, task.radius);
    }
  }
}

TEST(FindLink, LeavesADotAnyWayAndGoesOnPastItIfAsked) {
  LinkTask task = Across(-8);
  task.from = {{{{0, 0}, {1, 0}}}, {{Line{{0, 0}, {0, 0}}, 0.5}}, 2};
  task.from.is_dot = true;
  task.to.rays = {{{-10, 0}, {-1, 0}}};
  task.room.min.x = -12;
  const std::vector<Piece> back = FindLink(task);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_DOUBLE_EQ(LengthOf(back), 10);
  task.from.goes_on = true;
  const std::vector<Piece> on = FindLink(task);
  ASSERT_FALSE(on.empty());
  EXPECT_GT(glm::dot(TangentAt(on.front(), 0), glm::dvec2(1, 0)), 0.49);
}

}  // namespace
}  // namespace moontrace

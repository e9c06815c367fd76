#include "textures/field/piece.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Piece, IsTravelledAtUnitSpeedFromStartToEnd) {
  const Piece arc = Arc{{1, 2}, 0.5, 0.3, -2.0};
  EXPECT_DOUBLE_EQ(Length(arc), 1.0);
  EXPECT_NEAR(glm::length(PointAt(arc, 0) - StartOf(arc)), 0, 1e-15);
  EXPECT_NEAR(glm::length(PointAt(arc, 1) - EndOf(arc)), 0, 1e-15);
  const glm::dvec2 moved = (PointAt(arc, 0.4 + 1e-6) - PointAt(arc, 0.4 - 1e-6)) / 2e-6;
  EXPECT_NEAR(glm::length(moved - TangentAt(arc, 0.4)), 0, 1e-9);
}

TEST(Piece, BoundsHoldEveryPointAndTouchTheExtremes) {
  const Piece arc = Arc{{0, 0}, 1, 0.25 * kPi, kPi};  // passes the top and the left
  const Box box = BoundsOf(arc);
  EXPECT_NEAR(box.max.y, 1, 1e-15);
  EXPECT_NEAR(box.min.x, -1, 1e-15);
  EXPECT_NEAR(box.min.y, -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(box.max.x, std::sqrt(0.5), 1e-15);
}

TEST(Piece, DistanceReachesTheEnds) {
  EXPECT_DOUBLE_EQ(DistanceTo(Line{{0, 0}, {1, 0}}, {2, 0}), 1);
  EXPECT_NEAR(DistanceTo(Arc{{0, 0}, 1, 0, kPi / 2}, {1, -1}), 1, 1e-15);
}

TEST(Piece, PartsLieOnItAndRunBothWays) {
  const std::vector<Piece> pieces = {Line{{1, 1}, {1, 4}}, Arc{{0, 2}, 2, 1, -1.2},
                                     Arc{{0, 2}, 2, -3, 1.2}};
  for (const Piece& piece : pieces) {
    for (const auto& [from, to] : {std::pair(0.5, 1.5), std::pair(1.5, 0.5)}) {
      const Piece part = PartBetween(piece, from, to);
      EXPECT_NEAR(Length(part), 1, 1e-15);
      for (const double s : {0.0, 0.4, 1.0}) {
        const double at = from + (to > from ? s : -s);
        EXPECT_NEAR(glm::distance(PointAt(part, s), PointAt(piece, at)), 0, 1e-14) << at;
      }
    }
  }
}

TEST(Piece, ChainsAreTravelledOnePieceAfterTheOther) {
  const std::vector<Piece> chain = {Line{{0, 0}, {1, 0}}, Arc{{1, 1}, 1, -kPi / 2, kPi / 2}};
  EXPECT_DOUBLE_EQ(Length(chain), 1 + kPi / 2);
  EXPECT_EQ(Length(std::vector<Piece>()), 0);
  EXPECT_EQ(PointAlong(chain, 0.25), glm::dvec2(0.25, 0));
  const glm::dvec2 middle(1 + std::sqrt(0.5), 1 - std::sqrt(0.5));
  EXPECT_NEAR(glm::distance(PointAlong(chain, 1 + kPi / 4), middle), 0, 1e-15);
  EXPECT_EQ(PointAlong(chain, 9), EndOf(chain.back()));
}

TEST(Arc, AnglesAreCountedFromItsStartInItsOwnSense) {
  const Arc left{{0, 0}, 1, 0.5, 1}, right{{0, 0}, 1, 0.5, -1};
  for (const double angle : {0.1, 1.0, 3.0, 6.0}) {
    EXPECT_NEAR(AngleAlong(left, DirectionOf(0.5 + angle)), angle, 1e-14);
    EXPECT_NEAR(AngleAlong(right, DirectionOf(0.5 - angle)), angle, 1e-14);
  }
  EXPECT_EQ(AngleAlong(Arc{{0, 0}, 1, 0, 1}, {1, 0}), 0);
}

TEST(Arc, IsWholeFromATurnOnAndEndsWhereItStarts) {
  EXPECT_TRUE(IsWhole(Arc{{0, 0}, 1, 0, -2 * kPi}));
  EXPECT_FALSE(IsWhole(Arc{{0, 0}, 1, 0, 6.28}));
  EXPECT_EQ(SweepOf(Arc{{0, 0}, 1, 0, 9}), 2 * kPi);
  EXPECT_EQ(SweepOf(Arc{{0, 0}, 1, 0, -9}), -2 * kPi);
  EXPECT_EQ(SweepOf(Arc{{0, 0}, 1, 0, -1}), -1);
}

}  // namespace
}  // namespace moontrace

#include "sim/learn/learn_way.h"

#include <gtest/gtest.h>

#include <numbers>

#include "sim/learn/learn_messages.h"

namespace moontrace {
namespace {

IntendedStroke Stroke(std::vector<Piece> pieces) {
  IntendedStroke stroke;
  stroke.spine_P = std::move(pieces);
  stroke.width = 0.001;
  return stroke;
}

TEST(LearnWay, TellsAnLAsDownThenRight) {
  const auto lines = say::WayInWords({Stroke({Line{{0, 1}, {0, 0}}, Line{{0, 0}, {1, 0}}})});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "One stroke: from top left, down, right, to bottom right.");
}

TEST(LearnWay, TellsRingsBendsAndDots) {
  const IntendedStroke ring = Stroke({Arc{{0, 0}, 1, std::numbers::pi / 2, -2 * std::numbers::pi}});
  EXPECT_EQ(say::WayInWords({ring})[0],
            "One stroke: from top middle, a ring clockwise, to top middle.");
  const IntendedStroke bow = Stroke({Arc{{0, 0}, 1, std::numbers::pi, std::numbers::pi}});
  EXPECT_EQ(say::WayInWords({bow})[0],
            "One stroke: from top left, a bend anticlockwise right, to top right.");
  IntendedStroke dot = Stroke({Line{{-1, -1}, {-1, -1}}});
  dot.kind = StrokeKind::kDot;
  EXPECT_EQ(say::WayInWords({ring, dot})[1], "Stroke 2 of 2: a dot, bottom left.");
}

TEST(LearnWay, PiecesThatGoOnInTheSameMannerAreOne) {
  const auto ways = WaysOf({Stroke({Line{{0, 0}, {0, 1}}, Line{{0, 1}, {0, 2}}})});
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_EQ(ways[0].pieces.size(), 1U);
  EXPECT_EQ(ways[0].pieces[0].eighth, 2);
  EXPECT_TRUE(WaysOf({}).empty());
}

}  // namespace
}  // namespace moontrace

#include "sim/learn/learn_path.h"

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

TEST(LearnPath, TellsAnLAsDownThenRight) {
  const auto lines = say::PathInWords({Stroke({Line{{0, 1}, {0, 0}}, Line{{0, 0}, {1, 0}}})});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "One stroke: from top left, down, right, to bottom right.");
}

TEST(LearnPath, TellsRingsBendsAndDots) {
  const IntendedStroke ring = Stroke({Arc{{0, 0}, 1, std::numbers::pi / 2, -2 * std::numbers::pi}});
  EXPECT_EQ(say::PathInWords({ring})[0],
            "One stroke: from top middle, a ring clockwise, to top middle.");
  const IntendedStroke bow = Stroke({Arc{{0, 0}, 1, std::numbers::pi, std::numbers::pi}});
  EXPECT_EQ(say::PathInWords({bow})[0],
            "One stroke: from top left, a bend anticlockwise right, to top right.");
  IntendedStroke dot = Stroke({Line{{-1, -1}, {-1, -1}}});
  dot.kind = StrokeKind::kDot;
  EXPECT_EQ(say::PathInWords({ring, dot})[1], "Stroke 2 of 2: a dot, bottom left.");
}

TEST(LearnPath, PiecesThatGoOnInTheSameMannerAreOne) {
  const auto paths = PathsOf({Stroke({Line{{0, 0}, {0, 1}}, Line{{0, 1}, {0, 2}}})});
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].pieces.size(), 1U);
  EXPECT_EQ(paths[0].pieces[0].eighth, 2);
  EXPECT_TRUE(PathsOf({}).empty());
}

}  // namespace
}  // namespace moontrace

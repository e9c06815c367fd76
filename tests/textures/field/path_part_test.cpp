#include "textures/field/path_part.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

namespace moontrace {
namespace {

TEST(PathPart, IsItsPiece) {
  const std::vector<Piece> pieces = {Line{{1, 1}, {4, 5}}, Arc{{0, 2}, 2, 1, -1.2},
                                     Arc{{0, 2}, 2, -3, 5}};
  for (const Piece& piece : pieces) {
    const PathPart part = PartOf(piece, 7);
    EXPECT_EQ(part.offset, 7);
    EXPECT_EQ(part.length, Length(piece));
    for (const double share : {0.0, 0.3, 1.0}) {
      const double s = share * part.length;
      EXPECT_NEAR(glm::distance(PointAt(part, s), PointAt(piece, s)), 0, 1e-14);
      EXPECT_NEAR(glm::distance(TangentAt(part, s), TangentAt(piece, s)), 0, 1e-14);
    }
  }
}

TEST(PathPart, OfAnArcKnowsTheAngleOfAPoint) {
  const PathPart arc = PartOf(Arc{{3, 2}, 2, 1, -1.5}, 0);
  for (const double angle : {0.2, 1.4}) {
    const glm::dvec2 p = arc.anchor + 5.0 * DirectionOf(1 - angle);
    EXPECT_NEAR(AngleTo(arc, p), angle, 1e-14);
    EXPECT_NEAR(glm::distance(PointAtAngle(arc, angle), arc.anchor + 2.0 * DirectionOf(1 - angle)),
                0, 1e-14);
  }
}

TEST(PathPart, OfADotHasADirection) {
  const PathPart dot = PartOf(Line{{1, 2}, {1, 2}}, 0);
  EXPECT_EQ(dot.length, 0);
  EXPECT_EQ(PointAt(dot, 0), glm::dvec2(1, 2));
  EXPECT_EQ(TangentAt(dot, 0), glm::dvec2(1, 0));
}

}  // namespace
}  // namespace moontrace

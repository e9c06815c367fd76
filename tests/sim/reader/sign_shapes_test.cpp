#include "sim/reader/sign_shapes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "textures/base/random.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

// A turned sign lies as far from a turned point as the sign from the point: to a cell of its table.
TEST(SignShapes, TurnedSignsAreTheSameSigns) {
  const Script script = FindScript("moon");
  const SignShapes shapes(script, WrittenGlyphs(script));
  Random random(1);
  for (const LinesRun lines : {LinesRun::kLeft, LinesRun::kDown}) {
    const SignShapes along = shapes.AlongLines(lines);
    ASSERT_EQ(along.size(), shapes.size());
    for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
      const double right = shapes.Bounds(sign).max.x;
      for (int i = 0; i < 50; ++i) {
        const glm::dvec2 p(1.4 * random.Uniform() - 0.2, 1.4 * random.Uniform() - 0.2);
        const glm::dvec2 turned = lines == LinesRun::kLeft
                                      ? glm::dvec2(right - p.x, p.y)
                                      : glm::dvec2(1 - p.y, p.x + (1 - right) / 2);
        EXPECT_NEAR(along.Distance(sign, turned), shapes.Distance(sign, p), 2 / SignShapes::kPerEm);
      }
      for (const SignPoint& point : along.Points(sign)) {
        // the floor of a dot lies within its outline
        EXPECT_LT(along.Distance(sign, point.p), 0.06 + 2 / SignShapes::kPerEm);
        EXPECT_NEAR(glm::length(point.tangent), 1, 1e-9);
      }
    }
  }
}

TEST(SignShapes, ToTheRightTheyAreAsTheyAre) {
  const Script script = FindScript("moon");
  const SignShapes shapes(script, WrittenGlyphs(script));
  const SignShapes along = shapes.AlongLines(LinesRun::kRight);
  for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
    EXPECT_EQ(along.Advance(sign), shapes.Advance(sign));
    EXPECT_EQ(along.TableOf(sign).cells, shapes.TableOf(sign).cells);
    EXPECT_EQ(shapes.OriginAlongLines(sign, LinesRun::kRight), glm::dvec2(0, 0));
  }
}

}  // namespace
}  // namespace moontrace

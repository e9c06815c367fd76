// The shipped script of shapes, textures/scripts/shapes.svg.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "textures/field/element.h"
#include "textures/fonts/script.h"
#include "textures/fonts/script_check.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

TEST(ShapesScript, HasNothingThatIsHardToTraceAtTheSizesOfLessons) {
  const Script shapes = FindScript("shapes");
  for (const double size : {0.040, 0.025}) {
    CheckSize check;
    check.size = size;
    check.groove = DefaultStyle(size, Relief::kEngraved, shapes).width;
    for (std::size_t glyph = 0; glyph < shapes.glyphs.size(); ++glyph) {
      EXPECT_TRUE(CheckGlyph(shapes, glyph, check).empty())
          << shapes.glyphs[glyph].name << " at " << size;
    }
  }
}

TEST(ShapesScript, SharesNoCharacterWithMoon) {
  const Script moon = FindScript("moon");
  for (const auto& [character, name] : FindScript("shapes").signs) {
    EXPECT_EQ(moon.signs.count(character), 0U) << name;
    EXPECT_EQ(moon.folds.count(character), 0U) << name;
  }
}

TEST(ShapesScript, EachShapeIsOneWayButTheLineWithGaps) {
  for (const Glyph& glyph : FindScript("shapes").glyphs) {
    EXPECT_EQ(glyph.strokes.size(), glyph.name == "gapped" ? 3U : 1U) << glyph.name;
  }
}

double LengthOf(const Script& script, const std::string& name) {
  double length = 0;
  for (const Stroke& stroke : script.glyphs.at(script.Find(name)).strokes) {
    for (const Piece& piece : stroke.pieces) length += Length(piece);
  }
  return length;
}

TEST(ShapesScript, HasTheLengthsOfItsGeometry) {
  const Script shapes = FindScript("shapes");
  constexpr double kPi = std::numbers::pi;
  const double tolerance = 1e-6;  // four decimals of a thousandth em are written in the file
  EXPECT_NEAR(LengthOf(shapes, "level"), 1, tolerance);
  EXPECT_NEAR(LengthOf(shapes, "rising"), std::sqrt(2.0), tolerance);
  EXPECT_NEAR(LengthOf(shapes, "ring"), kPi, tolerance);
  EXPECT_NEAR(LengthOf(shapes, "hill"), kPi / 2, tolerance);
  EXPECT_NEAR(LengthOf(shapes, "wave"), kPi, tolerance);
  EXPECT_NEAR(LengthOf(shapes, "square"), 4, tolerance);
  EXPECT_NEAR(LengthOf(shapes, "gapped"), 2.1, tolerance);
  // A ring of radius r, three quarters of it travelled, on two slants that meet 0.3 em up: the
  // tangent points lie r from the crossing, and r (1 + sqrt 2) = 0.7.
  const double r = 0.7 / (1 + std::sqrt(2.0));
  EXPECT_NEAR(LengthOf(shapes, "loop"), 1.5 * kPi * r + 2 * (0.3 * std::sqrt(2.0) + r), tolerance);
}

}  // namespace
}  // namespace moontrace

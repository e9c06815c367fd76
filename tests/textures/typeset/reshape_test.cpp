#include "textures/typeset/reshape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTolerance = 0.001;  // of the refit [em]

double DistanceTo(const std::vector<Piece>& pieces, glm::dvec2 p) {
  double least = HUGE_VAL;
  for (const Piece& piece : pieces) least = std::min(least, DistanceTo(piece, p));
  return least;
}

// A circle of radius 0.4 about (0.5, 0.5) becomes an ellipse; its points by the map itself.
TEST(Reshaped, RingBecomesTheEllipseWithinTheTolerance) {
  Script script = SmallScript();
  script.glyphs[0].strokes = {
      {StrokeKind::kStroke, {Arc{{0.5, 0.5}, 0.4, 0.3, 2 * std::numbers::pi}}}};
  for (const LetterForm& form : {LetterForm{20 * kDegree, 1.5}, LetterForm{-30 * kDegree, 0.5}}) {
    const Script reshaped = Reshaped(script, form);
    const auto& pieces = reshaped.glyphs[0].strokes[0].pieces;
    const double fixed = form.slant < 0 ? 1 : 0;
    for (int i = 0; i < 720; ++i) {
      const double angle = i * kDegree / 2;
      const glm::dvec2 on(0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle));
      const glm::dvec2 p(form.stretch * on.x + std::tan(form.slant) * (on.y - fixed), on.y);
      EXPECT_LT(DistanceTo(pieces, p), kTolerance);
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& next = pieces[(i + 1) % pieces.size()];
      EXPECT_LT(glm::distance(EndOf(pieces[i]), StartOf(next)), 1e-12);  // closed, no gaps
    }
  }
}

TEST(Reshaped, LineAndAdvanceFollowTheMapExactly) {
  const Script reshaped = Reshaped(SmallScript(), {30 * kDegree, 2});
  EXPECT_DOUBLE_EQ(reshaped.glyphs[0].advance, 2);
  EXPECT_DOUBLE_EQ(reshaped.space_advance, 2);
  // The upright from (0.5, 0) to (0.5, 1): its foot doubled, its top further right by tan 30.
  const Line line = std::get<Line>(reshaped.glyphs[0].strokes[0].pieces[0]);
  EXPECT_NEAR(line.from.x, 1, 1e-15);
  EXPECT_NEAR(line.to.x, 1 + 1 / std::sqrt(3.0), 1e-15);
  EXPECT_EQ(line.to.y, 1);
}

TEST(Reshaped, LettersThatLeanLeftKeepTheirTopsAndReachNoFurtherBack) {
  const Script reshaped = Reshaped(FindScript("moon"), {-30 * kDegree, 1});
  for (const Glyph& glyph : reshaped.glyphs) {
    for (const Stroke& stroke : glyph.strokes) {
      for (const Piece& piece : stroke.pieces) {
        if (BoundsOf(piece).max.y <= 1 + kTolerance) {
          EXPECT_GT(BoundsOf(piece).min.x, -0.01) << glyph.name;
        }
      }
    }
  }
}

TEST(Reshaped, DotsMoveAndStayRound) {
  Script script = SmallScript();
  const Arc dot{{0.5, 0.8}, 0.07, 0, 2 * std::numbers::pi};
  script.glyphs[0].strokes = {{StrokeKind::kDot, {dot}}};
  const Script reshaped = Reshaped(script, {10 * kDegree, 1.4});
  const Arc moved = std::get<Arc>(reshaped.glyphs[0].strokes[0].pieces.at(0));
  EXPECT_EQ(moved.radius, dot.radius);
  EXPECT_EQ(moved.sweep, dot.sweep);
  EXPECT_NEAR(moved.center.x, 1.4 * 0.5 + std::tan(10 * kDegree) * 0.8, 1e-15);
  EXPECT_EQ(moved.center.y, 0.8);
}

TEST(Reshaped, UprightLettersOfWidthOneAreTheScriptItself) {
  const Script script = FindScript("moon");
  const Script same = Reshaped(script, {});
  ASSERT_EQ(same.glyphs.size(), script.glyphs.size());
  for (std::size_t i = 0; i < same.glyphs.size(); ++i) {
    ASSERT_EQ(same.glyphs[i].strokes.size(), script.glyphs[i].strokes.size());
    for (std::size_t j = 0; j < same.glyphs[i].strokes.size(); ++j) {
      EXPECT_EQ(same.glyphs[i].strokes[j].pieces, script.glyphs[i].strokes[j].pieces);
    }
  }
}

TEST(Reshaped, RefusesBrailleAndFormsBeyondBounds) {
  Script braille = SmallScript();
  braille.braille_tables[1] = "en-ueb-g1.ctb";
  EXPECT_THROW(Reshaped(braille, {0.1, 1}), InputError);
  EXPECT_NO_THROW(Reshaped(braille, {}));
  EXPECT_THROW(Reshaped(SmallScript(), {31 * kDegree, 1}), InputError);
  EXPECT_THROW(Reshaped(SmallScript(), {0, 0.4}), InputError);
  EXPECT_THROW(Reshaped(SmallScript(), {NAN, 1}), InputError);
}

}  // namespace
}  // namespace moontrace

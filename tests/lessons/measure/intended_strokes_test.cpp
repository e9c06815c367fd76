#include "lessons/measure/intended_strokes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;

Script TwoSigns() {
  Script script;
  Glyph roof;  // the letter A of the reference
  roof.strokes.push_back({StrokeKind::kStroke, {Line{{0, 0}, {0.5, 1}}, Line{{0.5, 1}, {1, 0}}}});
  Glyph numeral;  // bar and dot
  numeral.strokes.push_back({StrokeKind::kStroke, {Line{{0, 0.5}, {1, 0.5}}}});
  numeral.strokes.push_back({StrokeKind::kDot, {Arc{{0.5, 0}, 0.11, 0, 2 * kPi}}});
  script.glyphs = {roof, numeral};
  return script;
}

TEST(IntendedStrokes, StandWhereTheGlyphsStandInWritingOrder) {
  TextPage page;
  page.glyphs.resize(2);
  page.glyphs[0].glyph = 1;
  page.glyphs[0].origin_P = {0.02, 0.10};
  page.glyphs[1].glyph = 0;
  page.glyphs[1].origin_P = {0.04, 0.10};
  TypeStyle style;
  style.size = 0.01;
  style.width = 0.0012;
  const auto strokes = IntendedStrokes(page, TwoSigns(), style);
  ASSERT_EQ(strokes.size(), 3u);
  EXPECT_EQ(strokes[0].glyph, 0u);
  EXPECT_EQ(strokes[1].glyph, 0u);
  EXPECT_EQ(strokes[2].glyph, 1u);
  EXPECT_EQ(strokes[1].kind, StrokeKind::kDot);
  for (const IntendedStroke& stroke : strokes) EXPECT_EQ(stroke.width, 0.0012);

  const auto expect_near = [](glm::dvec2 a, glm::dvec2 b) { EXPECT_LT(glm::length(a - b), 1e-15); };
  expect_near(StartOf(strokes[0].spine_P.at(0)), {0.02, 0.105});
  expect_near(EndOf(strokes[0].spine_P.at(0)), {0.03, 0.105});
  expect_near(StartOf(strokes[1].spine_P.at(0)), {0.025, 0.10});  // the dot's centre
  EXPECT_EQ(Length(strokes[1].spine_P.at(0)), 0);
  ASSERT_EQ(strokes[2].spine_P.size(), 2u);
  expect_near(EndOf(strokes[2].spine_P[0]), {0.045, 0.11});
  expect_near(EndOf(strokes[2].spine_P[1]), {0.05, 0.10});
}

TEST(IntendedStrokes, AreNoneOfARunningHead) {
  TextPage page;
  page.glyphs.resize(2);
  page.glyphs[0].kind = LineKind::kHead;
  page.glyphs[1].glyph = 1;
  TypeStyle style;
  style.size = 0.01;
  const auto strokes = IntendedStrokes(page, TwoSigns(), style);
  ASSERT_EQ(strokes.size(), 2u);
  for (const IntendedStroke& stroke : strokes) EXPECT_EQ(stroke.glyph, 1u);
}

TEST(IntendedStrokes, OfAFillKeepItsOutline) {
  Script script;
  Glyph square;
  square.strokes.push_back(
      {StrokeKind::kFill,
       {Line{{0, 0}, {1, 0}}, Line{{1, 0}, {1, 1}}, Line{{1, 1}, {0, 1}}, Line{{0, 1}, {0, 0}}}});
  script.glyphs = {square};
  TextPage page;
  page.glyphs.resize(1);
  page.glyphs[0].origin_P = {0.02, 0.10};
  TypeStyle style;
  style.size = 0.01;
  const auto strokes = IntendedStrokes(page, script, style);
  ASSERT_EQ(strokes.size(), 1u);
  ASSERT_EQ(strokes[0].outline_P.size(), 4u);
  EXPECT_LT(glm::distance(StartOf(strokes[0].outline_P[2]), glm::dvec2(0.03, 0.11)), 1e-15);
}

}  // namespace
}  // namespace moontrace

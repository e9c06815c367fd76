#include "textures/fonts/svg_font_writer.h"
#include "tests/textures/stroke_distance.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "tests/source_path.h"
#include "textures/base/text_file.h"
#include "textures/fonts/foreign_font.h"
#include "textures/fonts/hershey.h"
#include "textures/fonts/kanjivg.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

Script Again(const Script& script) {
  return ParseScript(WriteSvgFont(script), script.name + ".svg", WriteRules(script), "a.toml");
}

void ExpectSameGlyphs(const Script& one, const Script& other, double tolerance) {
  ASSERT_EQ(one.glyphs.size(), other.glyphs.size());
  for (std::size_t g = 0; g < one.glyphs.size(); ++g) {
    const Glyph &a = one.glyphs[g], &b = other.glyphs[g];
    EXPECT_EQ(a.name, b.name);
    EXPECT_NEAR(a.advance, b.advance, tolerance);
    ASSERT_EQ(a.strokes.size(), b.strokes.size()) << a.name;
    for (std::size_t s = 0; s < a.strokes.size(); ++s) {
      EXPECT_EQ(a.strokes[s].kind, b.strokes[s].kind) << a.name;
      EXPECT_LE(DistanceOf(a.strokes[s], b.strokes[s]), tolerance) << a.name;
      EXPECT_LE(DistanceOf(b.strokes[s], a.strokes[s]), tolerance) << a.name;
      EXPECT_LE(
          glm::length(StartOf(a.strokes[s].pieces.front()) - StartOf(b.strokes[s].pieces.front())),
          tolerance)
          << a.name;  // travelled the same way
    }
  }
}

// Four decimals of a thousandth of an em, and what that does to an arc's centre.
constexpr double kRounding = 1e-5;

TEST(WriteSvgFont, MoonComesBackWithAllItsRules) {
  const Script moon = FindScript("moon");
  const Script again = Again(moon);
  ExpectSameGlyphs(moon, again, kRounding);
  EXPECT_EQ(again.title, moon.title);
  EXPECT_EQ(again.author, moon.author);
  EXPECT_EQ(again.licence, moon.licence);
  EXPECT_EQ(again.signs, moon.signs);
  EXPECT_EQ(again.digits, moon.digits);
  EXPECT_EQ(again.numeral_sign, moon.numeral_sign);
  EXPECT_EQ(again.folds, moon.folds);
  EXPECT_EQ(again.forms, moon.forms);
  EXPECT_EQ(again.older_punctuation.short_stop, moon.older_punctuation.short_stop);
  EXPECT_EQ(again.older_punctuation.serves, moon.older_punctuation.serves);
  EXPECT_EQ(again.older_punctuation.abbreviations, moon.older_punctuation.abbreviations);
  EXPECT_EQ(again.grades, moon.grades);
  EXPECT_EQ(again.protect_mark, moon.protect_mark);
  EXPECT_DOUBLE_EQ(again.stroke_width, moon.stroke_width);
  EXPECT_DOUBLE_EQ(again.size, moon.size);
  EXPECT_DOUBLE_EQ(again.line_pitch, moon.line_pitch);
  EXPECT_DOUBLE_EQ(again.space_advance, moon.space_advance);
  ASSERT_EQ(again.contractions.size(), moon.contractions.size());
  for (std::size_t i = 0; i < moon.contractions.size(); ++i) {
    EXPECT_EQ(again.contractions[i].print, moon.contractions[i].print);
    EXPECT_EQ(again.contractions[i].signs, moon.contractions[i].signs);
    EXPECT_EQ(again.contractions[i].grade, moon.contractions[i].grade);
    EXPECT_EQ(again.contractions[i].where, moon.contractions[i].where);
  }
}

TEST(WriteSvgFont, BrailleComesBackWithItsTables) {
  const Script braille = FindScript("braille");
  const Script again = Again(braille);
  ExpectSameGlyphs(braille, again, kRounding);
  EXPECT_EQ(again.braille_tables, braille.braille_tables);
  EXPECT_DOUBLE_EQ(again.depth, braille.depth);
  EXPECT_DOUBLE_EQ(again.size, braille.size);
}

TEST(WriteSvgFont, CharactersAndSpecialNamesComeBack) {
  const Script kanji = LoadKanjiVg(SourcePath("textures/scripts/sample-kanji"), {});
  ExpectSameGlyphs(kanji, Again(kanji), kRounding);
  const std::string path = "/usr/share/hershey-fonts/rowmans.jhf";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "hershey-fonts-data is not installed";
  // Its glyphs go by their characters: & < > " among them.
  const Script rowmans = ParseHershey(ReadTextFile(path, kMaxHersheyBytes), "rowmans", path);
  const Script again = Again(rowmans);
  ExpectSameGlyphs(rowmans, again, kRounding);
  EXPECT_EQ(again.signs, rowmans.signs);
}

TEST(WriteSvgFont, ArcsStayArcs) {
  Script script = FindScript("moon");
  script.glyphs.resize(1);
  script.glyphs[0].strokes = {
      {StrokeKind::kStroke, {Arc{{0.5, 0.5}, 0.4, 0.3, 1.7 * std::numbers::pi}}}};
  script.signs = {{U'a', script.glyphs[0].name}};
  script.digits.clear();
  script.contractions.clear();
  script.forms.clear();
  const Script again = Again(script);
  ASSERT_EQ(again.glyphs.at(0).strokes.at(0).pieces.size(), 1U);
  const Arc& arc = std::get<Arc>(again.glyphs[0].strokes[0].pieces[0]);
  EXPECT_LT(glm::length(arc.center - glm::dvec2(0.5, 0.5)), kRounding);
  EXPECT_NEAR(arc.radius, 0.4, kRounding);
  EXPECT_NEAR(arc.sweep, 1.7 * std::numbers::pi, 1e-4);
}

/// A font of one sign with this path, in units of a thousandth of an em.
Script FontOf(const std::string& path) {
  const std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"><defs><font horiz-adv-x=\"600\">"
      "<font-face units-per-em=\"1000\"/><glyph unicode=\"a\" horiz-adv-x=\"600\" d=\"" +
      path + "\"/></font></defs></svg>";
  return ParseForeignFont(svg, "flat.svg");
}

TEST(WriteSvgFont, NearlyStraightCurvesAreReadAgain) {
  // Fitted by arcs of more than 100 em, which no path may name.
  for (const char* path : {"M0 0 C 100 0.01 200 0 300 0.02", "M400 0 C 1 2 3 4 5 6",
                           "M0 0 C 300 3 600 3 900 0", "M-9000 0 C -3000 90 3000 90 9000 0"}) {
    const Script flat = FontOf(path);
    ExpectSameGlyphs(flat, Again(flat), 0.001);
  }
}

TEST(JoinStrokes, MakesOneOfStrokesThatFollowEachOtherAndLeavesOthers) {
  const Stroke one{StrokeKind::kStroke, {Line{{0, 0}, {1, 0}}}};
  const Stroke on{StrokeKind::kStroke, {Line{{1.001, 0}, {1, 1}}}};
  const Stroke apart{StrokeKind::kStroke, {Line{{0, 1}, {0.5, 1}}}};
  const Stroke dot{StrokeKind::kDot, {Arc{{0.5, 1}, 0.1, 0, 2 * std::numbers::pi}}};
  Glyph glyph{"a", 1, {one, on, apart, dot}};
  JoinStrokes(glyph, 0.01);
  ASSERT_EQ(glyph.strokes.size(), 3U);
  EXPECT_EQ(glyph.strokes[0].pieces.size(), 3U);  // with the line that closes the gap
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    EXPECT_LT(
        glm::length(EndOf(glyph.strokes[0].pieces[i]) - StartOf(glyph.strokes[0].pieces[i + 1])),
        1e-12);
  }
  Glyph ring{"o",
             1,
             {{StrokeKind::kStroke, {Arc{{0, 0}, 1, 0, 2 * std::numbers::pi}}},
              {StrokeKind::kStroke, {Line{{1, 0}, {2, 0}}}}}};
  JoinStrokes(ring, 0.01);
  EXPECT_EQ(ring.strokes.size(), 2U);
}

}  // namespace
}  // namespace moontrace

#include "textures/fonts/kanjivg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "tests/source_path.h"
#include "tests/textures/stroke_distance.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

const std::string kFolder = SourcePath("textures/scripts/sample-kanji");

std::string Svg(const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + inside + "\n</svg>";
}

std::string ErrorOf(const std::string& svg) {
  try {
    ParseKanjiVg(svg, "04e00.svg");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseKanjiVg, FillsTheEmBoxWithYUp) {
  const std::vector<Stroke> strokes = ParseKanjiVg(Svg("<path d=\"M0,109 L109,0\"/>"), "a.svg");
  ASSERT_EQ(strokes.size(), 1U);
  const Line& line = std::get<Line>(strokes[0].pieces.at(0));
  EXPECT_LT(glm::length(line.from), 1e-12);
  EXPECT_LT(glm::length(line.to - glm::dvec2(1, 1)), 1e-12);
}

TEST(ParseKanjiVg, MirrorsArcsWithoutMovingTheirEnds) {
  const std::vector<Stroke> strokes =
      ParseKanjiVg(Svg("<path d=\"M54.5,0 A54.5 54.5 0 0 1 109,54.5\"/>"), "a.svg");
  const Piece& arc = strokes.at(0).pieces.at(0);
  EXPECT_LT(glm::length(StartOf(arc) - glm::dvec2(0.5, 1)), 1e-12);
  EXPECT_LT(glm::length(EndOf(arc) - glm::dvec2(1, 0.5)), 1e-12);
  EXPECT_LT(glm::length(PointAt(arc, Length(arc) / 2) - (0.5 + 0.5 * std::sqrt(0.5))), 1e-9);
}

TEST(ParseKanjiVg, OrdersStrokesByTheirNumbersNotTheirPlace) {
  const std::vector<Stroke> strokes = ParseKanjiVg(
      Svg("<g><path id=\"kvg:04e8c-s10\" d=\"M0,0L10,0\"/><g><path id=\"kvg:04e8c-s2\" "
          "d=\"M0,0L20,0\"/></g></g><path id=\"kvg:04e8c-s1\" d=\"M0,0L30,0\"/>"
          "<g><text transform=\"matrix(1 0 0 1 4 5)\">1</text></g>"),
      "a.svg");
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_NEAR(Length(strokes[0].pieces.at(0)), 30.0 / 109, 1e-12);
  EXPECT_NEAR(Length(strokes[1].pieces.at(0)), 20.0 / 109, 1e-12);
  EXPECT_NEAR(Length(strokes[2].pieces.at(0)), 10.0 / 109, 1e-12);
}

TEST(ParseKanjiVg, KeepsCurvesWithinThePathInTheFile) {
  // The sweeps of the sample drawing, evaluated here as Bezier curves: box 109, y down.
  const glm::dvec2 p[2][4] = {{{54.5, 38}, {48, 58}, {34, 74}, {12, 86}},
                              {{54.5, 38}, {61, 58}, {75, 74}, {97, 86}}};
  const Script script = LoadKanjiVg(kFolder, {U'\u6728'});
  ASSERT_EQ(script.glyphs.size(), 1U);
  ASSERT_EQ(script.glyphs[0].strokes.size(), 4U);
  for (int curve = 0; curve < 2; ++curve) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 200; ++i) {
      const double t = i / 200.0, s = 1 - t;
      const glm::dvec2 at = s * s * s * p[curve][0] + 3 * s * s * t * p[curve][1] +
                            3 * s * t * t * p[curve][2] + t * t * t * p[curve][3];
      points.emplace_back(at.x / 109, 1 - at.y / 109);
    }
    EXPECT_LE(DistanceOf(script.glyphs[0].strokes[2 + static_cast<std::size_t>(curve)], points),
              kGlyphTolerance);
  }
}

TEST(ParseKanjiVg, NamesWhatIsWrong) {
  EXPECT_EQ(ErrorOf(Svg("<g/>")), "04e00.svg:1:1: no stroke is drawn; get the file again");
  EXPECT_EQ(ErrorOf(Svg("<path d=\"M0,0 Lnan,1\"/>")),
            "04e00.svg:2:16: 'nan' is no finite number; write one");
  EXPECT_EQ(ErrorOf("<html/>"),
            "04e00.svg:1:1: the document is not <svg>; give a character of "
            "KanjiVG");
  EXPECT_EQ(ErrorOf("\xFF\xFE<\0s\0"), "04e00.svg:1:1: this is UTF-16; save it as UTF-8");
  EXPECT_EQ(ErrorOf(Svg("<!-- \xE9t\xE9 --><path d=\"M0,0L1,1\"/>")),
            "04e00.svg:2:6: this is not UTF-8; save it as UTF-8");
}

TEST(LoadKanjiVg, ReadsOnlyWhatIsNeeded) {
  EXPECT_TRUE(IsKanjiVgFolder(kFolder));
  EXPECT_FALSE(IsKanjiVgFolder(SourcePath("tests/data/hanzi")));
  EXPECT_EQ(LoadKanjiVg(kFolder, {}).glyphs.size(), 7U);
  const Script script = LoadKanjiVg(kFolder, {U'\u65e5', U'\u6728', U'\u9f8d'});
  ASSERT_EQ(script.glyphs.size(), 2U);
  EXPECT_EQ(script.glyphs[0].name, "\u65e5");
  EXPECT_EQ(script.glyphs[0].advance, 1.0);
  EXPECT_EQ(script.licence, "CC0-1.0");  // the folder's own word
}

TEST(LoadKanjiVg, SaysWhenNoneOfTheTextIsThere) {
  try {
    LoadKanjiVg(kFolder, {U'\u9f8d'});
    FAIL() << "loaded nothing without a word";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), kFolder + ": has no sign for '\u9f8d'; use another text or script");
  }
}

TEST(LoadKanjiVg, SetsTextWithoutSpacesOneCharacterAnEm) {
  const Script script = LoadKanjiVg(kFolder, {});
  const TypeStyle style = DefaultStyle(0.02, Relief::kEngraved, script);
  const PageSpec page{"custom", 0.085, 0.120, 0.010};  // room for three characters a line
  const Typeset set = SetText("\u65e5\u6728\u4e00\u4e8c\u4e09", script, style, page);
  ASSERT_EQ(set.pages.size(), 1U);
  ASSERT_EQ(set.pages[0].glyphs.size(), 5U);
  EXPECT_EQ(set.pages[0].lines, 2U);
  EXPECT_NEAR(set.pages[0].glyphs[1].origin_P.x - set.pages[0].glyphs[0].origin_P.x, 0.02, 1e-12);
  EXPECT_EQ(set.pages[0].glyphs[3].line, 1U);
}

}  // namespace
}  // namespace moontrace

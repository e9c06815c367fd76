#include "textures/fonts/foreign_font.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "textures/base/error.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

std::string FontOf(const std::string& glyphs, const std::string& face = "units-per-em=\"1000\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\">"
         "<metadata>Drawn by\n  A. Person, CC0</metadata><defs>"
         "<font id=\"f\" horiz-adv-x=\"1200\">\n<font-face font-family=\"Strokes\" " +
         face + "/>\n<missing-glyph horiz-adv-x=\"500\" d=\"M0 0H500V500Z\"/>\n" + glyphs +
         "\n</font></defs></svg>\n";
}

Script FontWith(const std::string& glyphs) { return ParseForeignFont(FontOf(glyphs), "b/a.svg"); }

std::string ErrorOf(const std::string& svg) {
  try {
    ParseForeignFont(svg, "a.svg");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

double LengthOf(const Glyph& glyph) {
  double length = 0;
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) length += Length(piece);
  }
  return length;
}

TEST(ParseForeignFont, TakesSignsFromTheUnicodeAttributesAndItsWordsFromTheFont) {
  const Script script = FontWith(
      "<glyph unicode=\" \" horiz-adv-x=\"700\"/>"
      "<glyph unicode=\"a\" glyph-name=\"alpha\" d=\"M0 0L500 0\"/>"
      "<glyph unicode=\"A\" d=\"M0 0L900 0\"/>");
  EXPECT_EQ(script.name, "a");
  EXPECT_EQ(script.title, "Strokes");
  EXPECT_EQ(script.author, "Drawn by A. Person, CC0");
  EXPECT_DOUBLE_EQ(script.space_advance, 0.7);
  ASSERT_EQ(script.glyphs.size(), 2U);  // the missing-glyph is no sign
  EXPECT_EQ(script.signs.at(U'a'), "alpha");
  EXPECT_EQ(script.signs.at(U'A'), "A");
  const TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  const Typeset set = SetText("aA a?", script, style, FindPage("a4"));
  EXPECT_EQ(set.pages.at(0).glyphs.size(), 3U);
  EXPECT_EQ(set.missing_count, 1U);  // told, not drawn as a box
}

TEST(ParseForeignFont, TakesCapHeightThenAscentThenUnitsPerEmThenAThousandAsTheEm) {
  const std::string glyph = "<glyph unicode=\"a\" d=\"M0 0L700 0\"/>";
  for (const auto& [face, em] :
       {std::pair{"units-per-em=\"2048\"", 2048.0}, std::pair{"", 1000.0},  // as SVG 1.1 says
        std::pair{"units-per-em=\"1000\" ascent=\"800\"", 800.0},
        std::pair{"units-per-em=\"1000\" ascent=\"800\" cap-height=\"0\"", 800.0},
        std::pair{"units-per-em=\"1000\" ascent=\"800\" cap-height=\"500\"", 500.0}}) {
    EXPECT_DOUBLE_EQ(LengthOf(ParseForeignFont(FontOf(glyph, face), "a.svg").glyphs.at(0)),
                     700 / em);
  }
}

// Inkscape's fonts have both, and terms of a page behind them.
TEST(ParseForeignFont, KeepsTheWordsAboutItsLicence) {
  const std::string svg = FontOf("<glyph unicode=\"a\" d=\"M0 0L1 1\"/>");
  const std::string terms(2000, 'x'), place = "Drawn by\n  A. Person, CC0";
  std::string licensed = svg;
  licensed.replace(svg.find(place), place.size(),
                   "Font name:  T\n License:   SIL Open Font License\nUse: " + terms + "\n");
  const Script script = ParseForeignFont(licensed, "a.svg");
  EXPECT_EQ(script.licence, "SIL Open Font License");
  EXPECT_EQ(script.author, "Font name: T License: SIL Open Font License Use: " + terms);
  EXPECT_EQ(FontWith("<glyph unicode=\"a\" d=\"M0 0L1 1\"/>").licence, "see the author's words");
}

/// A font of one stem a letter, of these heights.
Script Stems(const std::string& face, const std::vector<std::pair<char, int>>& letters) {
  std::string glyphs;
  for (const auto& [letter, height] : letters) {
    glyphs += std::string("<glyph unicode=\"") + letter + "\" d=\"M0 0V" + std::to_string(height) +
              "\"/>";
  }
  return ParseForeignFont(FontOf(glyphs, face), "a.svg");
}

/// Height of a letter [em].
double HeightOf(char letter, const Script& script) {
  return LengthOf(script.glyphs.at(script.Find(std::string(1, letter))));
}

// Inkscape's Hershey fonts: every one states 500, capitals are 662.
TEST(ParseForeignFont, MeasuresAnEmThatItsCapitalsContradictAndSaysSo) {
  const std::string face = "units-per-em=\"1000\" ascent=\"800\" cap-height=\"500\"";
  const Script inkscape = Stems(face, {{'T', 640}, {'E', 650}, {'H', 662}, {'x', 441}});
  EXPECT_DOUBLE_EQ(HeightOf('H', inkscape), 1);
  EXPECT_DOUBLE_EQ(HeightOf('x', inkscape), 441.0 / 662);
  EXPECT_EQ(inkscape.remarks,
            std::vector<std::string>{
                "Strokes: its cap-height is 500, but its H is 662 high; sized by H."});
  const Script no_h = Stems(face, {{'T', 640}, {'E', 650}, {'x', 441}});
  EXPECT_DOUBLE_EQ(HeightOf('E', no_h), 1);
  const Script no_cap_height = Stems("units-per-em=\"1000\" ascent=\"800\"", {{'H', 662}});
  EXPECT_DOUBLE_EQ(HeightOf('H', no_cap_height), 1);
  EXPECT_EQ(no_cap_height.remarks,
            std::vector<std::string>{"Strokes: its ascent is 800, but its H is 662 high; sized by "
                                     "H."});
}

TEST(ParseForeignFont, BelievesTheFiguresWithinTwoPercentAndWhereASymbolStandsForTheLetter) {
  const std::string face = "units-per-em=\"1000\" cap-height=\"";
  const Script near = Stems(face + "656\"", {{'H', 662}});
  EXPECT_DOUBLE_EQ(HeightOf('H', near), 662.0 / 656);
  EXPECT_TRUE(near.remarks.empty());
  for (const int top : {-100, 90, 3100}) {
    const Script symbol = Stems(face + "500\"", {{'H', top}, {'a', 300}});
    EXPECT_DOUBLE_EQ(HeightOf('a', symbol), 0.6) << top;
    EXPECT_TRUE(symbol.remarks.empty());
  }
}

TEST(ParseForeignFont, ScalesTheCapHeightByTheXOfAFontWithoutCapitals) {
  const std::string face = "units-per-em=\"1000\" cap-height=\"500\" x-height=\"300\"";
  const Script script = Stems(face, {{'x', 450}});  // one and a half times what is stated
  EXPECT_DOUBLE_EQ(HeightOf('x', script), 450.0 / 750);
  EXPECT_EQ(script.remarks, std::vector<std::string>{"Strokes: its x-height is 300, but its x is "
                                                     "450 high; sized by x."});
  EXPECT_DOUBLE_EQ(HeightOf('x', Stems(face, {{'x', 303}})), 303.0 / 500);
}

TEST(ParseForeignFont, WritesGroupsOfCharactersAsOneSign) {
  const Script script = FontWith(
      "<glyph unicode=\"f\" d=\"M0 0L1 0\"/><glyph unicode=\"i\" d=\"M0 0L2 0\"/>"
      "<glyph unicode=\"fi\" glyph-name=\"f_i\" d=\"M0 0L3 0\"/>");
  const TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  const Typeset set = SetText("fif", script, style, FindPage("a4"));
  ASSERT_EQ(set.pages.at(0).glyphs.size(), 2U);
  EXPECT_EQ(script.glyphs.at(set.pages[0].glyphs[0].glyph).name, "f_i");
}

TEST(ParseForeignFont, ForgivesWhatOtherFontsHave) {
  const Script script = FontWith(
      "<glyph d=\"M0 0L1 1\"/>"                                        // no name
      "<glyph unicode=\"x\"/>"                                         // nothing drawn
      "<glyph unicode=\"&#x301;\" horiz-adv-x=\"0\" d=\"M0 0L1 1\"/>"  // a mark above
      "<glyph unicode=\"a\" glyph-name=\"n\" d=\"M0 0L1 0\"/>"         // the first counts
      "<glyph unicode=\"a\" glyph-name=\"n\" d=\"M0 0L2 0\"/><hkern k=\"1\"/>");
  ASSERT_EQ(script.glyphs.size(), 2U);
  EXPECT_EQ(script.glyphs[1].name, "n#2");
  EXPECT_EQ(script.signs, (std::map<char32_t, std::string>{{U'a', "n"}}));
}

TEST(ParseForeignFont, ReadsGroupsUsesAndSimpleShapes) {
  const Script script = FontWith(
      "<glyph unicode=\"a\"><g stroke=\"red\"><path id=\"p\" d=\"M0 0L100 0\"/></g>"
      "<use xlink:href=\"#p\" x=\"10\" y=\"20\"/></glyph>"
      "<glyph unicode=\"b\"><line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"300\"/>"
      "<polyline points=\"0,0 100,0 100,100\"/><polygon points=\"0 0 10 0 10 10\"/></glyph>");
  const Line& used = std::get<Line>(script.glyphs.at(0).strokes.at(1).pieces.at(0));
  EXPECT_LT(glm::length(used.from - glm::dvec2(0.01, 0.02)), 1e-12);
  EXPECT_LT(glm::length(used.to - glm::dvec2(0.11, 0.02)), 1e-12);
  const Glyph& b = script.glyphs.at(1);
  ASSERT_EQ(b.strokes.size(), 3U);
  EXPECT_DOUBLE_EQ(Length(b.strokes[0].pieces.at(0)), 0.3);
  EXPECT_EQ(b.strokes[1].pieces.size(), 2U);
  EXPECT_EQ(b.strokes[2].kind, StrokeKind::kFill);
}

TEST(ParseForeignFont, FollowsEveryPathCommand) {
  // All commands of SVG 1.1 in one path, relative and absolute; each end point counted by hand.
  const Script script = FontWith(
      "<glyph unicode=\"a\" d=\"M0 0 m10 10 L20 10 l0 10 H30 h10 V30 v10 C40 50 50 60 60 60 "
      "c10 0 20 0 30 0 S110 70 110 80 s0 10 10 10 Q130 90 130 100 q0 10 10 10 T160 120 t10 0 "
      "A10 10 0 0 1 180 130 a10 10 0 0 0 10 10 z\"/>"
      "<glyph unicode=\"b\" d=\"M0 0h1\"/>");
  const std::vector<Piece>& pieces = script.glyphs.at(0).strokes.at(0).pieces;
  EXPECT_LT(glm::length(StartOf(pieces.front()) - glm::dvec2(0.01, 0.01)), 1e-9);
  EXPECT_LT(glm::length(EndOf(pieces.back()) - glm::dvec2(0.01, 0.01)), 1e-9);
  EXPECT_LT(glm::length(StartOf(pieces.back()) - glm::dvec2(0.19, 0.14)), 1e-9);
  EXPECT_EQ(script.glyphs[0].strokes[0].kind, StrokeKind::kFill);
}

TEST(ParseForeignFont, RefusesACycleOfUseInOneLine) {
  EXPECT_EQ(
      ErrorOf(FontOf("<glyph unicode=\"a\"><g id=\"g\"><use xlink:href=\"#g\"/></g></glyph>")),
      "a.svg:5:30: <use> of '#g' within itself: a cycle without end; draw it in place");
  EXPECT_EQ(ErrorOf(FontOf("<glyph id=\"a\" unicode=\"a\"><use href=\"#b\"/></glyph>\n"
                           "<glyph id=\"b\" unicode=\"b\"><use href=\"#a\"/></glyph>")),
            "a.svg:6:27: <use> of '#a' within itself: a cycle without end; draw it in place");
  EXPECT_EQ(ErrorOf(FontOf("<glyph unicode=\"a\"><use href=\"o.svg#x\"/></glyph>")),
            "a.svg:5:20: <use> of 'o.svg#x', which is no id of this file; draw it in place");
}

TEST(ParseForeignFont, BoundsUsesThatMultiply) {
  // Each of 30 groups uses the one before ten times: 10^30 paths, were they all drawn.
  std::string groups = "<g id=\"g0\"><path d=\"M0 0L1 1\"/></g>";
  for (int i = 1; i <= 30; ++i) {
    groups += "<g id=\"g" + std::to_string(i) + "\">";
    for (int k = 0; k < 10; ++k) groups += "<use href=\"#g" + std::to_string(i - 1) + "\"/>";
    groups += "</g>";
  }
  const std::string inside =
      ErrorOf(FontOf("<glyph unicode=\"a\">" + groups + "<use href=\"#g30\"/></glyph>"));
  EXPECT_NE(inside.find(": too many path commands; simplify the drawing"), std::string::npos)
      << inside;
}

TEST(ParseForeignFont, NamesNaNWrongEncodingAndEmptyFonts) {
  EXPECT_EQ(ErrorOf(FontOf("<glyph unicode=\"a\" d=\"M0 0LNaN 1\"/>")),
            "a.svg:5:28: 'NaN' is no finite number; write one");
  EXPECT_EQ(ErrorOf(FontOf("<glyph unicode=\"\xE9\" d=\"M0 0L1 1\"/>")),
            "a.svg:5:17: this is not UTF-8; save it as UTF-8");
  EXPECT_EQ(ErrorOf(std::string("\xFF\xFE<\0s\0v\0g\0>\0", 12)),
            "a.svg:1:1: this is UTF-16; save it as UTF-8");
  EXPECT_EQ(ErrorOf(FontOf("<glyph unicode=\"a\"/>")).rfind("a.svg:2:", 0), 0U);
}

}  // namespace
}  // namespace moontrace

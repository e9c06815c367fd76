#include "textures/fonts/svg_font.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "textures/base/error.h"

namespace moontrace {
namespace {

/// A font of one em = 1000 units around the given glyphs, which start on line 3.
std::string FontOf(const std::string& glyphs) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"><defs><font horiz-adv-x=\"1200\">\n"
         "<font-face units-per-em=\"1000\"/>\n" +
         glyphs + "\n</font></defs></svg>\n";
}

Glyph OneGlyph(const std::string& glyph) {
  const SvgFont font = ParseSvgFont(FontOf(glyph), "a.svg");
  EXPECT_EQ(font.glyphs.size(), 1U);
  return font.glyphs.at(0);
}

std::string ErrorOf(const std::string& svg) {
  try {
    ParseSvgFont(svg, "a.svg");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseSvgFont, TakesCapHeightAsTheEmBeforeUnitsPerEm) {
  const std::string glyph = "<glyph glyph-name=\"x\" horiz-adv-x=\"900\" d=\"M0 0L700 0\"/>";
  for (const auto& [face, em] : {std::pair{"units-per-em=\"1000\"", 1000.0},
                                 std::pair{"units-per-em=\"1000\" cap-height=\"700\"", 700.0}}) {
    const SvgFont font = ParseSvgFont(
        std::string("<svg><font><font-face ") + face + "/>" + glyph + "</font></svg>", "a.svg");
    EXPECT_DOUBLE_EQ(font.glyphs.at(0).advance, 900 / em);
    EXPECT_DOUBLE_EQ(Length(font.glyphs.at(0).strokes.at(0).pieces.at(0)), 700 / em);
  }
}

TEST(ParseSvgFont, TellsStrokesDotsAndFillsApart) {
  const Glyph glyph = OneGlyph(
      "<glyph unicode=\"x\" d=\"M0 0L500 0"
      "M600 0A50 50 0 0 1 500 0A50 50 0 0 1 600 0"   // open: a ring
      "M600 0A50 50 0 0 1 500 0A50 50 0 0 1 600 0Z"  // closed circle: a dot
      "M0 0L100 0A50 50 0 0 1 0 0Z\"/>");            // another closed outline
  ASSERT_EQ(glyph.strokes.size(), 4U);
  EXPECT_EQ(glyph.strokes[0].kind, StrokeKind::kStroke);
  EXPECT_EQ(glyph.strokes[1].kind, StrokeKind::kStroke);
  EXPECT_EQ(glyph.strokes[2].kind, StrokeKind::kDot);
  EXPECT_EQ(glyph.strokes[3].kind, StrokeKind::kFill);
  EXPECT_EQ(glyph.strokes[1].pieces.size(), 1U);
  EXPECT_EQ(glyph.name, "x");
  EXPECT_DOUBLE_EQ(glyph.advance, 1.2);  // the font's own default
}

TEST(ParseSvgFont, ReadsChildrenAsEditorsWriteThem) {
  const Glyph glyph = OneGlyph(
      "<glyph glyph-name=\"x\"><title>an x</title><path d=\"M0 0L500 0\"/>"
      "<circle cx=\"100\" cy=\"200\" r=\"110\"/></glyph>");
  ASSERT_EQ(glyph.strokes.size(), 2U);
  EXPECT_EQ(glyph.strokes[1].kind, StrokeKind::kDot);
  const Arc& arc = std::get<Arc>(glyph.strokes[1].pieces.at(0));
  EXPECT_LT(glm::length(arc.center - glm::dvec2(0.1, 0.2)), 1e-12);
  EXPECT_DOUBLE_EQ(arc.radius, 0.11);
}

TEST(ParseSvgFont, KnowsADotThatAnEditorMadeOfFourCubics) {
  // Radius 110 about (200, 300), control points rounded to whole units as editors save them.
  const Glyph glyph = OneGlyph(
      "<glyph glyph-name=\"x\" d=\"M310 300C310 361 261 410 200 410C139 410 90 361 90 300"
      "C90 239 139 190 200 190C261 190 310 239 310 300Z\"/>");
  ASSERT_EQ(glyph.strokes.size(), 1U);
  EXPECT_EQ(glyph.strokes[0].kind, StrokeKind::kDot);
  const Arc& arc = std::get<Arc>(glyph.strokes[0].pieces.at(0));
  EXPECT_LT(glm::length(arc.center - glm::dvec2(0.2, 0.3)), 0.001);
  EXPECT_NEAR(arc.radius, 0.11, 0.001);
}

TEST(ParseSvgFont, BindsCharactersAndLeavesTheEmptySpaceOut) {
  const SvgFont font = ParseSvgFont(FontOf("<glyph unicode=\" \"/><glyph unicode=\"&#xE9;\" "
                                           "glyph-name=\"eacute\" d=\"M0 0L1 1\"/>"),
                                    "a.svg");
  EXPECT_EQ(font.glyphs.size(), 1U);
  EXPECT_EQ(font.characters, (std::map<char32_t, std::string>{{U'\u00e9', "eacute"}}));
}

TEST(ParseSvgFont, SkipsByteOrderMarkCommentsAndDoctype) {
  const std::string svg =
      "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"x\" "
      "[\n"
      "<!ENTITY a SYSTEM \"file:///etc/passwd\">]>\n<!-- c -->" +
      FontOf("<glyph glyph-name=\"&a;\" d=\"M0 0L1 1\"/>");
  // The entity stays as it is written: nothing outside is read.
  EXPECT_EQ(ParseSvgFont(svg, "a.svg").glyphs.at(0).name, "&a;");
}

struct Broken {
  std::string glyphs;
  std::string error;
};

TEST(ParseSvgFont, NamesPlaceCauseAndCureOfABrokenGlyph) {
  const std::string x = "<glyph glyph-name=\"x\" ";
  for (const Broken& broken : {
           Broken{x + "d=\"M0 0B1 1\"/>",
                  "a.svg:3:30: unknown path command 'B1 1'; use M L H V C S Q T A Z"},
           Broken{x + "d=\"M0 0\n L nan 1\"/>", "a.svg:4:4: 'nan' is no finite number; write one"},
           Broken{x + "><path d=\"L1 1\"/></glyph>",
                  "a.svg:3:33: the path starts with 'L'; start with M"},
           Broken{x + "d=\"M0 0L1e400 1\"/>", "a.svg:3:31: '1e400' is no finite number; write one"},
           Broken{x + "d=\"M0 0L100001 1\"/>",
                  "a.svg:3:31: number beyond 100 em; move the drawing to the letter box"},
           Broken{x + "/>", "a.svg:3:1: glyph 'x' has nothing drawn; draw or remove it"},
           Broken{"<glyph d=\"M0 0L1 1\"/>",
                  "a.svg:3:1: a glyph without glyph-name or unicode; name it"},
           Broken{x + "d=\"M0 0L1 1\"/>\n" + x + "d=\"M0 0L1 2\"/>",
                  "a.svg:4:1: second glyph named 'x'; rename or remove one"},
           Broken{x + "horiz-adv-x=\"inf\" d=\"M0 0L1 1\"/>",
                  "a.svg:3:36: horiz-adv-x is 'inf'; give a finite number"},
           Broken{x + "horiz-adv-x=\"-5\" d=\"M0 0L1 1\"/>",
                  "a.svg:3:1: horiz-adv-x of glyph 'x' outside 0 to 100 em; give the step to the "
                  "next letter"},
           Broken{x + "unicode=\"th\" d=\"M0 0L1 1\"/>",
                  "a.svg:3:32: unicode is 'th'; give one character, and put groups of letters into "
                  "the TOML file"},
           Broken{x + "unicode=\"a\" d=\"M0 0L1 1\"/>\n<glyph unicode=\"a\" glyph-name=\"b\" "
                      "d=\"M0 0L1 1\"/>",
                  "a.svg:4:17: second glyph for 'a'; keep one"},
           Broken{x + "><text>x</text></glyph>",
                  "a.svg:3:24: <text> in a glyph is not read; convert it to a path in the editor"},
           Broken{x + "><path transform=\"scale(2)\" d=\"M0 0L1 1\"/></glyph>",
                  "a.svg:3:24: a transform is not read; apply it in the editor"},
           Broken{
               x + "><circle cx=\"1\" cy=\"1\" r=\"0\"/></glyph>",
               "a.svg:3:24: a circle without a radius above 0, or beyond 100 em; correct cx, cy, "
               "r"},
           Broken{"", "a.svg:1:47: a font without glyphs; draw one <glyph> at least"},
       }) {
    EXPECT_EQ(ErrorOf(FontOf(broken.glyphs)), broken.error);
  }
}

TEST(ParseSvgFont, NamesWhatIsWrongWithTheDocument) {
  EXPECT_EQ(ErrorOf("<svg><font>\n<glyph></font></svg>").rfind("a.svg:2:", 0), 0U);
  EXPECT_NE(ErrorOf("<svg><font>\n<glyph></font></svg>").find("broken XML: "), std::string::npos);
  EXPECT_EQ(ErrorOf("<svg><path d=\"M0 0\"/></svg>"),
            "a.svg:1:1: an SVG without a <font>: a drawing, not a script; give an SVG 1.1 font");
  EXPECT_EQ(ErrorOf("<html><body/></html>"),
            "a.svg:1:1: the document is <html>, not <svg>; give an SVG 1.1 font");
  for (const std::string& no_xml :
       {std::string("just a text"), std::string(), std::string("\x89PNG\r\n\x1a\n\0\0\0", 11)}) {
    EXPECT_EQ(ErrorOf(no_xml), "a.svg:1:1: no XML in this file; give an SVG 1.1 font");
  }
  EXPECT_EQ(ErrorOf("<svg><font><glyph d=\"M0 0L1 1\"/></font></svg>"),
            "a.svg:1:6: a font without <font-face>; add one with units-per-em");
  EXPECT_EQ(ErrorOf("<svg><font><font-face/></font></svg>"),
            "a.svg:1:12: neither cap-height nor units-per-em; give one of them");
  EXPECT_EQ(ErrorOf("<svg><font><font-face units-per-em=\"0\"/></font></svg>"),
            "a.svg:1:12: cap-height or units-per-em outside 0.001 to 1000000; use 1000");
}

TEST(ParseSvgFont, BoundsSizeGlyphsAndCommands) {
  EXPECT_EQ(ErrorOf(std::string((std::size_t{64} << 20U) + 1, ' ')),
            "a.svg: holds more than 64 MB; simplify the font");
  std::string many;
  for (int i = 0; i <= 20000; ++i) {
    many += "<glyph glyph-name=\"g" + std::to_string(i) + "\" d=\"M0 0L1 1\"/>";
  }
  EXPECT_NE(ErrorOf(FontOf(many)).find(": more than 20000 glyphs; use fewer"), std::string::npos);
  // A path of 1000 commands used a hundred times.
  std::string used = "<glyph glyph-name=\"x\"><path id=\"p\" d=\"M0 0";
  for (int i = 0; i < 1000; ++i) used += i % 2 == 0 ? "L1 1" : "L1 0";
  used += "\"/>";
  for (int i = 0; i < 100; ++i) used += "<use href=\"#p\"/>";
  EXPECT_NE(ErrorOf(FontOf(used + "</glyph>")).find(": too many path commands; simplify"),
            std::string::npos);
}

TEST(ParseSvgFont, ReadsAsManyCommandsAsTheFileHolds) {
  std::string zigzag = "<glyph glyph-name=\"x\" d=\"M0 0";
  for (int i = 0; i < 300000; ++i) zigzag += i % 2 == 0 ? "L1 1" : "L1 0";
  EXPECT_EQ(ParseSvgFont(FontOf(zigzag + "\"/>"), "a.svg").glyphs.at(0).strokes.size(), 1U);
}

TEST(ParseSvgFont, TakesNumberedCharactersForNamesUnlessAnotherGlyphHasThem) {
  const SvgFont font =
      ParseSvgFont(FontOf("<glyph unicode=\"&quot;\" glyph-name=\"uni0022\" d=\"M0 0L1 1\"/>"
                          "<glyph glyph-name=\"uni0041\" d=\"M0 0L1 1\"/>"
                          "<glyph glyph-name=\"A\" d=\"M0 0L1 1\"/>"),
                   "a.svg");
  EXPECT_EQ(font.glyphs.at(0).name, "\"");
  EXPECT_EQ(font.glyphs.at(1).name, "uni0041");
  EXPECT_EQ(font.characters.at(U'"'), "\"");
}

TEST(ParseSvgFont, BoundsDeepNesting) {
  std::string deep = "<svg>";
  for (int i = 0; i < 1000000; ++i) deep += "<g>";
  EXPECT_NE(ErrorOf(deep).find("broken XML: "), std::string::npos);
}

}  // namespace
}  // namespace moontrace

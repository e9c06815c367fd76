// What is drawn of a page that was read by touch.

#include "sim/recognise/reading_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "sim/picture/moon_marks.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/rules.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// Of a page with raised rules, a margin and links, that nobody has touched yet.
Drawing PictureOf(bool blank) {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.008, Relief::kEngraved, moon);
  style.line_pitch = 0.022;
  style.rules.lines = style.rules.margin = true;
  style.links.reach = LinkReach::kLetters;
  const Typeset set = SetText("no sun", moon, style, PageSpec{"custom", 0.13, 0.06, 0.015});
  return ReadingPicture(set.pages.front(), moon, set.style, blank, "no sun", {});
}

bool Same(const Color& a, const Color& b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

/// Widths of all paths that are stroked in this colour [mm].
std::vector<double> WidthsIn(const Drawing& drawing, const Color& color) {
  std::vector<double> widths;
  for (const Mark& mark : drawing.marks) {
    const auto* path = std::get_if<PathMark>(&mark);
    if (path != nullptr && path->stroke && Same(*path->stroke, color)) {
      widths.push_back(path->width);
    }
  }
  return widths;
}

// They are what a reader who leaves the letters runs into.
TEST(ReadingPicture, ShowsRulesMarginAndLinks) {
  const Drawing drawing = PictureOf(false);
  // a tenth of the size each
  const std::vector<double> ridges = WidthsIn(drawing, palette::kRidge);
  ASSERT_EQ(ridges.size(), 2U);
  EXPECT_NEAR(ridges[0], 0.8, 1e-9);
  EXPECT_NEAR(ridges[1], 0.8, 1e-9);
  EXPECT_EQ(WidthsIn(drawing, palette::kLink).size(), 1U);
  EXPECT_NE(drawing.description.find("Line rules 0.8 mm wide"), std::string::npos);
  EXPECT_GT(drawing.width, 100);  // rules are as long as the text area
}

TEST(ReadingPicture, OfABlankPageHasLettersAloneThatWouldBeThere) {
  const Drawing drawing = PictureOf(true);
  EXPECT_TRUE(WidthsIn(drawing, palette::kRidge).empty());
  EXPECT_TRUE(WidthsIn(drawing, palette::kLink).empty());
  EXPECT_EQ(drawing.description.find("Line rules"), std::string::npos);
}

/// A page whose first sign was read where it stands.
Drawing FirstRead(const char* name, bool rules, double probability = 1) {
  const Script script = FindScript(name);
  TypeStyle style = DefaultStyle(script.size, Relief::kEngraved, script);
  style.rules.lines = rules;
  const Typeset set = SetText("lu", script, style, FindPage("120x60"));
  const PlacedGlyph& first = set.pages.front().glyphs.front();
  ReadToken token;
  token.glyph = first.glyph;
  token.probability = probability;
  token.place.origin = first.origin_P;
  token.place.size = style.size;
  ReadingResult result;
  result.tokens = {token};
  return ReadingPicture(set.pages.front(), script, set.style, false, "lu", result);
}

/// The lowest of all filled or stroked shapes, stroke widths included [mm].
double LowestShape(const Drawing& drawing) {
  double low = HUGE_VAL;
  for (const Mark& mark : drawing.marks) {
    const auto* path = std::get_if<PathMark>(&mark);
    const bool plate = path != nullptr && path->fill && Same(*path->fill, {1, 1, 1});
    if (path == nullptr || plate) continue;
    for (const std::vector<Piece>& pieces : path->subpaths) {
      for (const Piece& piece : pieces) {
        low = std::min(low, BoundsOf(piece).min.y - (path->stroke ? 0.5 * path->width : 0));
      }
    }
  }
  return low;
}

TEST(ReadingPicture, PrintStandsBelowDotsAndRulesOnPaperOfItsOwn) {
  for (const char* script : {"moon", "braille"}) {
    for (const bool rules : {false, true}) {
      const Drawing drawing = FirstRead(script, rules);
      const double lowest = LowestShape(drawing);
      std::size_t at = 0, plate = 0;
      for (std::size_t i = 0; i < drawing.marks.size(); ++i) {
        const auto* path = std::get_if<PathMark>(&drawing.marks[i]);
        if (path != nullptr && path->fill && Same(*path->fill, {1, 1, 1})) plate = i;
        const auto* text = std::get_if<TextMark>(&drawing.marks[i]);
        if (text == nullptr || at != 0) continue;
        at = i;
        EXPECT_LT(text->at.y + text->height, lowest) << script << " " << rules;
        EXPECT_GT(text->at.y, lowest - 3 * text->height) << script << " " << rules;
      }
      EXPECT_GT(plate, 0U);
      EXPECT_LT(plate, at);  // painted before what stands on it
    }
  }
}

// The legend: "how sure it is where that is below 99 percent".
TEST(ReadingPicture, TellsHowSureItIsBelowNinetyNinePercent) {
  const auto told = [](double probability) {
    const Drawing drawing = FirstRead("moon", false, probability);
    for (const Mark& mark : drawing.marks) {
      const auto* text = std::get_if<TextMark>(&mark);
      if (text != nullptr && text->text.ends_with(" %")) return text->text;
    }
    return std::string();
  };
  EXPECT_EQ(told(0.97), "97 %");
  EXPECT_EQ(told(0.988), "98 %");
  EXPECT_EQ(told(0.992), "");
}

TEST(ReadingPicture, SaysThatNothingWasRead) {
  EXPECT_NE(PictureOf(true).description.find("Read: nothing."), std::string::npos);
}

}  // namespace
}  // namespace moontrace

// What is drawn of a page that was read by touch.

#include "sim/recognise/reading_picture.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace moontrace

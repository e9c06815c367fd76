// Where the print stands that `page --letters` draws.

#include "sim/picture/print_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/reshape.h"
#include "textures/typeset/rules.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// A text set with `style` on a sheet of 120 x 60 mm, its print and its ink [mm].
struct Printed {
  Printed(const std::string& text, Script script, TypeStyle style) {
    script = Reshaped(script, style.form);
    const Typeset set = SetText(text, script, style, FindPage("120x60"));
    const TextPage& page = set.pages.front();
    for (Mark& mark : PrintMarks(page, script, style, text))
      marks.push_back(std::get<TextMark>(mark));
    for (const PlacedGlyph& placed : page.glyphs) {
      for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
        // a groove is as wide as the style says, a dot has its outline
        const double half = stroke.kind == StrokeKind::kStroke ? style.width / 2 : 0;
        for (const Piece& piece : stroke.pieces) {
          const Box box = BoundsOf(Placed(piece, style.size, placed.origin_P));
          lowest = std::min(lowest, 1e3 * (box.min.y - half));
        }
      }
    }
    for (const Line& rule : RaisedLinesOf(page, script, style).rules) {
      lowest = std::min(lowest, 1e3 * (rule.from.y - RuleProfile(style).width / 2));
    }
    origin = 1e3 * page.glyphs.front().origin_P;
  }
  std::vector<TextMark> marks;
  double lowest = 1e9;
  glm::dvec2 origin{0, 0};
};

TypeStyle StyleFor(const Script& script) {
  return DefaultStyle(script.size, Relief::kEngraved, script);
}

void ExpectBelow(const Printed& printed) {
  for (const TextMark& mark : printed.marks) {
    EXPECT_LT(mark.at.y + mark.height, printed.lowest) << mark.text;
    EXPECT_GT(mark.at.y, printed.lowest - 2 * mark.height) << mark.text;
  }
}

TEST(PrintMarks, StandBelowTheLowestStroke) {
  const Script moon = FindScript("moon"), braille = FindScript("braille");
  ExpectBelow(Printed("moon", moon, StyleFor(moon)));
  ExpectBelow(Printed("lml", braille, StyleFor(braille)));
}

TEST(PrintMarks, StandBelowTheLowerRule) {
  const Script moon = FindScript("moon");
  TypeStyle style = StyleFor(moon);
  style.rules.lines = true;
  ExpectBelow(Printed("here", moon, style));
}

// Small letters leave little room between the rules of two lines: print is smaller there, or a line
// says which pitch has room; it never stands on a rule.
TEST(PrintMarks, NeverStandOnARule) {
  const Script moon = FindScript("moon");
  int drawn = 0, refused = 0;
  for (const double size : {0.003, 0.004, 0.006, 0.008, 0.012}) {
    TypeStyle style = DefaultStyle(size, Relief::kEngraved, moon);
    style.rules.lines = true;
    // a numeral sign hangs lower than its digits, and than all else here
    const std::string text = size > 0.010 ? "no 12\nnor 3" : "one, (two);\nthree?";
    const Typeset set = SetText(text, moon, style, FindPage("a4"));
    std::vector<Mark> marks;
    try {
      marks = PrintMarks(set.pages.front(), moon, style, text);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("or more"), std::string::npos) << error.what();
      ++refused;
      continue;
    }
    ++drawn;
    for (const Line& rule : RaisedLinesOf(set.pages.front(), moon, style).rules) {
      const double half = 0.5e3 * RuleProfile(style).width, y = 1e3 * rule.from.y;
      for (const Mark& mark : marks) {
        const auto& print = std::get<TextMark>(mark);
        const double top = print.at.y + print.height, low = print.at.y - 0.2 * print.height;
        EXPECT_TRUE(low > y + half || top < y - half) << size << " " << print.text;
      }
    }
  }
  EXPECT_GE(drawn, 3);
  EXPECT_GE(refused, 1);
}

// Below a single line there is no other whose rule the print would have to keep away from.
TEST(PrintMarks, OfASingleLineBetweenRulesAreAsHighAsWithout) {
  const Script moon = FindScript("moon");
  TypeStyle style = StyleFor(moon);
  style.rules.makes_room = true;
  const Printed open("one", moon, style);
  style.rules.lines = true;
  const Printed ruled("one", moon, style);
  EXPECT_NEAR(ruled.marks[0].height, open.marks[0].height, 1e-9);
  ExpectBelow(ruled);
}

// A line at the foot of the text area has the margin's ridge below it, and beyond that the paper.
TEST(PrintMarks, NeverStandOnARaisedMargin) {
  const Script moon = FindScript("moon");
  for (const bool lines : {false, true}) {
    for (const double height_mm : {70.0, 75.0, 80.0, 85.0, 90.0}) {
      TypeStyle style = StyleFor(moon);
      style.line_pitch = 0.024;
      style.rules.margin = true;
      style.rules.lines = lines;
      const std::string text = "one two three four five";
      const PageSpec sheet{"custom", 0.16, 1e-3 * height_mm, 0.015};
      const Typeset set = SetText(text, moon, style, sheet);
      const TextPage& page = set.pages.front();
      double low = 1e9;
      for (const Piece& piece : RaisedLinesOf(page, moon, style).margin) {
        low = std::min(low, 1e3 * BoundsOf(piece).min.y);
      }
      const double half = 0.5e3 * MarginProfile(style).width;
      for (const Mark& mark : PrintMarks(page, moon, style, text)) {
        const auto& print = std::get<TextMark>(mark);
        const double top = print.at.y + print.height, foot = print.at.y - 0.2 * print.height;
        EXPECT_TRUE(foot > low + half || top < low - half) << height_mm << " " << print.text;
        EXPECT_GT(foot, 0) << height_mm;
      }
    }
  }
}

TEST(PrintMarks, MoveWithTheFootOfLettersThatLean) {
  const Script moon = FindScript("moon");
  TypeStyle style = StyleFor(moon);
  const Printed upright("moon", moon, style);
  EXPECT_NEAR(upright.marks[0].at.x, upright.origin.x, 1e-9);
  style.form = {std::numbers::pi / 12, 1};  // about the base line
  const Printed right("moon", moon, style);
  EXPECT_NEAR(right.marks[0].at.x, right.origin.x, 1e-9);
  style.form = {-std::numbers::pi / 6, 0.5};  // about the top line, 12 mm above
  const Printed left("moon", moon, style);
  EXPECT_NEAR(left.marks[0].at.x, left.origin.x + 12 * std::tan(std::numbers::pi / 6), 1e-9);
}

TEST(PrintMarks, AreThoseOfTheText) {
  const Script moon = FindScript("moon");
  const Printed printed("no 1", moon,
                        StyleFor(moon));  // with a numeral sign, which stands for none
  ASSERT_EQ(printed.marks.size(), 3U);
  EXPECT_EQ(printed.marks[2].text, "1");
}

}  // namespace
}  // namespace moontrace

// Where the print stands that the view draws below letters.

#include "sim/view/view_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "sim/physics/page_field.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/rules.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kSmall = 16, kBig = 24;  // heights of print letters [points]

/// A page and the print on it, seen whole at so many points a metre of page.
struct Seen {
  Seen(const std::string& text, const Script& script, const TypeStyle& style, double points) {
    const Typeset set = SetText(text, script, style, FindPage("160x80"));
    const TextPage& page = set.pages.front();
    auto field = std::make_shared<const TextureField>(PageField(page, script, set.style, false));
    view = MakeViewPage(set, 0, script, text, std::move(field), false, 0);
    rules = RaisedLinesOf(page, script, set.style).rules;
    half_rule = 0.5 * RuleProfile(set.style).width;
    PageCamera camera;
    camera.at_P = {0.08, 0.04};
    camera.height = 0.08;
    marks = MarksOf(*view, ViewHistory(), camera, 2, true, points * camera.height, kSmall, kBig);
    half_print = 0.5 / points;  // of a point
  }
  /// From the middle of a letter to its lower or upper edge [m].
  double HalfOf(const ViewMarks::Print& print) const {
    return half_print * (print.big ? kBig : kSmall);
  }
  std::shared_ptr<const ViewPage> view;
  std::vector<Line> rules;
  double half_rule = 0, half_print = 0;
  ViewMarks marks;
};

/// The number of letters that have print, none of it on a rule.
std::size_t CountClear(const Seen& seen) {
  for (const ViewMarks::Print& print : seen.marks.print) {
    const double half = seen.HalfOf(print);
    for (const Line& rule : seen.rules) {
      EXPECT_GE(std::abs(print.at_P.y - rule.from.y), half + seen.half_rule - 1e-9) << print.text;
    }
  }
  return seen.marks.print.size();
}

TEST(ViewMarks, PrintNeverStandsOnARule) {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, moon);
  style.rules.lines = true;
  for (const double pitch : {0.0216, 0.03}) {
    style.line_pitch = pitch;
    for (const double points : {2500.0, 5000.0, 10000.0, 20000.0}) {
      const Seen seen("here\nno 3?", moon, style, points);
      ASSERT_EQ(seen.rules.size(), 4U);
      EXPECT_EQ(CountClear(seen), 8U) << pitch << ", " << points << " points a metre";
    }
  }
}

// There it stands behind its letter, before the next: between rules close together it would be on
// them.
TEST(ViewMarks, PrintStandsBesideLettersWhereRulesLeaveNoRoomBelow) {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, moon);
  style.rules.lines = style.rules.makes_room = true;  // as close as they may be
  const Seen seen("here\nsee", moon, style, 3000);
  ASSERT_EQ(CountClear(seen), 7U);
  std::vector<Box> letters(seen.view->letters.size());
  for (const IntendedStroke& stroke : seen.view->strokes) {
    for (const Piece& piece : stroke.spine_P) Include(letters[stroke.glyph], BoundsOf(piece));
  }
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const ViewMarks::Print& print = seen.marks.print[i];
    // a letter of DejaVu Sans is some 0.6 of its height wide at most, but for m and w
    const double left = print.at_P.x - 0.6 * seen.HalfOf(print);
    const double right = print.at_P.x + 0.6 * seen.HalfOf(print);
    EXPECT_EQ(print.text, seen.view->letters[i].print);
    EXPECT_GE(left, letters[i].max.x + 0.5 * style.width);
    EXPECT_NEAR(print.at_P.y, letters[i].min.y + seen.HalfOf(print), 0.4 * style.size);
    const bool last = i + 1 == letters.size() || letters[i + 1].min.x < letters[i].max.x;
    if (!last) {
      EXPECT_LE(right, letters[i + 1].min.x - 0.5 * style.width) << i;
    }
  }
}

// Other scripts have tails, as a print g, that reach a third of the letter below the base line.
TEST(ViewMarks, PrintStandsBelowTails) {
  Script script = FindScript("moon");
  Stroke tail;
  tail.pieces = {Line{{0.3, 0}, {0.3, -0.35}}};
  script.glyphs.at(script.Find("g")).strokes.push_back(tail);
  const TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  for (const double points : {2500.0, 5000.0, 10000.0}) {
    const Seen seen("gap", script, style, points);
    const double tail_end = seen.view->letters.at(0).box_P.min.y - 0.35 * style.size;
    ASSERT_EQ(seen.marks.print.size(), 3U);
    for (const ViewMarks::Print& print : seen.marks.print) {
      EXPECT_LE(print.at_P.y + seen.HalfOf(print), tail_end - 0.5 * style.width + 1e-9);
    }
  }
}

// On a plate that leans by 60 degrees, a face of cos 60 of its height is seen: print that is
// upright in the picture would reach over its edge, which is that of the strokes above.
TEST(ViewMarks, UprightPrintStaysBelowItsEdgeOnFacesThatLean) {
  const glm::dvec2 at = UprightPrint({100, 50 - 8 * 0.5}, {100, 50}, 8);
  EXPECT_EQ(at, glm::dvec2(100, 42));
  // read upside down the strokes are on the other side
  EXPECT_EQ(UprightPrint({100, 54}, {100, 50}, 8), glm::dvec2(100, 58));
  // seen straight on, or turned by a quarter, it stands where it is
  EXPECT_EQ(UprightPrint({100, 42}, {100, 50}, 8), glm::dvec2(100, 42));
  EXPECT_EQ(UprightPrint({104, 49}, {100, 50}, 8), glm::dvec2(104, 49));
}

}  // namespace
}  // namespace moontrace

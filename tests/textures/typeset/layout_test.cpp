#include "textures/typeset/layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/typeset/taught.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kSize = 0.010;

// SmallScript at 10 mm: strokes reach 5 mm, every advance and the space 10 mm.
Typeset Set(std::string_view text, LineDirection lines, const Script& script,
            const PageSpec& page = {"custom", 0.10, 0.10, 0.010},
            std::optional<double> paragraph_gap = std::nullopt) {
  TypeStyle style = DefaultStyle(kSize, Relief::kEngraved, script);
  style.lines = lines;
  style.line_pitch = 0.020;
  style.paragraph_gap = paragraph_gap;
  return SetText(text, script, style, page);
}

std::string Name(const PlacedGlyph& placed, const Script& script) {
  return script.glyphs[placed.glyph].name;
}

TEST(Lines, RightToLeftBeginAtTheRightMarginAndKeepTheLettersForm) {
  const Script script = SmallScript();
  const Typeset set = Set("ab c", LineDirection::kRightToLeft, script);
  const auto& glyphs = set.pages[0].glyphs;
  ASSERT_EQ(glyphs.size(), 3U);
  EXPECT_EQ(Name(glyphs[0], script), "a");
  // The strokes' right edge, 5 mm from the origin, stands at the right margin, 90 mm.
  EXPECT_NEAR(glyphs[0].origin_P.x, 0.085, 1e-12);
  EXPECT_NEAR(glyphs[1].origin_P.x, 0.075, 1e-12);
  EXPECT_NEAR(glyphs[2].origin_P.x, 0.055, 1e-12);
  EXPECT_NEAR(glyphs[2].origin_P.y, 0.080, 1e-12);
}

TEST(Lines, VerticalRunDownAndThenToTheLeft) {
  const Script script = SmallScript();
  const Typeset set = Set("ab\nc", LineDirection::kVertical, script);
  const auto& glyphs = set.pages[0].glyphs;
  ASSERT_EQ(glyphs.size(), 3U);
  // Boxes of 10 mm below the top margin, gaps of 5 mm as along a line; strokes of 5 mm in the
  // middle of a column of 10 mm.
  EXPECT_NEAR(glyphs[0].origin_P.x, 0.0825, 1e-12);
  EXPECT_NEAR(glyphs[0].origin_P.y, 0.080, 1e-12);
  EXPECT_NEAR(glyphs[1].origin_P.y, 0.065, 1e-12);
  EXPECT_NEAR(glyphs[2].origin_P.x, 0.0625, 1e-12);
  EXPECT_NEAR(glyphs[2].origin_P.y, 0.080, 1e-12);
  EXPECT_EQ(glyphs[2].line, 1U);
}

class OldMoon : public ::testing::Test {
 protected:
  // Lines 20 mm apart: guides bulge by 6 mm.
  OldMoon() : script_(SmallScript()) {
    TypeStyle style = DefaultStyle(kSize, Relief::kEngraved, script_);
    style.line_pitch = 0.020;
    AddGuides(script_, style);
  }
  Typeset Lay(std::string_view text, std::optional<double> gap = std::nullopt) const {
    return Set(text, LineDirection::kAlternate, script_, {"custom", 0.10, 0.10, 0.010}, gap);
  }
  double RightOf(const PlacedGlyph& placed) const { return placed.origin_P.x + 0.5 * kSize; }
  Script script_;
};

// bsblind, Grade 1 (moon-script reference, section 8): every second line runs backward with the
// letters as they are; a guide line leads down; a broken part of a word stands close to it.
TEST_F(OldMoon, BreaksWordsAtAGuideAndRunsBack) {
  const Typeset set = Lay("abcdefghi");
  const auto& glyphs = set.pages[0].glyphs;
  // 80 mm hold letters whose right edge, gap of 5 mm and guide of 6 mm fit: 7 letters end at 65 mm.
  ASSERT_EQ(glyphs.size(), 10U);
  EXPECT_EQ(Name(glyphs[6], script_), "g");
  EXPECT_EQ(Name(glyphs[7], script_), "guide-right");
  EXPECT_NEAR(glyphs[7].origin_P.x - RightOf(glyphs[6]), 0.005, 1e-12);  // the usual gap
  EXPECT_EQ(glyphs[7].line, 0U);
  EXPECT_EQ(glyphs[7].source_begin, glyphs[7].source_end);
  EXPECT_EQ(Name(glyphs[8], script_), "h");
  EXPECT_EQ(glyphs[8].line, 1U);
  EXPECT_EQ(glyphs[8].word, glyphs[6].word);
  EXPECT_NEAR(glyphs[7].origin_P.x - RightOf(glyphs[8]), 0.005, 1e-12);  // under the guide
  EXPECT_LT(glyphs[9].origin_P.x, glyphs[8].origin_P.x);
}

TEST_F(OldMoon, KeepsTheSpaceBetweenAFinishedWordAndTheGuide) {
  const Typeset set = Lay("abcdef gh");
  const auto& glyphs = set.pages[0].glyphs;
  EXPECT_EQ(Name(glyphs[6], script_), "guide-right");
  EXPECT_NEAR(glyphs[6].origin_P.x - RightOf(glyphs[5]), 0.015, 1e-12);  // gap and space
  EXPECT_NE(glyphs[7].word, glyphs[5].word);
}

TEST_F(OldMoon, GuidesLeadFromTheMiddleOfALineToTheMiddleOfTheNext) {
  for (const char* name : {"guide-right", "guide-left"}) {
    const Piece& arc = script_.glyphs[script_.Find(name)].strokes[0].pieces[0];
    EXPECT_NEAR(StartOf(arc).x, 0, 1e-12);
    EXPECT_NEAR(StartOf(arc).y, 0.5, 1e-12);
    EXPECT_NEAR(EndOf(arc).x, 0, 1e-12);
    EXPECT_NEAR(EndOf(arc).y, 0.5 - 2.0, 1e-12);
    const double side = std::string(name) == "guide-right" ? 1 : -1;
    EXPECT_NEAR(PointAt(arc, Length(arc) / 2).x, side * 0.3 * 2, 1e-12);
  }
}

TEST_F(OldMoon, RunsOnAtLineEndsWithAParagraphsSpace) {
  const Typeset set = Lay("a\n\nb");
  const auto& glyphs = set.pages[0].glyphs;
  ASSERT_EQ(glyphs.size(), 2U);
  EXPECT_EQ(set.pages[0].lines, 1U);
  EXPECT_NEAR(glyphs[1].origin_P.x - glyphs[0].origin_P.x, 0.030, 1e-12);
  const Typeset wide = Lay("a\nb", 0.033);
  EXPECT_NEAR(wide.pages[0].glyphs[1].origin_P.x - wide.pages[0].glyphs[0].origin_P.x, 0.043,
              1e-12);
}

TEST_F(OldMoon, EveryLineStaysWithinItsMargins) {
  std::string text;
  for (int i = 0; i < 400; ++i)
    text += std::string(1 + static_cast<std::size_t>(i * 7 % 5), 'a') + ' ';
  const Typeset set = Lay(text);
  std::size_t letters = 0;
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& placed : page.glyphs) {
      const bool guide = Name(placed, script_) != "a";
      letters += guide ? 0 : 1;
      const double left = placed.origin_P.x - (Name(placed, script_) == "guide-left" ? 0.006 : 0);
      const double right =
          guide ? placed.origin_P.x + (Name(placed, script_) == "guide-right" ? 0.006 : 0)
                : RightOf(placed);
      EXPECT_GE(left, 0.010 - 1e-9);
      EXPECT_LE(right, 0.090 + 1e-9);
    }
  }
  EXPECT_EQ(letters, static_cast<std::size_t>(std::count(text.begin(), text.end(), 'a')));
}

TEST_F(OldMoon, BeginsAShortLineAtTheMarginWhereTheGuideLeavesNoRoom) {
  // A wide b: on lines of 22 mm it would begin at 17 mm, under the guide behind a.
  Script wide = script_;
  wide.glyphs[wide.Find("b")].strokes[0].pieces = {Line{{0, 0}, {1, 1}}};
  const Typeset set = Set("ab", LineDirection::kAlternate, wide, {"custom", 0.042, 0.10, 0.010});
  ASSERT_EQ(set.pages[0].glyphs.size(), 3U);
  EXPECT_NEAR(set.pages[0].glyphs[2].origin_P.x, 0.042 - 0.010 - 0.010, 1e-12);
}

TEST(Paragraphs, TakeTheGapInPlaceOfAnEmptyLine) {
  const Script script = SmallScript();
  const Typeset set =
      Set("a\nb\n\n\nc", LineDirection::kLeftToRight, script, {"custom", 0.10, 0.10, 0.010}, 0.005);
  const auto& glyphs = set.pages[0].glyphs;
  EXPECT_NEAR(glyphs[0].origin_P.y - glyphs[1].origin_P.y, 0.020, 1e-12);  // verse keeps lines
  EXPECT_NEAR(glyphs[1].origin_P.y - glyphs[2].origin_P.y, 0.025, 1e-12);
  EXPECT_EQ(set.pages[0].lines, 3U);
}

TEST(Paragraphs, GapsCountForThePagesEnd) {
  const Script script = SmallScript();
  // 80 mm between the margins: base lines at 10, 30, 50, 70 mm; a gap of 15 mm pushes the last out.
  const auto pages = [&](std::string_view text) {
    return Set(text, LineDirection::kLeftToRight, script, {"custom", 0.10, 0.10, 0.010}, 0.015)
        .pages.size();
  };
  EXPECT_EQ(pages("a\nb\nc\nd"), 1U);
  EXPECT_EQ(pages("a\n\nb\nc\nd"), 2U);
}

TEST(TaughtSigns, SpellOutContractionsAndTellLettersThatAreNot) {
  const Script script = SmallScript();
  TypeStyle style = DefaultStyle(kSize, Relief::kEngraved, script);
  style.only = TaughtSigns("Athe1+numeral", script);
  const Typeset set = SetText("the that 1 2s", script, style, FindPage("a4"));
  std::string names;
  for (const PlacedGlyph& placed : set.pages[0].glyphs) names += Name(placed, script) + " ";
  EXPECT_EQ(names, "t h e t h a t numeral a ");
  ASSERT_EQ(set.untaught_count, 2U);
  EXPECT_EQ(set.untaught[0].was, "2");
  EXPECT_EQ(set.untaught[1].was, "s");
  style.only = TaughtSigns("a+th", script);
  EXPECT_EQ(SetText("the", script, style, FindPage("a4")).pages[0].glyphs.size(), 1U);
}

TEST(TaughtSigns, NameWhatIsNoSign) {
  const Script script = SmallScript();
  EXPECT_THROW(TaughtSigns("", script), InputError);
  EXPECT_THROW(TaughtSigns("a\u65E5", script), InputError);
  try {
    TaughtSigns("a+numerl", script);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "taught signs: script small has no sign named 'numerl': did you mean numeral?");
  }
}

TEST(TaughtSigns, LeaveNothingToSetInOneLine) {
  const Script script = SmallScript();
  TypeStyle style = DefaultStyle(kSize, Relief::kEngraved, script);
  style.only = {"a"};
  EXPECT_THROW(SetText("b", script, style, FindPage("a4")), InputError);
}

}  // namespace
}  // namespace moontrace

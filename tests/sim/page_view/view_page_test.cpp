#include "sim/page_view/view_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "sim/physics/page_field.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

struct Page {
  Script script = FindScript("moon");
  PageSpec sheet{"custom", 0.16, 0.06, 0.005};
  Typeset set;
  std::string text;

  explicit Page(const std::string& words) : text(words) {
    set = SetText(text, script, DefaultStyle(0.012, Relief::kEngraved, script), sheet);
  }
  std::shared_ptr<const ViewPage> View(bool blank = false) const {
    auto field =
        std::make_shared<const TextureField>(PageField(set.pages.at(0), script, set.style, blank));
    return MakeViewPage(set, 0, script, text, std::move(field), blank, 7);
  }
};

TEST(ViewPage, HasTheSheetItsNumberAndTheGroovesWidth) {
  const auto view = Page("moon").View();
  EXPECT_EQ(view->number, 7U);
  EXPECT_EQ(view->sheet_P, (Box{{0, 0}, {0.16, 0.06}}));
  EXPECT_NEAR(view->width, 0.1165 * 0.012, 1e-12);  // the design's share of the em
}

TEST(ViewPage, LettersStandForTheirCharacters) {
  const auto view = Page("aé").View();
  ASSERT_EQ(view->letters.size(), 2U);
  EXPECT_EQ(view->letters[0].print, "a");
  EXPECT_EQ(view->letters[1].print, "é");
}

TEST(ViewPage, LettersThatAreAskedForStandForNothing) {
  const auto told = Page("moon").View();
  const auto asked = WithoutPrint(*told);
  ASSERT_EQ(asked->letters.size(), 4U);
  for (const ViewPage::Letter& letter : asked->letters) EXPECT_EQ(letter.print, "");
  EXPECT_EQ(asked->number, told->number);
  EXPECT_EQ(asked->field, told->field);
  EXPECT_EQ(asked->letters[0].box_P, told->letters[0].box_P);
}

// The numeral sign stands for no character of the text.
TEST(ViewPage, TheNumeralSignHasNoPrint) {
  const auto view = Page("3").View();
  ASSERT_EQ(view->letters.size(), 2U);
  EXPECT_EQ(view->letters[0].print, "");
  EXPECT_EQ(view->letters[1].print, "3");
}

TEST(ViewPage, EmBoxesStandSideBySideOnTheBaseLine) {
  const Page page("moon");
  const auto view = page.View();
  ASSERT_EQ(view->letters.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Box& box = view->letters[i].box_P;
    EXPECT_NEAR(box.max.y - box.min.y, 0.012, 1e-12);
    EXPECT_EQ(box.min, page.set.pages[0].glyphs[i].origin_P);
    if (i > 0) {
      EXPECT_GE(box.min.x, view->letters[i - 1].box_P.max.x - 1e-9);
    }
  }
}

// Middles of centre lines are as deep as the profile says: D less the rounding's share, s r / 2
// with s = D / (w/2 - r) (design section 4): -D at d = 0.
TEST(ViewPage, EveryLettersStrokesAreWhereTheFieldSays) {
  for (char c = 'a'; c <= 'z'; ++c) {
    const Page page(std::string(1, c));
    const auto view = page.View();
    ASSERT_FALSE(view->strokes.empty()) << c;
    for (const IntendedStroke& stroke : view->strokes) {
      EXPECT_EQ(stroke.glyph, 0U);
      for (const Piece& piece : stroke.spine_P) {
        const Sample sample = view->field->SampleAt(PointAt(piece, 0.5 * Length(piece)));
        EXPECT_NEAR(sample.displacement, -page.set.style.depth, 1e-9) << c;
      }
    }
  }
}

// The text of a trial begins at the sheet's upper left corner.
TEST(ViewPage, PaperRoundATextReachesAsFarToEachSide) {
  const auto page = Page("moon").View(false);
  const auto view = WithPaperAround(*page);
  Box text;
  for (const ViewPage::Letter& letter : page->letters) Include(text, letter.box_P);
  const glm::dvec2 size = text.max - text.min;
  for (int i = 0; i < 2; ++i) {
    EXPECT_GE(text.min[i] - view->sheet_P.min[i], 0.5 * (size.x - size[i]));
    EXPECT_GE(view->sheet_P.max[i] - text.max[i], 0.5 * (size.x - size[i]));
    EXPECT_LE(view->sheet_P.min[i], page->sheet_P.min[i]);
    EXPECT_GE(view->sheet_P.max[i], page->sheet_P.max[i]);
  }
  EXPECT_EQ(view->field, page->field);
}

TEST(ViewPage, BlankPaperHasLettersButNoGrooves) {
  const auto view = Page("moon").View(true);
  EXPECT_EQ(view->letters.size(), 4U);
  EXPECT_TRUE(view->strokes.empty());
  EXPECT_EQ(view->field->greatest_displacement(), 0);
}

}  // namespace
}  // namespace moontrace

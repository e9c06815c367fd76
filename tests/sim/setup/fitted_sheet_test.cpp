#include "sim/setup/fitted_sheet.h"

#include <gtest/gtest.h>

#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

Typeset On(const PageSpec& sheet, const std::string& text, const Script& moon) {
  return SetText(text, moon, DefaultStyle(0.012, Relief::kEngraved, moon), sheet);
}

Box TextOn(const Typeset& set, const Script& moon) {
  Box box;
  for (const PlacedGlyph& placed : set.pages.at(0).glyphs) {
    Include(box, placed.origin_P);
    Include(box,
            placed.origin_P + set.style.size * glm::dvec2(moon.glyphs.at(placed.glyph).advance, 1));
  }
  return box;
}

TEST(FitSheet, TheTextLiesInTheMiddleAndFillsTheSheetButForItsMargins) {
  const Script moon = FindScript("moon");
  for (const char* text : {"a", "the moon", "the moon\nis bright\ntonight", "i\ni\ni\ni"}) {
    Typeset set = On(FindPage("a4"), text, moon);
    const Box before = TextOn(set, moon);
    FitSheet(set, moon);
    const Box after = TextOn(set, moon);
    const Box& sheet = set.pages[0].sheet_P;
    EXPECT_EQ(sheet.max, glm::dvec2(set.page.width, set.page.height)) << text;
    EXPECT_EQ(set.page.width, set.page.height) << text;
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(after.min[i] + after.max[i], sheet.max[i], 1e-12) << text;
      EXPECT_NEAR(after.max[i] - after.min[i], before.max[i] - before.min[i], 1e-12) << text;
    }
    const glm::dvec2 size = after.max - after.min;
    EXPECT_NEAR(set.page.width - std::max(size.x, size.y), 2 * set.page.margin, 1e-12) << text;
  }
}

TEST(FitSheet, OnASheetThatWasNamedTheTextLiesInTheMiddleToo) {
  const Script moon = FindScript("moon");
  for (const char* text : {"a", "the moon", "i\ni\ni\ni"}) {
    Typeset set = On(FindPage("a4"), text, moon);
    CentreText(set, moon);
    const Box after = TextOn(set, moon);
    EXPECT_NEAR(after.min.x + after.max.x, 0.210, 1e-12) << text;
    EXPECT_NEAR(after.min.y + after.max.y, 0.297, 1e-12) << text;
    EXPECT_EQ(set.page.name, "a4");
  }
}

TEST(FitSheet, ATextThatFillsItsSheetOrSeveralStaysWhereItIs) {
  const Script moon = FindScript("moon");
  std::string lines, pages;
  for (int i = 0; i < 11; ++i) lines += "moon\n";
  for (int i = 0; i < 40; ++i) pages += "moon\n";
  for (const std::string& text : {lines, pages}) {
    Typeset set = On(FindPage("a4"), text, moon);
    const Typeset before = set;
    FitSheet(set, moon);
    EXPECT_EQ(set.page.name, "a4");
    EXPECT_EQ(set.pages[0].glyphs[0].origin_P, before.pages[0].glyphs[0].origin_P);
    EXPECT_EQ(set.pages[0].sheet_P, before.pages[0].sheet_P);
  }
}

}  // namespace
}  // namespace moontrace

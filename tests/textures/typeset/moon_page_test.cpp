// Pages of the Moon script that comes with the program, against the reference's own figures.
#include <gtest/gtest.h>

#include "textures/base/resources.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

const Script& Moon() {
  static const Script script = LoadScript(ResourcePath("textures/scripts/moon.svg"));
  return script;
}

Typeset Set(std::string_view text, double grade = 1) {
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, Moon());
  style.grade = grade;
  return SetText(text, Moon(), style, FindPage("a4"));
}

// Where each glyph of the first page stands, from the first one's place [mm].
std::vector<double> Columns(const Typeset& set) {
  std::vector<double> columns;
  for (const PlacedGlyph& placed : set.pages[0].glyphs) {
    columns.push_back((placed.origin_P.x - set.page.margin) * 1000);
  }
  return columns;
}

void ExpectColumns(const Typeset& set, const std::vector<double>& expected) {
  const std::vector<double> columns = Columns(set);
  ASSERT_EQ(columns.size(), expected.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_NEAR(columns[i], expected[i], 1e-9) << i;  // sums of decimals, a picometre
  }
}

// The reference's advances in em: a 1.567, b 1.358, d 1.468, n 1.608, space 1.425, AND 1.664,
// TH 1.699, numeral sign 1.567, c 1.468.
TEST(MoonPage, StandsByTheReferencesAdvances) {
  ExpectColumns(Set("ab"), {0, 15.67});
  ExpectColumns(Set("a b"), {0, 15.67 + 14.25});
  ExpectColumns(Set("band"), {0, 13.58, 13.58 + 15.67, 13.58 + 15.67 + 16.08});
  ExpectColumns(Set("and b", 1), {0, 16.64 + 14.25});
  ExpectColumns(Set("and b", 0.5), {0, 15.67, 31.75, 31.75 + 14.68 + 14.25});
  ExpectColumns(Set("the b"), {0, 16.99 + 14.25});
  ExpectColumns(Set("23"), {0, 15.67, 15.67 + 13.58});
}

TEST(MoonPage, WritesDigitsAsLettersBehindOneSign) {
  const Typeset digits = Set("1989 207");
  const Typeset letters = Set("aihi bjg");
  std::vector<std::size_t> seen, expected;
  for (const PlacedGlyph& placed : digits.pages[0].glyphs) {
    if (placed.source_begin < placed.source_end) seen.push_back(placed.glyph);
  }
  for (const PlacedGlyph& placed : letters.pages[0].glyphs) expected.push_back(placed.glyph);
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(digits.pages[0].glyphs.size(), expected.size() + 2);
}

TEST(MoonPage, HasEveryLetterDigitAndUsualMark) {
  const Typeset set = Set(
      "The quick brown fox jumps over the lazy dog, 0123456789. (Who? Him!) \"It's well-known\": "
      "1/2");
  EXPECT_EQ(set.missing_count, 0u);
  EXPECT_EQ(set.folded_count, 0u);
}

TEST(MoonPage, FoldsAccentsLigaturesQuotesAndDashes) {
  const Typeset set = Set("caf\u00E9 \uFB01n \u2018a\u2019 \u201Cb\u201D c\u2013d e\u2014f\u2026");
  EXPECT_EQ(set.missing_count, 0u);
  EXPECT_EQ(set.folded_count, 9u);
  EXPECT_EQ(set.folded[0].was, "\u00E9");
  EXPECT_EQ(set.folded[0].became, "e");
  EXPECT_EQ(set.folded[0].column, 4u);
}

TEST(MoonPage, TellsWhatMoonHasNoFormOf) {
  const Typeset set = Set("a\n \u65E5");
  ASSERT_EQ(set.missing.size(), 1u);
  EXPECT_EQ(set.missing[0].was, "\u65E5");
  EXPECT_EQ(set.missing[0].line, 2u);
  EXPECT_EQ(set.missing[0].column, 2u);
}

}  // namespace
}  // namespace moontrace

#include "textures/base/utf8.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(FirstBadUtf8, TakesEveryWellFormedLength) {
  EXPECT_EQ(FirstBadUtf8(""), std::nullopt);
  EXPECT_EQ(FirstBadUtf8("a\xC3\xA9\xE4\xB8\x80\xF0\x9F\x98\x80\xEF\xBB\xBF"), std::nullopt);
  EXPECT_EQ(FirstBadUtf8("\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF"), std::nullopt);
}

TEST(FirstBadUtf8, FindsWhatUnicodeForbids) {
  // Unicode, table 3-7: overlong, surrogate, beyond U+10FFFF, lone and missing trailing bytes.
  for (const char* bad : {"\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80",
                          "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80",
                          "\xC3", "\xE4\xB8", "\xF0\x9F\x98", "\xFF"}) {
    EXPECT_EQ(FirstBadUtf8(std::string("ab") + bad), 2U);
  }
}

// Categories from UnicodeData.txt.
TEST(CharacterCategory, TellsMarksSpacesAndControls) {
  for (const char32_t mark : {U'\u0301', U'\u0903', U'\u20DD'}) EXPECT_TRUE(IsMark(mark));
  for (const char32_t none : {U'a', U'\u00B4', U'\u02FF'}) EXPECT_FALSE(IsMark(none));
  for (const char32_t space : {U' ', U'\u00A0', U'\u3000'}) EXPECT_TRUE(IsSpaceSeparator(space));
  for (const char32_t none : {U'\t', U'\u200B', U'\u2028'}) EXPECT_FALSE(IsSpaceSeparator(none));
  for (const char32_t control : {char32_t{0}, U'\n', char32_t{0x7F}, char32_t{0x9F}}) {
    EXPECT_TRUE(IsControlCode(control));
  }
  for (const char32_t none : {U' ', U'\u200B', U'\u00AD'}) EXPECT_FALSE(IsControlCode(none));
}

// Unicode's CaseFolding.txt, statuses C and F.
TEST(CaseFolded, IsAlikeForNamesThatDifferByCapitalsOnly) {
  EXPECT_EQ(CaseFolded("Ada"), CaseFolded("aDA"));
  EXPECT_EQ(CaseFolded("\u00c5sa"), CaseFolded("\u00e5SA"));
  EXPECT_EQ(CaseFolded("A\u030asa"), CaseFolded("\u00e5sa"));  // composed or not
  EXPECT_EQ(CaseFolded("STRASSE"), CaseFolded("stra\u00dfe"));
  EXPECT_EQ(CaseFolded("\u03a3\u03bf\u03c6\u03af\u03b1\u03c2"),
            CaseFolded("\u03c3\u03bf\u03c6\u03af\u03b1\u03c3"));
  EXPECT_NE(CaseFolded("Ada"), CaseFolded("Ida"));
  EXPECT_NE(CaseFolded("Jose"), CaseFolded("Jos\u00e9"));
}

TEST(CaseFolded, KeepsWhatIsNoText) {
  EXPECT_EQ(CaseFolded(""), "");
  EXPECT_EQ(CaseFolded("A\xff"), "A\xff");
}

}  // namespace
}  // namespace moontrace

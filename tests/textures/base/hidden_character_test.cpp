#include "textures/base/utf8.h"

#include <gtest/gtest.h>

#include "textures/base/text_file.h"

namespace moontrace {
namespace {

TEST(HiddenCharacter, IsWhatTurnsDirectionHasNoWidthOrIsPrivate) {
  for (const char32_t code : {U'\x00', U'\x1B', U'\x7F', U'\x9B', U'\xAD', U'\x61C', U'\x200B',
                              U'\x200E', U'\x202E', U'\x2029', U'\x2066', U'\xE000', U'\xFEFF',
                              U'\xFFFE', U'\xE0041', U'\xF0000', U'\x10FFFF'}) {
    EXPECT_TRUE(IsHidden(code)) << std::hex << static_cast<unsigned>(code);
  }
  for (const char32_t code : {U'\x20', U'\x7E', U'\xA0', U'\xE4', U'\x301', U'\x5D0', U'\x2010',
                              U'\x2018', U'\x20AC', U'\x2801', U'\x6708', U'\xFFFD', U'\x1F319'}) {
    EXPECT_FALSE(IsHidden(code)) << std::hex << static_cast<unsigned>(code);
  }
}

TEST(HiddenCharacter, IsFoundAnywhereInAText) {
  EXPECT_FALSE(HasHidden(""));
  EXPECT_FALSE(HasHidden("\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x8C\x99"));
  EXPECT_TRUE(HasHidden("a\xE2\x80\xAE"));
  EXPECT_TRUE(HasHidden("\xEF\xBB\xBFz"));
}

TEST(HiddenCharacter, IsMendedInWhatIsShown) {
  EXPECT_EQ(HiddenShown("a\xE2\x80\xAE\xC3\xA4\xEE\x80\x80z"), "a?\xC3\xA4?z");
  // a name from a file that would write the rest of the line backwards
  EXPECT_EQ(OneLine("ann\xE2\x80\xAE"
                    "bob"),
            "ann?bob");
  EXPECT_EQ(OneLine("a\tb\nc\x1b[2J\xC2\x9B"
                    "d\xFF"),
            "a?b?c?[2J?d?");
  EXPECT_EQ(OneLine("12345\xE2\x82\xAC", 6), "12345...");
}

}  // namespace
}  // namespace moontrace

#include "textures/hidden_character.h"

#include <gtest/gtest.h>

#include "textures/text_file.h"

namespace moontrace {
namespace {

TEST(HiddenCharacter, IsWhatTurnsDirectionHasNoWidthOrIsPrivate) {
  for (const char32_t code : {0x00, 0x1B, 0x7F, 0x9B, 0xAD, 0x61C, 0x200B, 0x200E, 0x202E, 0x2029,
                              0x2066, 0xE000, 0xFEFF, 0xFFFE, 0xE0041, 0xF0000, 0x10FFFF}) {
    EXPECT_TRUE(IsHidden(code)) << std::hex << static_cast<unsigned>(code);
  }
  for (const char32_t code : {0x20, 0x7E, 0xA0, 0xE4, 0x301, 0x5D0, 0x2010, 0x2018, 0x20AC, 0x2801,
                              0x6708, 0xFFFD, 0x1F319}) {
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

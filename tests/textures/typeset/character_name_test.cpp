#include "textures/typeset/character_name.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

// Names from Unicode's character table.
TEST(CharacterName, SaysWhatCannotBeSeenOrHeard) {
  EXPECT_EQ(CharacterName("\u200B"), "zero width space (U+200B)");
  EXPECT_EQ(CharacterName("\u00AD"), "soft hyphen (U+00AD)");
  EXPECT_EQ(CharacterName("\u2019"), "right single quotation mark (U+2019)");
  EXPECT_EQ(CharacterName("\u2014"), "em dash (U+2014)");
  EXPECT_EQ(CharacterName("'"), "apostrophe");
}

TEST(CharacterName, IsTheNumberForOthersThatCannotBeSeen) {
  EXPECT_EQ(CharacterName("\x01"), "U+0001");
  EXPECT_EQ(CharacterName("\u202E"), "U+202E");
  EXPECT_EQ(CharacterName("\u0301"), "U+0301");  // a mark on nothing
}

TEST(CharacterName, IsEmptyForWhatSpeaksForItself) {
  EXPECT_EQ(CharacterName("a"), "");
  EXPECT_EQ(CharacterName("\u00E9"), "");
  EXPECT_EQ(CharacterName("\u65E5"), "");
  EXPECT_EQ(CharacterName("..."), "");
  EXPECT_EQ(CharacterName(""), "");
}

}  // namespace
}  // namespace moontrace

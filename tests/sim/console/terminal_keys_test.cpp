#include "sim/console/terminal_keys.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

using Keys = std::vector<std::string>;

TEST(KeyReader, GivesSignsAndNamedKeys) {
  EXPECT_EQ(ReadKeys("aB?\xc3\xa9"), (Keys{"a", "B", "?", "\xc3\xa9"}));
  EXPECT_EQ(ReadKeys(" \r\n\t\x7f\b"),
            (Keys{"Space", "Enter", "Enter", "Tab", "Backspace", "Backspace"}));
}

TEST(KeyReader, TellsEscapeFromTheKeysThatBeginWithIt) {
  EXPECT_EQ(ReadKeys("\x1b"), Keys{"Escape"});
  EXPECT_EQ(ReadKeys("\x1b\x1b"), (Keys{"Escape", "Escape"}));
  EXPECT_EQ(ReadKeys("a\x1b"), (Keys{"a", "Escape"}));
  // as xterm, the Linux console and a VT220 send F1, and a few others
  EXPECT_EQ(ReadKeys("\x1bOP\x1b[[A\x1b[11~"), (Keys{"F1", "F1", "F1"}));
  EXPECT_EQ(ReadKeys("\x1b[A\x1bOB\x1b[5~\x1b[24~x"), (Keys{"Up", "Down", "PageUp", "F12", "x"}));
}

TEST(KeyReader, LeavesOutWhatIsNoKey) {
  EXPECT_EQ(ReadKeys(""), Keys{});
  EXPECT_EQ(ReadKeys("\x1b[99~a"), Keys{"a"});  // an unknown sequence
  EXPECT_EQ(ReadKeys("\x01\xff\xc3(b"), (Keys{"(", "b"}));
  EXPECT_EQ(ReadKeys(std::string_view("\x1b[", 2)), (Keys{"Escape", "["}));
}

TEST(KeyReader, KnowsTheNamesThatItGives) {
  for (const char* name : {"a", "\xc3\xa9", "Space", "Escape", "F12", "PageDown"}) {
    EXPECT_TRUE(IsKeyName(name)) << name;
  }
  for (const char* name : {"", " ", "ab", "F13", "space"}) EXPECT_FALSE(IsKeyName(name)) << name;
}

}  // namespace
}  // namespace moontrace

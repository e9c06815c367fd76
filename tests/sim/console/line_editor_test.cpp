#include "sim/console/line_editor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace moontrace {
namespace {

using Texts = std::vector<std::string>;

/// What a terminal shows of an echo: backspaces go back, what is written there covers.
std::string Shown(const std::string& echo) {
  std::string shown;
  std::size_t at = 0;
  for (const char c : echo) {
    if (c == '\b') {
      --at;
    } else {
      shown.resize(std::max(shown.size(), at + 1), ' ');
      shown[at++] = c;
    }
  }
  while (!shown.empty() && shown.back() == ' ') shown.pop_back();
  return shown;
}

TEST(LineEditor, GivesLinesAndShowsWhatIsTyped) {
  LineEditor editor(100);
  const auto typed = editor.Take("next\rwhe");
  EXPECT_EQ(typed.lines, Texts{"next"});
  EXPECT_EQ(typed.echo, "next\nwhe");
  EXPECT_EQ(editor.Take("re\n").lines, Texts{"where"});
}

TEST(LineEditor, BringsEarlierLinesBackWithTheUpArrow) {
  LineEditor editor(100);
  editor.Take("one\ntwo\nthr");
  EXPECT_EQ(Shown("thr" + editor.Take("\x1b[A").echo), "two");
  EXPECT_EQ(Shown("two" + editor.Take("\x1bOA").echo), "one");
  EXPECT_EQ(editor.Take("\x1b[A").echo, "");  // there is none before
  EXPECT_EQ(Shown("one" + editor.Take("\x1b[B").echo), "two");
  EXPECT_EQ(Shown("two" + editor.Take("\x1b[B").echo), "thr");  // what was begun is not lost
  EXPECT_EQ(editor.Take("\x1b[A\n").lines, Texts{"two"});
}

TEST(LineEditor, PrintsNothingForOtherKeys) {
  LineEditor editor(100);
  for (const char* key : {"\x1b[C", "\x1b[D", "\x1b[H", "\x1b[1;5C", "\x1b[5~", "\x1bOP", "\t",
                          "\x01", "\x1b\x1b[99~"}) {
    EXPECT_EQ(editor.Take(key).echo, "") << key + 1;
  }
  EXPECT_EQ(editor.Take("a\n").lines, Texts{"a"});
}

TEST(LineEditor, PutsKeysTogetherThatComeInPieces) {
  LineEditor editor(100);
  editor.Take("one\n");
  EXPECT_EQ(editor.Take("\x1b").echo, "");
  EXPECT_TRUE(editor.holds());
  EXPECT_EQ(editor.Take("[").echo, "");
  EXPECT_EQ(editor.Take("A").echo, "one");
  EXPECT_EQ(editor.Take("\xc3").echo, "");
  EXPECT_EQ(editor.Take("\xa9\n").lines, Texts{"one\xc3\xa9"});
  editor.Take("\x1b");
  editor.ForgetBegun();  // Escape alone: what follows is typed
  EXPECT_EQ(editor.Take("[A\n").lines, Texts{"[A"});
}

TEST(LineEditor, TakesAwayCharactersWordsAndAll) {
  LineEditor editor(100);
  const std::string echo = editor.Take("cafe\x7f\x7f").echo;
  EXPECT_EQ(Shown(echo), "ca");
  EXPECT_EQ(editor.Take("f\xc3\xa9\x7f").echo, "f\xc3\xa9\b \b");  // a character, not a byte
  editor.Take("\x7f");
  EXPECT_EQ(editor.Take("\n").lines, Texts{"ca"});
  EXPECT_EQ(editor.Take("find the moon\x17\x17\n").lines, Texts{"find "});
  EXPECT_EQ(editor.Take("find\x15go\n").lines, Texts{"go"});
  EXPECT_EQ(editor.Take("\b\b\n").lines, Texts{""});
}

TEST(LineEditor, EndsAtCtrlDOnAnEmptyLineOnly) {
  LineEditor editor(100);
  EXPECT_FALSE(editor.Take("a\x04").ended);
  EXPECT_TRUE(editor.Take("\x7f\x04").ended);
  // typed before the terminal was the program's, the system gives it as a zero
  EXPECT_TRUE(LineEditor(100).Take(std::string_view("\0", 1), true).ended);
}

// Ctrl-@, or Ctrl and the space bar, ended the lesson.
TEST(LineEditor, TakesNoNoticeOfCtrlAt) {
  LineEditor editor(100);
  const auto typed = editor.Take(std::string_view("\0", 1));
  EXPECT_FALSE(typed.ended);
  EXPECT_EQ(typed.echo, "");
  EXPECT_EQ(editor.Take(std::string_view("a\0b\n", 4)).lines, Texts{"ab"});
}

TEST(LineEditor, LeavesOutWhatIsBeyondTheLongestLine) {
  LineEditor editor(5);
  EXPECT_EQ(editor.Take("1234567\n").lines, Texts{"12345"});
}

}  // namespace
}  // namespace moontrace

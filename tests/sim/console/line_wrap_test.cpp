#include "sim/console/line_wrap.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/console/console.h"

namespace moontrace {
namespace {

using List = std::vector<std::string>;

TEST(Wrapped, BreaksBetweenWordsWhereTheNextWouldPassTheColumns) {
  EXPECT_EQ(Wrapped("one two three", 7), "one two\nthree\n");
  EXPECT_EQ(Wrapped("one two three", 6), "one\ntwo\nthree\n");
  EXPECT_EQ(Wrapped("unbreakable", 4), "unbreakable\n") << "a long word stands alone";
  EXPECT_EQ(Wrapped("caf\u00e9s t\u00eate", 10), "caf\u00e9s t\u00eate\n")
      << "characters, not bytes";
  EXPECT_EQ(Wrapped("one two three", 0), "one two three\n") << "not at all";
  EXPECT_EQ(Wrapped(""), "\n");
}

TEST(Wrapped, KeepsTheLinesOfAText) {
  EXPECT_EQ(Wrapped("one two\n\nthree four\n", 8), "one two\n\nthree\nfour\n");
  EXPECT_EQ(Wrapped("one\ntwo\n", 0), "one\ntwo\n");
}

// A number heard at a line's end belongs to nothing.
TEST(Wrapped, KeepsANumberWithTheWordBehindIt) {
  EXPECT_EQ(Wrapped("Words, or their beginning or number: 1 stop, 2 next.", 40),
            "Words, or their beginning or number:\n1 stop, 2 next.\n");
  EXPECT_EQ(Wrapped("Letters of 12.5 mm", 14), "Letters of\n12.5 mm\n");
  EXPECT_EQ(Wrapped("page 1", 5), "page\n1\n") << "nothing is behind it";
  EXPECT_EQ(Wrapped("of 100 unbreakable", 8), "of 100\nunbreakable\n") << "too long together";
}

// "49 find" at a line's end is another word than "49 find next".
TEST(Wrapped, KeepsTheNumberOfAWordWithTheWholeOfIt) {
  EXPECT_EQ(Wrapped("Words: 48 find, 49 find next, 50 return.", 23),
            "Words: 48 find,\n49 find next,\n50 return.\n");
  EXPECT_EQ(Wrapped("Words: 21 lessons, 22 how am i doing, 23 brief.", 34),
            "Words: 21 lessons,\n22 how am i doing, 23 brief.\n");
  EXPECT_EQ(Wrapped("Words: 19 help, 46 more time.", 26), "Words: 19 help,\n46 more time.\n");
  EXPECT_EQ(Wrapped("Words: 22 how am i doing.", 9), "Words:\n22 how am\ni doing.\n")
      << "too long together";
  EXPECT_EQ(Wrapped("It took 9 minutes and more.", 17), "It took 9 minutes\nand more.\n")
      << "no number of a word";
}

TEST(Sentences, EndAtAMarkBeforeASpaceAndACapital) {
  EXPECT_EQ(Sentences("Feel it. It is\nupright! Is it?  Yes."),
            (List{"Feel it.", "It is upright!", "Is it?", "Yes."}));
  EXPECT_EQ(Sentences("It is 0.6 of that, e.g. here."), (List{"It is 0.6 of that, e.g. here."}));
  EXPECT_EQ(Sentences("\"Come in.\" She did. 9 May."),
            (List{"\"Come in.\"", "She did.", "9 May."}));
  EXPECT_EQ(Sentences("no mark\n"), (List{"no mark"}));
  EXPECT_EQ(Sentences(" \n "), List{});
}

TEST(Console, BreaksLinesToWhatItIsTold) {
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  std::size_t columns = 10;
  console.SetColumns([&columns] { return columns; }, [] { return std::size_t{0}; });
  console.Result("a line of words");
  columns = 0;  // the window was made wider
  console.Result("a line of words");
  console.Remark("a line of words");
  EXPECT_EQ(out.str(), "a line of\nwords\na line of words\n");
  EXPECT_EQ(err.str(), "a line of words\n");
}

}  // namespace
}  // namespace moontrace

#include "sim/app/loop_words.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/app/line_reader.h"

namespace moontrace {
namespace {

TEST(LoopWords, AreReadWholeBegunOrByNumber) {
  EXPECT_EQ(ReadLoopWord("stop"), LoopWord::kStop);
  EXPECT_EQ(ReadLoopWord(" ST "), LoopWord::kStop);
  EXPECT_EQ(ReadLoopWord("1"), LoopWord::kStop);
  EXPECT_EQ(ReadLoopWord("g"), LoopWord::kGo);
  EXPECT_EQ(ReadLoopWord("bi"), LoopWord::kBigger);
  EXPECT_EQ(ReadLoopWord("sm"), LoopWord::kSmaller);
  EXPECT_EQ(ReadLoopWord("n"), LoopWord::kNext);
  EXPECT_EQ(ReadLoopWord("6"), LoopWord::kBack);
  EXPECT_EQ(ReadLoopWord("w"), LoopWord::kWhere);
  EXPECT_EQ(ReadLoopWord("m"), LoopWord::kMark);
  EXPECT_EQ(ReadLoopWord("9"), LoopWord::kQuit);
  EXPECT_EQ(ReadLoopWord("?"), LoopWord::kHelp);
}

TEST(LoopWords, ThatAreNoneOrSeveralAreToldApart) {
  EXPECT_EQ(ReadLoopWord(""), LoopWord::kNothing);
  EXPECT_EQ(ReadLoopWord(" \t"), LoopWord::kNothing);
  EXPECT_EQ(ReadLoopWord("10"), LoopWord::kUnknown);
  EXPECT_EQ(ReadLoopWord("stopp"), LoopWord::kUnknown);
  EXPECT_EQ(ReadLoopWord("s"), LoopWord::kAmbiguous);
  EXPECT_EQ(LoopWordsFrom("s"), (std::vector<std::string>{"stop", "smaller"}));
}

TEST(LineReader, GivesLinesAndAtTheirEndNothing) {
  std::istringstream in("one\r\n\ntwo");
  LineReader lines(in);
  EXPECT_EQ(lines.Next(0), "one");
  EXPECT_EQ(lines.Next(0), "");
  EXPECT_EQ(lines.Next(0), "two");
  EXPECT_EQ(lines.Next(0), std::nullopt);
  EXPECT_EQ(lines.Next(0), std::nullopt);
}

}  // namespace
}  // namespace moontrace

#include "sim/session/loop_words.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/console/line_reader.h"
#include "sim/console/vocabulary.h"

namespace moontrace {
namespace {

LoopWord Read(std::string_view line) { return ReadLoopLine(line).word; }
std::string Refused(std::string_view line) { return ReadLoopLine(line).refusal; }

TEST(LoopWords, AreReadWholeBegunOrByNumber) {
  EXPECT_EQ(Read("stop"), LoopWord::kStop);
  EXPECT_EQ(Read(" ST "), LoopWord::kStop);
  EXPECT_EQ(Read("1"), LoopWord::kStop);
  EXPECT_EQ(Read("g"), LoopWord::kGo);
  EXPECT_EQ(Read("bi"), LoopWord::kBigger);
  EXPECT_EQ(Read("sm"), LoopWord::kSmaller);
  EXPECT_EQ(Read("n"), LoopWord::kNext);
  EXPECT_EQ(Read("26"), LoopWord::kBack);
  EXPECT_EQ(Read("wh"), LoopWord::kWhere);
  EXPECT_EQ(Read("ma"), LoopWord::kMark);
  EXPECT_EQ(Read("18"), LoopWord::kQuit);
  EXPECT_EQ(Read("pau"), LoopWord::kPause);
  EXPECT_EQ(Read("16"), LoopWord::kPause);
  EXPECT_EQ(Read("?"), LoopWord::kHelp);
  EXPECT_EQ(Read("help"), LoopWord::kHelp);
  EXPECT_EQ(ReadLoopLine("help next").text, "next");
}

TEST(LoopWords, AreAllObeyed) {
  for (const TypedWord& word : Vocabulary()) {
    if (!word.HoldsIn(WordPlace::kLoop)) continue;
    const std::string line = std::string(word.word) + " " + std::string(word.behind);
    const LoopLine read = ReadLoopLine(line);
    EXPECT_LT(read.word, LoopWord::kNothing) << line << read.refusal;
  }
}

TEST(LoopWords, ChangeThePage) {
  for (std::size_t i = 0; i < PageWords().size(); ++i) {
    const std::string number = std::to_string(WordNamed(PageWords()[i])->number);
    const std::string behind[] = {"", " 2", " arc", " sine"};
    int taken = 0;
    for (const std::string& more : behind) {
      const LoopLine by_name = ReadLoopLine(PageWords()[i] + more);
      const LoopLine by_number = ReadLoopLine(number + more);
      ASSERT_EQ(by_name.word, by_number.word) << PageWords()[i] + more;
      if (by_name.word != LoopWord::kPage) continue;
      ++taken;
      EXPECT_EQ(by_name.page.word, static_cast<PageWord>(i));
      EXPECT_EQ(by_number.page.word, static_cast<PageWord>(i));
    }
    EXPECT_GE(taken, 1) << PageWords()[i];
  }
  EXPECT_DOUBLE_EQ(ReadLoopLine("size 2 cm").page.value, 0.02);
  EXPECT_EQ(Refused("size"), "size lacks what it wants: mm, 1 to 1000.");
}

TEST(LoopWords, ThatAreNoneOrSeveralAreToldApart) {
  EXPECT_EQ(Read(""), LoopWord::kNothing);
  EXPECT_EQ(Read(" \t"), LoopWord::kNothing);
  EXPECT_EQ(Refused("99"), "Unknown: 99. Say ? for the words.");
  EXPECT_EQ(Refused("pause now"), "Say pause alone, without now.");
  EXPECT_EQ(Read("stop now"), LoopWord::kStop);
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

#include "sim/learn/learn_keys.h"

#include <gtest/gtest.h>

#include "sim/learn/learn_words.h"
#include "tests/sim/learn_fixture.h"
#include "tests/sim/pty_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

class LearnKeys : public LearnTest {
 protected:
  KeyMap Load(const std::string& text) {
    WriteAll(In("keys.toml"), text);
    return LoadKeys(In("keys.toml"));
  }
  std::string WhyNot(const std::string& text) {
    try {
      Load(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(LearnKeys, EveryWordHasOneOfItsOwn) {
  std::vector<std::string> reached;
  for (const auto& key : UsualKeys()) {
    if (key.first != "F1") reached.push_back(key.second);
  }
  std::vector<std::string> words = LearnWords();
  std::sort(reached.begin(), reached.end());
  std::sort(words.begin(), words.end());
  EXPECT_EQ(reached, words);
  EXPECT_EQ(UsualKeys().at("Escape"), "stop");
  EXPECT_EQ(UsualKeys().at("Space"), "pause");
}

TEST_F(LearnKeys, AFileChangesThem) {
  const KeyMap keys = Load("again = \"x\"\n\"more help\" = \"PageUp\"\n");
  EXPECT_EQ(keys.at("x"), "again");
  EXPECT_EQ(keys.at("PageUp"), "more help");
  EXPECT_EQ(keys.count("r"), 0U);
  EXPECT_EQ(keys.at("n"), "next");
}

TEST_F(LearnKeys, AFileThatCannotBeUsedSaysWhereAndWhy) {
  const std::string conflict = WhyNot("again = \"n\"\nwhere = \"q\"\n");
  EXPECT_NE(conflict.find("n is again and next"), std::string::npos) << conflict;
  EXPECT_NE(conflict.find("q is where and quit"), std::string::npos) << conflict;
  EXPECT_NE(WhyNot("agian = \"x\"\n").find("again"), std::string::npos);
  EXPECT_NE(WhyNot("again = \"xx\"\n").find(":1:9"), std::string::npos);
  EXPECT_NE(WhyNot("stop = \"x\"\n").find("Escape always stops"), std::string::npos);
  EXPECT_NE(WhyNot("again = \n").find(":1:"), std::string::npos);
}

TEST_F(LearnKeys, MakeWordsAtOnceAndAnswersWithEnter) {
  KeyLines lines(UsualKeys());
  EXPECT_EQ(lines.Take("r", false).line, "/again");
  EXPECT_EQ(lines.Take("Enter", false).line, "");
  EXPECT_EQ(lines.Take("x", false).line, "/x");  // unknown words are answered so
  for (const char* key : {"c", "a"}) EXPECT_FALSE(lines.Take(key, true).line);
  const KeyLines::Result back = lines.Take("Backspace", true);
  EXPECT_EQ(back.echo, "\nc");  // on a line of its own: nothing is overwritten
  lines.Take("h", true);
  EXPECT_EQ(lines.Take("Enter", true).line, "ch");
  lines.Take("q", true);
  EXPECT_EQ(lines.Take("Escape", true).line, "/stop");  // drops what was begun
  EXPECT_EQ(lines.Take("Space", true).line, "/pause");
}

TEST_F(LearnKeys, TheTypedWordStopsToo) {
  KeyLines lines(UsualKeys());
  for (const char* key : {"s", "t", "o"}) lines.Take(key, false);
  EXPECT_EQ(lines.Take("p", false).line, "/stop");  // not back
  EXPECT_EQ(lines.Take("Enter", false).line, "");
  for (const char* key : {"x", "S", "t", "o"}) lines.Take(key, false);
  EXPECT_EQ(lines.Take("p", false).line, "/stop");
  for (const char* key : {"s", "t", "Enter", "o"}) lines.Take(key, false);
  EXPECT_EQ(lines.Take("p", false).line, "/back");
  for (const char* key : {"s", "t", "o", "p"}) EXPECT_FALSE(lines.Take(key, true).line) << key;
  EXPECT_EQ(lines.Take("Enter", true).line, "stop");  // which is always a word
}

TEST_F(LearnKeys, ATypedStopStopsAndSentencesNameTheKeys) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session(Learn({"--keys"}), 200);
  ASSERT_TRUE(session.WaitFor("press n to go on.")) << session.all();
  session.Send("stop\n");
  EXPECT_TRUE(session.WaitFor("Stopped. Press g to go on.")) << session.all();
  session.Send("g");
  EXPECT_TRUE(session.WaitFor("Going on.")) << session.all();
  session.Send("?");
  EXPECT_TRUE(session.WaitFor("Escape stop")) << session.all();
  session.Send("q");
  EXPECT_EQ(session.Wait(), 0);
  EXPECT_EQ(session.all().find("say next"), std::string::npos) << session.all();
}

TEST_F(LearnKeys, AreRefusedInAPipe) {
  const Outcome outcome = RunLine(Learn({"--keys"}), "q");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
}

TEST_F(LearnKeys, WorkAtATerminalWhichIsAsItWasOnEveryWayOut) {
  SKIP_WITHOUT_TERMINALS();
  for (const int by : {0, SIGTERM, SIGSEGV}) {
    PtySession session(Learn({"--keys"}));
    EXPECT_TRUE(session.WaitFor("? tells the keys")) << session.all();
    ASSERT_TRUE(session.WaitFor("press n to go on.")) << session.all();
    EXPECT_FALSE(session.echoes());
    session.Send("w");
    EXPECT_TRUE(session.WaitFor("step 1 of 8")) << session.all();
    session.Send("\x1b");
    EXPECT_TRUE(session.WaitFor("Stopped. Press g")) << session.all();
    if (by == 0) {
      session.Send("q");
      EXPECT_EQ(session.Wait(), 0);
    } else {
      session.Kill(by);
    }
    EXPECT_TRUE(session.terminal_is_usual()) << by;
    ExpectStream(session.all());
  }
}

}  // namespace
}  // namespace moontrace

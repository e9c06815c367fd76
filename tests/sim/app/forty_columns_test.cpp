// What a Braille display of forty cells shows: no line is longer, and no word is cut.
#include <gtest/gtest.h>

#include "sim/learn/learn_options.h"
#include "tests/sim/learn_fixture.h"
#include "tests/sim/pty_fixture.h"

namespace moontrace {
namespace {

constexpr unsigned short kCells = 40;

std::vector<std::string> WordsOf(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// A path or an address stands alone on its line, whole.
void ExpectCells(std::string all) {
  std::erase(all, '\r');
  for (const std::string& line : Lines(all)) {
    EXPECT_TRUE(WordsOf(line).size() == 1 || Characters(line) <= kCells) << line;
  }
}

class FortyColumns : public LearnTest {
 protected:
  std::string Said(const std::vector<std::string>& args, const std::string& typed = "") {
    PtySession session(args, kCells);
    if (!typed.empty()) session.Send(typed);
    session.Wait();
    return session.all();
  }
};

TEST_F(FortyColumns, HelpAndErrorsAreBrokenBetweenWords) {
  SKIP_WITHOUT_TERMINALS();
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{},
        {"help"},
        {"help", "learn"},
        {"help", "loop"},
        {"loop", "--help-all"},
        {"learn", "--help-all"},
        {"tutor", "--help"},
        {"pge"},
        {"loop", "--rate-hz", "1"},
        {"loop", "--colour", "red"},
        {"loop", "moon", "--device", "no-such-device"},
        {"page", "--file", In("none.txt")},
        {"learn", "--lesson", "3"},
        {"tutor", "--learner", "nobody"},
        {"records", "erase", "nobody", "--records", In("records.sqlite")}}) {
    const std::string narrow = Said(args);
    ExpectCells(narrow);
    const Outcome wide = RunLine(args);
    EXPECT_EQ(WordsOf(narrow), WordsOf(wide.out + wide.err)) << narrow;
  }
}

TEST_F(FortyColumns, ALoopFits) {
  SKIP_WITHOUT_TERMINALS();
  const std::string said = Said({"loop", "MOON NOON", "--page", "60x40", "--size-mm", "20"},
                                "?\nhelp next\nwhere\nnext\nnext\nback\nback\nbigger\nsmaller\n"
                                "fly\ns\nfind noon\nfind next\nreturn\nnext line\nnext heading\n"
                                "size 900\nform star\ntilt 10\nstop\nwhere\ngo\nmark\nquit\n");
  EXPECT_NE(said.find("Ran "), std::string::npos) << said;
  ExpectCells(said);
}

TEST_F(FortyColumns, ALessonFits) {
  SKIP_WITHOUT_TERMINALS();
  std::vector<std::string> args = Learn();
  args[2] = LearnOptions().course;  // the shipped one
  const std::string said =
      Said(args,
           "?\nwhere\nlessons\nhow am i doing\nnext\nhint\nfind t\nfly\nstop\nwhere\ngo\n"
           "lesson 3\nnext\nt\n/bigger\n/smaller\nmy text the cat sat\nfind cat\nquit\n");
  EXPECT_NE(said.find("Ended: "), std::string::npos) << said;
  ExpectCells(said);
}

TEST_F(FortyColumns, ADemonstrationFits) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session({"learn", "--device", "simulated"}, kCells);
  for (int i = 0; i < 90; ++i) session.Send("next\n");
  ASSERT_TRUE(session.WaitFor("Goodbye")) << session.all();
  session.Wait();
  ExpectCells(session.all());
}

}  // namespace
}  // namespace moontrace

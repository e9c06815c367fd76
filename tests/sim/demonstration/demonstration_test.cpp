// What who has no device is told: the shipped demonstration, by a clock of the test's own.
#include "sim/demonstration/demonstration.h"

#include <algorithm>
#include <map>

#include "sim/demonstration/demonstration_messages.h"
#include "sim/learn/learn_stage.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/cli_fixture.h"
#include "tests/sim/pty_fixture.h"
#include "tests/source_path.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

using std::chrono::seconds;

std::string FaultOf(const std::string& toml) {
  try {
    ParseDemonstration(toml, "demo.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(DemonstrationScript, EachFaultIsOneLineWithPlaceAndCure) {
  EXPECT_EQ(FaultOf(""), "demo.toml:1:1: steps: none; give one [[steps]] at least");
  EXPECT_EQ(FaultOf("[[steps]]\nsay = \"a\"\nright = \"yes\"\n"),
            "demo.toml:3:9: right: nothing is asked; give ask, or leave it out");
  EXPECT_EQ(FaultOf("[[steps]]\nask = \"a?\"\nanswers = []\nright = \"yes\"\nwrong = \"no\"\n"),
            "demo.toml:3:11: answers: empty; give one answer at least");
  EXPECT_EQ(FaultOf("[[steps]]\nsey = \"a\"\n").substr(0, 32), "demo.toml:2:1: unknown key 'sey'");
  EXPECT_EQ(FaultOf("[[steps]]\nsay = \"a\"\nsize_mm = 0\n").substr(0, 23),
            "demo.toml:3:11: size_mm");
}

/// Lines as they are written, with a clock that the test sets.
class DemonstrationTest : public testing::Test {
 protected:
  DemonstrationTest()
      : console_(in_, out_, err_),
        teller_(console_, nullptr, nullptr),
        stage_(Options(), console_),
        demonstration_(steps_, stage_, teller_, say::DemonstrationHelp()) {}
  ~DemonstrationTest() override { stage_.session().loop().End(); }

  static StageOptions Options() {
    StageOptions options;
    options.live.device = "simulated";
    return options;
  }
  /// Looks each second until `text` has been said, or it is over; how long that took [s].
  int Until(const std::string& text) {
    int passed = 0;
    for (; !demonstration_.over() && Said(text) == 0 && passed < 3600; ++passed) Pass(1);
    return passed;
  }
  void Pass(int count) {
    for (int i = 0; i < count; ++i) {
      now_ += seconds(1);
      demonstration_.Look(now_);
    }
  }
  /// How often, in all that was said since Forget; lines are wrapped.
  std::size_t Said(const std::string& text) const {
    std::string said = out_.str().substr(from_);
    for (char& c : said) c = c == '\n' ? ' ' : c;
    std::size_t count = 0;
    for (auto at = said.find(text); at != std::string::npos; at = said.find(text, at + 1)) ++count;
    return count;
  }
  void Forget() { from_ = out_.str().size(); }

  std::istringstream in_;
  std::ostringstream out_, err_;
  std::size_t from_ = 0;
  Console console_;
  LearnTeller teller_;
  const std::vector<DemonstrationStep> steps_ = ShippedDemonstration();
  LearnStage stage_;
  Demonstration demonstration_;
  Demonstration::Clock::time_point now_ = Demonstration::Clock::now();
};

TEST_F(DemonstrationTest, GoesOnByItselfForSomeNineMinutesAndSaysNothingTwice) {
  const int passed = Until("Goodbye");
  EXPECT_GT(passed, 8 * 60);
  EXPECT_LT(passed, 10 * 60);
  std::map<std::string, int> times;
  for (const std::string& line : Lines(out_.str())) {
    if (line.size() <= 20) continue;
    EXPECT_EQ(++times[line], 1) << line;
  }
  Pass(20);
  EXPECT_TRUE(demonstration_.over());
}

TEST_F(DemonstrationTest, AwaitsAnAnswerForHalfAMinute) {
  Until("which letter is it");
  EXPECT_TRUE(demonstration_.asks());
  Pass(28);
  EXPECT_EQ(Said("It is T: the level one"), 0U);
  Pass(3);
  EXPECT_EQ(Said("It is T: the level one"), 1U) << "told to who does not answer";
  EXPECT_FALSE(demonstration_.asks());
  EXPECT_EQ(Said("Wrong"), 0U) << "nobody was wrong";
}

TEST_F(DemonstrationTest, TellsItsWordsWithTheirNumbersAndNoOthers) {
  Pass(2);
  Forget();
  demonstration_.Obey("?");
  EXPECT_EQ(Said("stop 1, next 2, again 14, go 15, pause 16, quit 18, help 19, more time 46."), 1U)
      << out_.str().substr(from_);
  Forget();
  demonstration_.Obey("7");
  EXPECT_EQ(Said("7 is no word here."), 1U) << out_.str().substr(from_);
  EXPECT_EQ(Said("bigger"), 0U) << "nobody typed that";
}

TEST_F(DemonstrationTest, GoesOnOnceAnAnswerToAWordHasBeenHeard) {
  Pass(2);
  const std::size_t before = Lines(out_.str()).size();
  demonstration_.Obey("?");
  const std::size_t told = Lines(out_.str()).size();
  EXPECT_GT(told, before);
  Pass(9);  // of the some twelve seconds that its 160 letters take
  EXPECT_EQ(Lines(out_.str()).size(), told);
  Pass(9);
  EXPECT_GT(Lines(out_.str()).size(), told);
}

TEST_F(DemonstrationTest, TellsRightAnswersFromWrongOnes) {
  Until("which letter is it");
  demonstration_.Obey(" T! ");
  EXPECT_EQ(Said("Right, T."), 1U);
  EXPECT_FALSE(demonstration_.asks());
  Until("which letter is that?");
  demonstration_.Obey("t");
  EXPECT_EQ(Said("Wrong: you said t. It is L"), 1U);
  EXPECT_EQ(Said("It is L"), 2U) << "once when it was shown, once now";
  Until("What is the first letter?");
  Forget();
  demonstration_.Obey("it is the letter T");
  EXPECT_EQ(Said("Yes."), 1U) << "as in a lesson";
  Until("Second letter");
  demonstration_.Obey("e");
  EXPECT_EQ(Said("Wrong: you said e."), 1U) << "a sign is an answer, whatever was told";
  Until("Third letter");
  demonstration_.Obey("lot");
  EXPECT_EQ(Said("Wrong: you said lot."), 1U) << "so is a word of signs that were told";
  Until("what is the word?");
  demonstration_.Obey("toil");
  EXPECT_EQ(Said("Toil it is."), 1U);
}

TEST_F(DemonstrationTest, YesIsWhatItAskedWhetherItWasMeant) {
  Pass(2);
  demonstration_.Obey("qiut");
  EXPECT_EQ(Said("Did you mean quit?"), 1U) << out_.str();
  demonstration_.Obey("yes");
  EXPECT_TRUE(demonstration_.over());
}

TEST_F(DemonstrationTest, AQuestionInBetweenIsWhatYesIsSaidTo) {
  Pass(2);
  demonstration_.Obey("qiut");
  Until("which letter is it");
  demonstration_.Obey("yes");
  EXPECT_FALSE(demonstration_.over());
}

TEST_F(DemonstrationTest, ALetterMayBeCalledAsItIsSpoken) {
  Until("which letter is it");
  demonstration_.Obey("tee");
  EXPECT_EQ(Said("Right, T."), 1U) << out_.str().substr(from_);
  Until("which letter is that?");
  demonstration_.Obey("oh");
  EXPECT_EQ(Said("Wrong: you said o. It is L"), 1U) << out_.str().substr(from_);
  Until("What is the first letter?");
  demonstration_.Obey("is it i");
  EXPECT_EQ(Said("Wrong: you said i."), 1U) << out_.str().substr(from_);
}

TEST_F(DemonstrationTest, AHintIsTheWayOnceMoreAndSlowerIsMoreTime) {
  Until("What is the first letter?");
  Forget();
  demonstration_.Obey("hint");
  EXPECT_EQ(Said("level, from left to right. What is the first letter?"), 1U)
      << out_.str().substr(from_);
  demonstration_.Obey("slower");
  EXPECT_EQ(Said("More time from now on."), 1U) << out_.str().substr(from_);
  EXPECT_TRUE(demonstration_.asks());
}

// A command line that is only heard cannot be typed.
TEST_F(DemonstrationTest, TheWayOnIsAskedForBeforeItIsTold) {
  for (const auto& [given, way] : {std::pair{"1", "mouse"},
                                   {"paper", "paper"},
                                   {"3.", "device"},
                                   {"the mouse", "mouse"},
                                   {"quit", ""}}) {
    Demonstration one(steps_, stage_, teller_, say::DemonstrationHelp());
    Forget();
    for (int i = 0; i < 3600 && Said("Say 1, 2 or 3, or its word") == 0; ++i) {
      one.Look(now_ += seconds(1));
      if (one.asks() && Said("Say 1, 2 or 3, or its word") == 0) one.Obey("next");
    }
    EXPECT_FALSE(one.over());
    one.Obey(given);
    EXPECT_TRUE(one.over()) << given;
    EXPECT_EQ(one.way(), way) << given;
  }
}

TEST_F(DemonstrationTest, WhoKnowsAndForgetsTheNameIsAskedForIt) {
  Until("which letter is it");
  Forget();
  demonstration_.Obey("I know");
  EXPECT_EQ(Said("Say the name."), 1U) << out_.str().substr(from_);
  EXPECT_EQ(Said("Unknown"), 0U);
  EXPECT_TRUE(demonstration_.asks());
}

TEST_F(DemonstrationTest, NoPrintTellsWhatIsAskedOfThePage) {
  EXPECT_FALSE(demonstration_.hides());
  Until("which letter is it");
  EXPECT_TRUE(demonstration_.hides());
  demonstration_.Obey("t");
  EXPECT_FALSE(demonstration_.hides());
  Until("What is the first letter?");
  demonstration_.Obey("t");
  EXPECT_TRUE(demonstration_.hides()) << "the next letters of that page are asked, too";
  Until("what is the word?");
  demonstration_.Obey("toil");
  EXPECT_FALSE(demonstration_.hides());
}

TEST_F(DemonstrationTest, OnlyAnswersAreAnswers) {
  Until("which letter is it");
  for (const char* line : {"repeat", "where", "5", "bigger", "hello there", "t or i"}) {
    Forget();
    demonstration_.Obey(line);
    EXPECT_TRUE(demonstration_.asks()) << line;
    EXPECT_EQ(Said("Wrong"), 0U) << line;
    EXPECT_EQ(Said("One level line: which letter is it"), 1U) << "asked again: " << line;
  }
  Pass(25);
  EXPECT_TRUE(demonstration_.asks()) << "who says something has time anew";
  demonstration_.Obey("2");
  Pass(1);
  EXPECT_FALSE(demonstration_.asks()) << "2 is next, as ? tells";
  EXPECT_EQ(Said("Wrong"), 0U);
}

TEST_F(DemonstrationTest, WhoDoesNotKnowIsToldAndNotWrong) {
  Until("which letter is it");
  demonstration_.Obey("I don't know.");
  EXPECT_EQ(Said("It is T: the level one."), 1U) << out_.str().substr(from_);
  EXPECT_EQ(Said("Wrong"), 0U);
  EXPECT_FALSE(demonstration_.asks());
}

TEST_F(DemonstrationTest, AnAnswerThatComesLateCountsForNoOtherQuestion) {
  Until("What is the first letter?");
  Until("Level: that was T.");  // nobody answered in time
  Forget();
  demonstration_.Obey("t");
  EXPECT_EQ(Said("That came too late for the question before."), 1U) << out_.str().substr(from_);
  Until("Second letter");
  Until("A ring is O.");
  Until("Third letter");
  Forget();
  demonstration_.Obey("o");  // right for the one before
  EXPECT_EQ(Said("Wrong"), 0U) << out_.str().substr(from_);
  EXPECT_EQ(Said("Third letter"), 1U) << "it is still asked";
  EXPECT_TRUE(demonstration_.asks());
  demonstration_.Obey("l");
  EXPECT_EQ(Said("Wrong: you said l."), 1U) << "the next one counts";
  Until("Fourth letter");
  Until("A corner at the foot is L.");
  Until("what is the word?");
  Forget();
  demonstration_.Obey("i");  // typed before the question could be heard
  EXPECT_EQ(Said("Wrong"), 0U) << out_.str().substr(from_);
  demonstration_.Obey("toil");
  EXPECT_EQ(Said("Toil it is."), 1U);
}

TEST_F(DemonstrationTest, AWholeWordIsAnsweredByAnyWordAndMayBeSpelled) {
  for (const auto& [given, answer] : {std::pair{"foil", "Wrong: you said foil. The word is toil"},
                                      {"T, O, I, L", "Toil it is."},
                                      {"t o i l", "Toil it is."},
                                      {"the word is toil", "Toil it is."}}) {
    Demonstration one(steps_, stage_, teller_, say::DemonstrationHelp());
    Forget();
    for (int i = 0; i < 3600 && Said("what is the word?") == 0; ++i) {
      one.Look(now_ += seconds(1));
      if (one.asks() && Said("what is the word?") == 0) one.Obey("next");
    }
    for (int i = 0; i < 5; ++i) one.Look(now_ += seconds(1));  // it has been heard
    one.Obey("t");
    EXPECT_EQ(Said("The whole word is asked. And what is the word?"), 1U)
        << out_.str().substr(from_);
    for (const char* slip : {"pasue", "nexxt"}) {
      one.Obey(slip);
      EXPECT_TRUE(one.asks()) << slip;
      EXPECT_EQ(Said(std::string("Unknown: ") + slip + ". Did you mean"), 1U) << slip;
    }
    one.Obey(given);
    EXPECT_EQ(Said(answer), 1U) << given << out_.str().substr(from_);
    EXPECT_EQ(Said("too late"), 0U) << "what was skipped is not awaited";
  }
}

TEST_F(DemonstrationTest, AfterAPauseAQuestionIsAskedAnew) {
  Until("which letter is it");
  Pass(25);
  Forget();
  demonstration_.Obey("pause");
  Pass(100);
  demonstration_.Obey("go");
  EXPECT_EQ(Said("Going on. One level line: which letter is it"), 1U) << out_.str().substr(from_);
  Pass(28);
  EXPECT_TRUE(demonstration_.asks()) << "with all its time";
}

TEST_F(DemonstrationTest, WhatIsNoAnswerNowIsCalledSo) {
  Until("It is I, as in print.");
  for (const char* line : {"i", "I don't know"}) {
    Forget();
    demonstration_.Obey(line);
    EXPECT_EQ(Said("Nothing is asked now."), 1U) << line << out_.str().substr(from_);
  }
  demonstration_.Obey("pause");
  demonstration_.Obey("i");
  EXPECT_EQ(Said("Nothing is asked now: say go."), 1U) << out_.str().substr(from_);
}

// What is told as "It is X" or "It is X, as in print" is asked for later, alone.
TEST_F(DemonstrationTest, AsksForEveryLetterThatItTells) {
  std::string told, asked;
  for (const DemonstrationStep& step : steps_) {
    for (const std::string& line : step.say) {
      if (line.size() > 7 && line.compare(0, 6, "It is ") == 0) told += line[6];
    }
    if (step.answers.empty()) continue;
    const std::string& first = step.answers.front();
    if (first.size() == 1) asked += static_cast<char>(first[0] - 'a' + 'A');
  }
  EXPECT_EQ(told, "ITLO");
  for (const char letter : told) EXPECT_NE(asked.find(letter), std::string::npos) << letter;
}

TEST_F(DemonstrationTest, AWordOfTheLearnersIsAWordWhileSomethingIsAsked) {
  Until("which letter is it");
  demonstration_.Obey("more time");
  Pass(40);
  EXPECT_TRUE(demonstration_.asks()) << "45 seconds now";
  demonstration_.Obey("again");
  EXPECT_EQ(Said("One level line: which letter is it"), 2U);
  demonstration_.Obey("pau");
  Pass(3600);
  EXPECT_TRUE(demonstration_.asks()) << "nothing passes in a pause";
  demonstration_.Obey("go");
  demonstration_.Obey("next");
  Pass(1);
  EXPECT_FALSE(demonstration_.asks());
}

TEST_F(DemonstrationTest, EveryLineIsAnswered) {
  Pass(2);
  for (const char* line : {"", "?", "help", "xyzzy", "next", "pause", "", "go", "go", "stop",
                           "next", "again", "more time", "\t", "!!!", "\x1b[31m"}) {
    Forget();
    demonstration_.Obey(line);
    Pass(1);
    EXPECT_GT(out_.str().size(), from_) << line;
    EXPECT_EQ(out_.str().find('\x1b'), std::string::npos);
  }
  Forget();
  demonstration_.Obey("quit");
  EXPECT_EQ(Said("The demonstration ends here. moontrace learn --device simulated begins it"), 1U);
  EXPECT_TRUE(demonstration_.over());
}

TEST_F(DemonstrationTest, WhatIsSaidFitsWhatIsShownAndAsked) {
  for (const DemonstrationStep& step : steps_) {
    for (const std::string& answer : step.answers) {
      EXPECT_EQ(answer.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), std::string::npos) << answer;
    }
    for (const std::string& line : step.say) EXPECT_LT(line.size(), 140u) << line;
  }
}

// A Braille display of forty cells: no line is longer, and no word is cut.
TEST(LearnWithoutADevice, FitsATerminalOfFortyColumns) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session({"learn", "--device", "simulated"}, 40);
  ASSERT_TRUE(session.WaitFor("Welcome.")) << session.all();
  std::string words, kept = ReadAll(SourcePath("tests/data/demonstration.txt"));
  const auto lines = static_cast<int>(std::count(kept.begin(), kept.end(), '\n'));
  for (int i = 0; i < lines && session.all().find("Goodbye") == std::string::npos; ++i) {
    session.Send("next\n");  // goes on at once
    session.ReadFor(30);
  }
  EXPECT_EQ(session.Wait(), 0);
  for (std::string line : Lines(session.all())) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    EXPECT_LE(Characters(line), 40U) << line;
    if (line != "next") words += line + ' ';
  }
  std::replace(kept.begin(), kept.end(), '\n', ' ');
  EXPECT_EQ(words, kept);
}

TEST(LearnWithoutADevice, EndsAtATerminalWhoseInputIsEnded) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session({"learn", "--device", "simulated"});
  ASSERT_TRUE(session.WaitFor("Welcome.")) << session.all();
  session.Send("\x04");
  EXPECT_EQ(session.Wait(), 0);
  EXPECT_NE(session.all().find("End of input: the demonstration ends."), std::string::npos);
  EXPECT_EQ(session.all().find("Goodbye"), std::string::npos) << "all the rest at once";
}

TEST(LearnWithoutADevice, OffersTheDemonstrationAtATerminal) {
  SKIP_WITHOUT_TERMINALS();
  const FakeHid none("");
  PtySession yes({"learn"});
  ASSERT_TRUE(yes.WaitFor("What shall begin?")) << yes.all();
  EXPECT_EQ(yes.all().find("moontrace learn"), std::string::npos) << "asked first";
  yes.Send("what?\n");
  ASSERT_TRUE(yes.WaitFor("asks a few questions")) << yes.all();
  yes.Send("1\n");
  ASSERT_TRUE(yes.WaitFor("This is a demonstration of Moontrace")) << yes.all();
  yes.Send("quit\n");
  EXPECT_EQ(yes.Wait(), 0);
  PtySession maybe({"learn"});
  ASSERT_TRUE(maybe.WaitFor("3 mouse: ")) << maybe.all();
  maybe.Send("maybe\n");
  ASSERT_TRUE(maybe.WaitFor(" is none of these.")) << maybe.all();
  maybe.Send("demo\n");
  ASSERT_TRUE(maybe.WaitFor("This is a demonstration of Moontrace")) << maybe.all();
  maybe.Send("quit\n");
  EXPECT_EQ(maybe.Wait(), 0);
  PtySession no({"learn"});
  ASSERT_TRUE(no.WaitFor("3 mouse: ")) << no.all();
  no.Send("\n");
  EXPECT_EQ(no.Wait(), 4);
  EXPECT_NE(no.all().find("moontrace learn --device simulated"), std::string::npos) << no.all();
  EXPECT_NE(no.all().find("nothing was begun"), std::string::npos) << no.all();
}

TEST(LearnWithoutADevice, IsTheDemonstrationForWhoGivesAName) {
  const Outcome outcome = RunLine({"learn", "--device", "simulated", "--learner", "ann"}, "quit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = Lines(outcome.out);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[0], "The demonstration keeps nothing, so no name is needed.");
  EXPECT_EQ(outcome.out.find("ann"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Learner"), std::string::npos) << outcome.out;
}

/// Where nobody answers, nothing is waited for; the whole of it is kept beside the tests, to be
/// read.
TEST(LearnWithoutADevice, IsADemonstrationThatKeepsNothing) {
  const Outcome outcome = RunLine({"learn", "--device", "simulated"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, ReadAll(SourcePath("tests/data/demonstration.txt")));
  ExpectTextFace(outcome.out);
}

}  // namespace
}  // namespace moontrace

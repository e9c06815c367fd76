#include "sim/study/study_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "textures/base/error.h"

namespace moontrace {
namespace {

const std::string kText = R"(title = "T"
letters = ["b", "v"]
[trials]
pre_test = 2
training = 5
retention = 1
transfer = 1
[retention]
days = [0, 7]
[transfer]
letters = ["c"]
size_mm = 6.0
[[conditions]]
name = "fading"
mode = "rail"
help = [10, 0]
probe_every = 2
)";

std::string ErrorOf(const std::string& text) {
  try {
    ParseStudy(text, "s.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string With(std::string from, const std::string& to) {
  std::string text = kText;
  return text.replace(text.find(from), from.size(), to);
}

TEST(StudyProtocol, GivesThePhasesInTheirOrder) {
  const StudyProtocol protocol = ParseStudy(kText, "s.toml");
  const auto trials = TrialsOf(protocol, protocol.conditions.at(0), 1);
  std::string phases;
  for (const StudyTrial& trial : trials) phases += trial.phase + " ";
  EXPECT_EQ(phases,
            "pre-test pre-test training training training training training retention-0 "
            "retention-7 transfer-letters transfer-size ");
  EXPECT_EQ(trials.back().day, 7);
  EXPECT_DOUBLE_EQ(trials.back().size, 0.006);
}

TEST(StudyProtocol, NeverTrainsLettersOfTheTransfer) {
  const StudyProtocol protocol = ParseStudy(kText, "s.toml");
  for (const StudyTrial& trial : TrialsOf(protocol, protocol.conditions.at(0), 4)) {
    EXPECT_EQ(trial.letter == "c", trial.phase == "transfer-letters") << trial.phase;
  }
  EXPECT_NE(ErrorOf(With("[\"c\"]", "[\"v\"]")).find("s.toml:11:11"), std::string::npos);
}

TEST(StudyProtocol, HelpsOnlyWhileTrainingAndFadesEvenly) {
  const StudyProtocol protocol = ParseStudy(kText, "s.toml");
  std::vector<double> help;
  for (const StudyTrial& trial : TrialsOf(protocol, protocol.conditions.at(0), 1)) {
    if (trial.phase == "training")
      help.push_back(trial.help);
    else
      EXPECT_EQ(trial.help, 0);
  }
  // From 10 to 0 in five trials; the second and fourth are probes.
  EXPECT_EQ(help, (std::vector<double>{10, 0, 5, 0, 0}));
}

TEST(StudyProtocol, TakesLettersInTurnFromAnotherOneForEachSeed) {
  const StudyProtocol protocol = ParseStudy(kText, "s.toml");
  const auto a = TrialsOf(protocol, protocol.conditions.at(0), 1);
  const auto b = TrialsOf(protocol, protocol.conditions.at(0), 2);
  EXPECT_NE(a[0].letter, b[0].letter);
  EXPECT_NE(a[0].letter, a[1].letter);
}

TEST(StudyProtocol, SaysWhereAndWhatIsWrong) {
  EXPECT_EQ(ErrorOf(With("training = 5", "trainig = 5")),
            "s.toml:5:1: unknown key 'trainig'; did you mean 'training'?");
  EXPECT_NE(ErrorOf(With("\"rail\"", "\"rali\"")).find("s.toml:15:8"), std::string::npos);
  EXPECT_NE(ErrorOf(With("help = [10, 0]", "help = [10]")).find("two numbers"), std::string::npos);
  EXPECT_NE(ErrorOf(With("days = [0, 7]", "days = [7, 0]")).find("ascend"), std::string::npos);
  EXPECT_NE(ErrorOf("title = \"T\"\nletters = [\"b\"]\n[trials]\n").find("conditions"),
            std::string::npos);
}

TEST(StudyProtocol, BoundsLearnersOfAllConditionsTogether) {
  const std::string second = "\n[[conditions]]\nname = \"alone\"\n";
  EXPECT_EQ(ErrorOf("learners = 50000\n" + kText + second), "");
  EXPECT_EQ(ErrorOf("learners = 50001\n" + kText + second),
            "s.toml:1:12: learners: 100002 in all conditions together: give at most 100000");
}

TEST(StudyProtocol, AnotherFileIsAnotherStudy) {
  EXPECT_NE(ParseStudy(kText, "a").digest, ParseStudy(With("= 5", "= 6"), "a").digest);
  EXPECT_EQ(ParseStudy(kText, "a").digest, ParseStudy(kText, "b").digest);
}

}  // namespace
}  // namespace moontrace

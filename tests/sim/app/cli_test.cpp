#include "sim/app/cli.h"

#include <gtest/gtest.h>

#include "sim/console/line_wrap.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::vector<std::string> kCommands = {"demo", "page", "trace", "probe", "replay", "bench"};

// Who types the program's name alone is new: it says what to type, not what was wrong.
TEST(Cli, AloneItSaysWhatToTypeFirst) {
  const Outcome alone = RunLine({});
  EXPECT_EQ(alone.code, 0);
  EXPECT_TRUE(alone.err.empty());
  EXPECT_LE(Lines(alone.out).size(), 8U);
  for (const char* first :
       {"moontrace demo", "moontrace learn", "moontrace page", "moontrace help"})
    EXPECT_NE(alone.out.find(std::string("\n") + first), std::string::npos) << first;
  ExpectTextFace(alone.out);
}

TEST(Cli, HelpNamesEveryCommandInPlainLines) {
  const Outcome help = RunLine({"help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_EQ(help.out, RunLine({"--help"}).out);
  EXPECT_EQ(help.out, RunLine({"-h"}).out);
  EXPECT_EQ(help.out, RunLine({"--help-all"}).out);
  for (const std::string& command : kCommands) {
    EXPECT_NE(help.out.find("\n" + command + ": "), std::string::npos) << command;
  }
  EXPECT_NE(help.out.find("130"), std::string::npos);
  ExpectTextFace(help.out);
}

TEST(Cli, EachCommandsHelpNamesItsOptionsInPlainLines) {
  for (const std::string& command : kCommands) {
    EXPECT_EQ(RunLine({command, "--help"}).out, RunLine({"help", command}).out);
    EXPECT_EQ(RunLine({command, "--help"}).out, RunLine({command, "-h"}).out);
    const Outcome common = RunLine({command, "--help"});
    ExpectTextFace(common.out);
    EXPECT_LE(Lines(common.out).size(), 40U) << command;
    for (const std::vector<std::string>& line :
         {std::vector<std::string>{command, "--help-all"}, {"help", command, "--help-all"}}) {
      const Outcome help = RunLine(line);
      EXPECT_EQ(help.code, 0);
      EXPECT_EQ(help.out.rfind("moontrace " + command + ": ", 0), 0U) << help.out;
      EXPECT_NE(help.out.find("\n--json: "), std::string::npos);
      EXPECT_NE(help.out.find("\n--quiet: "), std::string::npos);
      ExpectTextFace(help.out);
    }
  }
  const Outcome trace = RunLine({"trace", "--help-all"});
  for (const char* option : {"--size-mm",
                             "--width-mm",
                             "--depth-mm",
                             "--rounding-mm",
                             "--embossed",
                             "--script",
                             "--h-form",
                             "--grade",
                             "--tilt-deg",
                             "--seed",
                             "--render",
                             "--law",
                             "--model",
                             "--page",
                             "--margin-mm",
                             "--letter-gap-mm",
                             "--word-gap-mm",
                             "--line-pitch-mm",
                             "--friction",
                             "--press-n",
                             "--speed-mm-s",
                             "--record",
                             "--picture",
                             "--blank",
                             "--csv",
                             "--file",
                             "--table",
                             "--only",
                             "--lines",
                             "--fallback-script",
                             "--slant-deg",
                             "--stretch",
                             "--structure",
                             "--links",
                             "--link-depth",
                             "--link-gap-mm",
                             "--heading-scale",
                             "--heading-relief",
                             "--structure-texture",
                             "--paragraph-gap-mm"}) {
    EXPECT_NE(trace.out.find(std::string("\n") + option), std::string::npos) << option;
  }
}

TEST(Cli, VersionNamesProgramAndMujoco) {
  const Outcome version = RunLine({"version"});
  EXPECT_EQ(version.out, RunLine({"--version"}).out);
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("moontrace ", 0), 0U);
  EXPECT_NE(version.out.find("MuJoCo "), std::string::npos);
}

TEST(Cli, UnknownCommandIsUsageAndNamesTheNearest) {
  const Outcome outcome = RunLine({"trase", "HELLO"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(Lines(outcome.err).size(), 1U);
  EXPECT_NE(outcome.err.find("did you mean trace?"), std::string::npos);
}

TEST(Cli, WordsThatMeanACommandNameIt) {
  const std::pair<const char*, const char*> meant[] = {
      {"leanr", "learn"},   {"lessons", "learn"}, {"Lesson", "learn"},     {"write", "page"},
      {"braille", "page"},  {"label", "trace"},   {"mujoco", "trace"},     {"print", "page"},
      {"font", "script"},   {"fonts", "script"},  {"device", "devices"},   {"window", "view"},
      {"teacher", "tutor"}, {"halp", "help"},     {"experiment", "study"}, {"-v", "version"},
      {"tset", "test"},     {"tests", "test"},    {"package", "packages"}, {"quit", ""},
      {"learner", "learn"}, {"--hlep", "help"},   {"--page", "page"},      {"--quiet", ""},
      {"exit", ""},         {"stop", ""},         {"xyzzyx", ""}};
  for (const auto& [word, command] : meant) {
    const Outcome outcome = RunLine({word});
    EXPECT_EQ(outcome.code, 2) << word;
    const std::string nearest = std::string("did you mean ") + command + "?";
    EXPECT_EQ(outcome.err.find(nearest) != std::string::npos, *command != 0) << outcome.err;
    EXPECT_NE(outcome.err.find("moontrace help"), std::string::npos) << outcome.err;
  }
  // README's own commands are known to help, and to a program that was started without the launcher
  EXPECT_EQ(RunLine({"test"}).err.find("did you mean"), std::string::npos);
  EXPECT_NE(RunLine({"test"}).err.find("in a clone"), std::string::npos);
  EXPECT_NE(RunLine({"help", "test"}).out.find("quick tests"), std::string::npos);
  EXPECT_NE(RunLine({"help", "pgae"}).err.find("did you mean page?"), std::string::npos);
}

TEST(Cli, ATextWithoutACommandIsShownBehindPage) {
  const auto refusal = [](const std::vector<std::string>& line) {
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    return outcome.err;
  };
  const std::string meant = "did you mean moontrace page \"the moon\"? ";
  EXPECT_NE(refusal({"the moon"}).find(meant), std::string::npos);
  EXPECT_NE(refusal({"the", "moon"}).find(meant), std::string::npos);
  EXPECT_NE(refusal({"the moon", "--picture", "x.pdf"}).find(meant), std::string::npos);
  EXPECT_EQ(refusal({"xyzzyx"}).find("did you mean"), std::string::npos);
  // a shell would put something else for these
  EXPECT_NE(refusal({"the $HOME"}).find("mean moontrace page \"your text\"?"), std::string::npos);
}

TEST(Cli, AnOptionBeforeTheCommandIsTold) {
  EXPECT_NE(RunLine({"--quiet", "page", "A"}).err.find("write the command first"),
            std::string::npos);
  EXPECT_NE(RunLine({"--hlep", "page"}).err.find("did you mean help?"), std::string::npos);
}

TEST(Cli, HelpAndVersionTellAWordTooMany) {
  EXPECT_EQ(RunLine({"help", "page", "trace"}).err,
            "one argument too many for help: \"trace\"; name one command, as in moontrace help "
            "page\n");
  EXPECT_EQ(RunLine({"help", "test", "x"}).code, 2);
  EXPECT_EQ(RunLine({"help", "--markdown", "x"}).code, 2);
  EXPECT_EQ(RunLine({"version", "x"}).code, 2);
  EXPECT_NE(RunLine({"--version", "x"}).err.find("one argument too many for version: \"x\""),
            std::string::npos);
  EXPECT_EQ(RunLine({"help", "page", "--help-all"}).out, RunLine({"page", "--help-all"}).out);
  const Outcome version = RunLine({"help", "version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("moontrace version: ", 0), 0U) << version.out;
}

TEST(Cli, AnArgumentTooManyIsNoMissingQuoteWhereNoTextIsTaken) {
  const Outcome demo = RunLine({"demo", "here"});
  EXPECT_EQ(demo.code, 2);
  EXPECT_EQ(demo.err.find("quotes"), std::string::npos) << demo.err;
  EXPECT_NE(demo.err.find("moontrace help demo"), std::string::npos) << demo.err;
  EXPECT_NE(RunLine({"page", "good", "morning"}).err.find("quotes"), std::string::npos);
}

TEST(Cli, WrongChoicesNameTheNearest) {
  const std::vector<std::vector<std::string>> wrong = {
      {"page", "A", "--lines", "alternat"}, {"page", "A", "--links", "leters"},
      {"page", "A", "--page", "workspce"},  {"page", "A", "--texture", "noisy"},
      {"page", "A", "--h-form", "cresent"}, {"trace", "A", "--guide", "beed"},
      {"trace", "A", "--law", "potental"},  {"devices", "tst", "x"},
      {"loop", "A", "--device", "simulatd"}};
  for (const std::vector<std::string>& line : wrong) {
    const Outcome outcome = RunLine(line);
    EXPECT_NE(outcome.code, 0);
    EXPECT_NE(outcome.err.find("did you mean "), std::string::npos) << outcome.err;
  }
}

// The reference is made, never typed: `moontrace help --markdown > sim/OPTIONS.md`.
TEST(Cli, TheReferenceIsWhatTheCommandLineDefines) {
  const Outcome reference = RunLine({"help", "--markdown"});
  EXPECT_EQ(reference.out, ReadAll(SourcePath("sim/OPTIONS.md")));
}

TEST(Cli, UnknownOptionIsUsageAndNamesTheNearestInEveryCommand) {
  for (const std::string& command : kCommands) {
    const Outcome outcome = RunLine({command, "--jsom"});
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find("--jsom"), std::string::npos);
    EXPECT_NE(outcome.err.find("did you mean --json?"), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  }
  EXPECT_NE(RunLine({"page", "A", "--sise-mm=12"}).err.find("mean --size-mm?"), std::string::npos);
}

TEST(Cli, UnknownOptionNamesTheOneItBeginsAndNoneThatIsFar) {
  EXPECT_NE(RunLine({"page", "A", "--size"}).err.find("mean --size-mm?"), std::string::npos);
  EXPECT_NE(RunLine({"page", "A", "-size"}).err.find("mean --size-mm?"), std::string::npos);
  for (const char* far : {"--xyz", "-Z", "--verbose"}) {
    const Outcome outcome = RunLine({"page", "A", far});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err.find("did you mean"), std::string::npos) << outcome.err;
  }
}

// Names that other programs give the same thing; each is an option that the command has.
TEST(Cli, OptionsByTheirUsualNamesNameOurs) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> usual = {
      {{"page", "A", "--font", "x"}, "--script"},
      {{"page", "A", "--pdf", "x"}, "--picture page.pdf"},
      {{"page", "A", "--output", "x"}, "--picture"},
      {{"page", "A", "-o", "x"}, "--picture"},
      {{"page", "A", "--height", "20"}, "--size-mm"},
      {{"page", "A", "--height=20"}, "--size-mm"},
      {{"page", "A", "--braille"}, "--script braille"},
      {{"read", "book.txt", "--pdf", "x"}, "--print page.pdf"},
      {{"records", "export", "Ada", "--out", "x"}, "--output"},
      {{"report", "Ada", "--out", "x"}, "--html"},
      {{"learn", "--name", "Ada"}, "--learner"}};
  for (const auto& [line, ours] : usual) {
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("did you mean " + ours + "? "), std::string::npos) << outcome.err;
  }
}

TEST(Cli, EmptyPathsAreUsageAndNameTheOption) {
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"page", "A", "--picture", ""},
        {"page", "--file", ""},
        {"trace", "A", "--record", ""},
        {"trace", "A", "--picture", ""},
        {"demo", "--folder", ""}}) {
    const Outcome outcome = RunLine(args);
    EXPECT_EQ(outcome.code, 2) << args[args.size() - 2];
    EXPECT_EQ(outcome.err.rfind(args[args.size() - 2] + " is empty", 0), 0U) << outcome.err;
  }
}

TEST(Cli, HelpTellsTheLimitsThatHold) {
  const Outcome help = RunLine({"trace", "--help-all"});
  EXPECT_NE(help.out.find("height of the letters in mm, 1 to 1000"), std::string::npos);
  EXPECT_EQ(RunLine({"page", "I", "--size-mm", "1"}).code, 0);
  for (const char* beyond : {"0.99", "0.05", "1001"}) {
    const Outcome outcome = RunLine({"page", "I", "--size-mm", beyond});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("write a number from 1 to 1000"), std::string::npos) << outcome.err;
  }
  EXPECT_NE(help.out.find("less than 0.9 over the steepest"), std::string::npos) << help.out;
}

TEST(Cli, OptionWithoutItsValueIsUsage) {
  const Outcome outcome = RunLine({"page", "A", "--size-mm"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("--size-mm lacks its value"), std::string::npos) << outcome.err;
}

TEST(Cli, WhatIsNoNumberIsUsage) {
  for (const char* bad : {"twelve", "", "12mm", "1,5", "0x10"}) {
    const Outcome outcome = RunLine({"page", "A", "--size-mm", bad});
    EXPECT_EQ(outcome.code, 2) << bad;
    EXPECT_EQ(Lines(outcome.err).size(), 1U);
  }
  EXPECT_EQ(RunLine({"trace", "A", "--seed", "-1"}).code, 2);
  EXPECT_EQ(RunLine({"trace", "A", "--render", "fast"}).code, 2);
  EXPECT_EQ(RunLine({"trace", "A", "--law", "none"}).code, 2);
  EXPECT_EQ(RunLine({"page", "A", "--page", "letter"}).code, 2);
}

TEST(Cli, SecondTextIsUsageAndQuotesAreNamed) {
  const Outcome outcome = RunLine({"page", "HELLO", "WORLD"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("WORLD"), std::string::npos);
  EXPECT_EQ(RunLine({"page", "HELLO", "--file", "x"}).code, 2);
  EXPECT_EQ(RunLine({"page"}).code, 2);
}

TEST(Cli, TextMayBeACommandsNameOrBeginWithADash) {
  EXPECT_EQ(RunLine({"page", "trace"}).code, 0);
  EXPECT_EQ(RunLine({"page", "--", "-a"}).code, 0);
  EXPECT_EQ(RunLine({"page", "5"}).code, 0);
  EXPECT_EQ(RunLine({"page", "--", "a", "-b"}).code, 2);
}

TEST(Wrapped, BreaksAtSpacesAndCountsCharactersNotBytes) {
  EXPECT_EQ(Wrapped("ab cd ef", 5), "ab cd\nef\n");
  EXPECT_EQ(Wrapped("\xC3\xA9\xC3\xA9 \xC3\xA9\xC3\xA9", 5), "\xC3\xA9\xC3\xA9 \xC3\xA9\xC3\xA9\n");
  EXPECT_EQ(Wrapped("abcdefgh ij", 5), "abcdefgh\nij\n");
  EXPECT_EQ(Wrapped("", 5), "\n");
}

}  // namespace
}  // namespace moontrace

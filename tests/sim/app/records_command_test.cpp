#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>

#include "lessons/records/database.h"
#include "lessons/records/records.h"
#include "tests/sim/cli_fixture.h"
#include "tests/sim/pty_fixture.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

class RecordsCommand : public CliTest {
 protected:
  void SetUp() override {
    if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
    setenv("TZ", "UTC", 1);
    Records records = Records::Open(path_);
    LearnerEntry learner;
    learner.pseudonym = "bat";
    learner.since = 1'700'000'000;
    records.AddLearner(learner);
    learner.pseudonym = "robot";
    learner.simulated = true;
    records.AddLearner(learner);
    Trial trial;
    trial.time = 1'700'000'100;
    trial.item = "b";
    trial.size = 0.02;
    records.Add("bat", "learn-moon", trial);
    records.Add("bat", "learn-moon", trial);
    trial.item = "";  // a mark of the way, not a trial
    records.Add("bat", "learn-moon", trial);
  }

  Outcome Line(std::vector<std::string> args, const std::string& input = "") const {
    args.insert(args.begin(), "records");
    return RunLine(With(args, {"--records", path_}), input);
  }

  const std::string path_ = In("records.sqlite");
};

void ExpectRefused(const Outcome& outcome, int code, const std::string& words) {
  EXPECT_EQ(outcome.code, code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

TEST_F(RecordsCommand, ListsLearners) {
  const Outcome outcome = Line({"list"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "2 learners in the records.\n"
            "bat: 2 trials, tracks not kept, since 2023-11-14\n"
            "robot: 0 trials, simulated, tracks not kept, since 2023-11-14\n");
  const auto json = Line({"list", "--json"}).Json();
  EXPECT_EQ(json["learners"][0]["learner"], "bat");
  EXPECT_EQ(json["learners"][0]["trials"], 2);
  EXPECT_EQ(json["learners"][0]["courses"][0], "learn-moon");
  EXPECT_EQ(json["learners"][1]["simulated"], true);
}

// Whoever looks first has done nothing wrong.
TEST_F(RecordsCommand, BeforeAnybodyHasLearntTellsHowToBegin) {
  setenv("XDG_DATA_HOME", In("empty").c_str(), 1);
  const Outcome list = RunLine({"records", "list"});
  const Outcome json = RunLine({"records", "list", "--json"});
  unsetenv("XDG_DATA_HOME");
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_EQ(list.out, "Nobody has learnt here yet. To begin: moontrace learn.\n");
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(json.Json(), nlohmann::json::parse(R"({"learners": []})"));
  EXPECT_FALSE(std::filesystem::exists(In("empty")));
}

// A file from elsewhere may hold what AddLearner refuses: nothing of it reaches the terminal.
TEST_F(RecordsCommand, ShowsEscapeCodesAndLineEndsInANameAsQuestionMarks) {
  Database(path_, true)
      .Run(
          "UPDATE learner SET pseudonym = 'b' || char(27) || '[2J' || char(10) || char(0x9b) || 'x'"
          " WHERE pseudonym = 'bat'");
  const Outcome list = Line({"list"});
  EXPECT_NE(list.out.find("\nb?[2J??x: 2 trials"), std::string::npos) << list.out;
  ExpectTextFace(list.out);
  const std::string name = "b\x1b[2J\n\xc2\x9bx";
  for (const Outcome& outcome :
       {Line({"erase", "b?[2J??x", "--yes"}), Line({"consent", name, "yes"}), Line({"erase", name}),
        Line({"erase", name, "--yes"})}) {
    ExpectTextFace(outcome.out);
    EXPECT_EQ(Lines(outcome.err).size(), outcome.code == 0 ? 0U : 1U);
    for (const std::string& line : Lines(outcome.err)) EXPECT_EQ(line, OneLine(line, 1000));
  }
  EXPECT_EQ(Line({"list"}).out.find("b?"), std::string::npos);
}

TEST_F(RecordsCommand, RefusesAVersionBelowZeroByOneLine) {
  Database(path_, true).Run("PRAGMA user_version = -1");
  ExpectRefused(Line({"list"}), 3, "not a records file");
  const std::vector<std::string> learn{"learn", "--learner", "bat", "--device", "simulated"};
  ExpectRefused(RunLine(With(learn, {"--records", path_})), 3, "not a records file");
}

// Another program, or a person at SQLite's own prompt, may have left it so.
TEST_F(RecordsCommand, TakesAFileWithAWriteAheadLog) {
  Database(path_, true).Run("PRAGMA journal_mode = WAL");
  EXPECT_EQ(Line({"list"}).code, 0);
  const Outcome outcome = Line({"consent", "bat", "yes"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  ExpectOnly({"records.sqlite", "records.sqlite-lock"});
}

TEST_F(RecordsCommand, ExportsAndImportsTheSame) {
  const Outcome whole = Line({"export", "bat"});
  EXPECT_EQ(whole.code, 0);
  EXPECT_EQ(whole.Json()["learner"]["pseudonym"], "bat");
  const Outcome to_file = Line({"export", "bat", "--output", In("bat.json")});
  EXPECT_EQ(to_file.out, "Exported with all that is known to:\n" + In("bat.json") + "\n");
  EXPECT_EQ(ReadAll(In("bat.json")), whole.out);
  const std::vector<std::string> other{"--records", In("other.sqlite")};
  EXPECT_EQ(RunLine(With({"records", "import", In("bat.json")}, other)).out,
            "Imported: 3 rows of bat.\n");
  EXPECT_EQ(RunLine(With({"records", "export", "bat"}, other)).out, whole.out);
  ExpectRefused(RunLine(With({"records", "import", In("bat.json")}, other)), 3, "already");
}

TEST_F(RecordsCommand, MakesNoRecordsOfABadImport) {
  WriteAll(In("bad.json"), "{");
  ExpectRefused(RunLine({"records", "import", In("bad.json"), "--records", In("new.sqlite")}), 3,
                "not JSON");
  EXPECT_FALSE(std::filesystem::exists(In("new.sqlite")));
}

TEST_F(RecordsCommand, ImportsFromStandardInput) {
  const std::string text = Line({"export", "bat"}).out;
  Line({"erase", "bat", "--yes"});
  EXPECT_EQ(Line({"import", "-"}, text).out, "Imported: 3 rows of bat.\n");
  EXPECT_EQ(Line({"export", "bat"}).out, text);
  ExpectRefused(Line({"import", "-"}, "{"), 3, "standard input:1:2: not JSON");
}

TEST_F(RecordsCommand, ExportsForResearchWithoutTheName) {
  const Outcome outcome = Line({"export", "bat", "--anonymous"});
  EXPECT_EQ(outcome.Json()["format"], "moontrace-research");
  EXPECT_EQ(outcome.out.find("bat"), std::string::npos);
  EXPECT_EQ(Line({"export", "bat", "--anonymous", "--output", In("a.json"), "--json"})
                .Json()["anonymous"],
            true);
  ExpectRefused(Line({"import", In("a.json")}), 3, "an anonymous export has no learner");
}

TEST_F(RecordsCommand, ErasesOnlyWhenItIsMeant) {
  ExpectRefused(Line({"erase", "bat"}), 2, "nothing erased: add --yes");
  EXPECT_NE(ReadAll(path_).find("bat"), std::string::npos);
  EXPECT_EQ(Line({"erase", "bat", "--yes"}).out, "Erased: bat. No byte is left in the records.\n");
  EXPECT_EQ(ReadAll(path_).find("bat"), std::string::npos);
  EXPECT_EQ(Line({"erase", "robot", "--yes", "--json"}).Json()["erased"], "robot");
}

TEST_F(RecordsCommand, SetsConsent) {
  EXPECT_EQ(Line({"consent", "bat", "yes"}).out,
            "bat: raw tracks of the hand are kept from now on.\n");
  EXPECT_TRUE(Records::OpenToRead(path_).Find("bat")->keeps_tracks);
  EXPECT_EQ(Line({"consent", "bat", "no", "--json"}).Json()["keeps_tracks"], false);
  EXPECT_FALSE(Records::OpenToRead(path_).Find("bat")->keeps_tracks);
}

TEST_F(RecordsCommand, RefusesWhatIsNoUse) {
  ExpectRefused(Line({}), 2, "records: say what to do: list");
  ExpectRefused(Line({"lst"}), 2, "did you mean list?");
  ExpectRefused(Line({"list", "bat"}), 2, "one argument too many");
  ExpectRefused(Line({"export"}), 2, "lacks a learner");
  ExpectRefused(Line({"import"}), 2, "lacks its file");
  ExpectRefused(Line({"export", "bat", "yes"}), 2, "one argument too many");
  ExpectRefused(Line({"consent", "bat"}), 2, "write yes or no");
  ExpectRefused(Line({"list", "--yes"}), 2, "--yes goes with records erase only");
  ExpectRefused(Line({"list", "--output", "x"}), 2, "--output goes with records export only");
  ExpectRefused(Line({"erase", "bat", "--anonymous"}), 2, "--anonymous goes with");
  ExpectRefused(Line({"export", "bad"}), 3, "did you mean bat?");
  ExpectRefused(Line({"erase", "owl", "--yes"}), 3, "no learner \"owl\"");
  ExpectRefused(Line({"export", "bat", "--output", In("no/such/f")}), 4, "No such file");
  ExpectRefused(RunLine({"records", "list", "--records", In("none.sqlite")}), 3,
                "no records there yet");
  ExpectRefused(RunLine({"records", "list", "--records", ""}), 2, "--records is empty");
  ExpectRefused(RunLine({"records", "report", "bat"}), 2, "write moontrace report NAME");
}

TEST_F(RecordsCommand, RefusesAWriterBesideAnother) {
  const Records writing = Records::Open(path_);
  ExpectRefused(Line({"erase", "bat", "--yes"}), 4, "another program writes these records");
  EXPECT_EQ(Line({"list"}).code, 0);
}

/// At a terminal of its own: what is typed, what is shown, how it ends.
std::string AtTerminal(const std::vector<std::string>& args, const std::string& typed, int& code) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    Console console(std::cin, std::cout, std::cerr);
    const int ended = RunCli(args, console);
    std::cout.flush();
    _exit(ended);
  }
  std::string shown;
  char block[1024];
  bool answered = false;
  for (ssize_t got = 0; (got = read(terminal, block, sizeof block)) > 0;) {
    shown.append(block, static_cast<std::size_t>(got));
    if (answered || shown.find("type the name:") == std::string::npos) continue;
    answered = write(terminal, typed.data(), typed.size()) == static_cast<ssize_t>(typed.size());
  }
  int status = 0;
  waitpid(child, &status, 0);
  close(terminal);
  code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return shown;
}

TEST_F(RecordsCommand, AsksAtATerminalForTheName) {
  SKIP_WITHOUT_TERMINALS();
  const std::vector<std::string> erase{"records", "erase", "bat", "--records", path_};
  int code = 0;
  std::string shown = AtTerminal(erase, "owl\n", code);
  EXPECT_EQ(code, 1) << shown;
  EXPECT_NE(shown.find("nothing erased"), std::string::npos) << shown;
  EXPECT_TRUE(Records::OpenToRead(path_).Find("bat"));
  shown = AtTerminal(erase, "\x04", code);  // no answer: the end of input
  EXPECT_EQ(code, 1) << shown;
  shown = AtTerminal(erase, "bat\n", code);
  EXPECT_EQ(code, 0) << shown;
  EXPECT_FALSE(Records::OpenToRead(path_).Find("bat"));
}

TEST_F(RecordsCommand, KeepsToTheTextFace) {
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"list"}, {"consent", "bat", "yes"}, {"erase", "bat", "--yes"}}) {
    ExpectTextFace(Line(args).out);
  }
  const Outcome help = RunLine({"records", "--help"});
  ExpectTextFace(help.out);
  for (const char* option : {"--records", "--output", "--anonymous", "--yes", "--json"}) {
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  }
}

}  // namespace
}  // namespace moontrace

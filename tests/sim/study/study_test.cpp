// Studies: rows, files, shards, resuming; and the order of conditions that the literature reports.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "sim/study/study_files.h"
#include "sim/study/study_messages.h"
#include "sim/study/study_summary.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

const std::string kProtocol = R"(title = "Small"
learners = 2
letters = ["l", "v"]
size_mm = 8.0
groove_depth_share = 0.1
press_n = 0.1
[trials]
pre_test = 1
training = 3
retention = 1
[retention]
days = [0, 1]
[[conditions]]
name = "full"
mode = "rail"
help = [10, 10]
[[conditions]]
name = "none"
)";

std::string BytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Study : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("moontrace-study-" + std::to_string(getpid()));
    fs::create_directories(folder_);
    std::ofstream(Path("small.toml")) << kProtocol;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::string Whole(int threads) {
    const std::string path = Path("whole-" + std::to_string(threads) + ".csv");
    StudyOutput output;
    output.path = path;
    output.threads = threads;
    RunStudy(LoadStudy(Path("small.toml")), output);
    return BytesOf(path);
  }
  fs::path folder_;
};

TEST_F(Study, PutsTheHandsOnADevice) {
  const std::string exact = Whole(1);
  fs::remove(Path("whole-1.csv"));
  std::ofstream(Path("small.toml")) << "device = \"woodenhaptics\"\n" << kProtocol;
  const std::string stepped = Whole(1);
  EXPECT_EQ(Whole(2), stepped);
  // the digest of the protocol differs as well, so rows are told apart by what was felt
  const auto without_digest = [](std::string rows) {
    std::size_t begin = 0;
    while (begin < rows.size()) {
      rows.erase(begin, rows.find(',', begin) - begin);
      begin = std::min(rows.find('\n', begin), rows.size() - 1) + 1;
    }
    return rows;
  };
  EXPECT_NE(without_digest(stepped), without_digest(exact));
  fs::remove(Path("whole-1.csv"));
  std::ofstream(Path("small.toml")) << "device = \"none\"\n" << kProtocol;
  EXPECT_THROW(Whole(1), InputError);
}

TEST_F(Study, ExploresOnDevicesThatMeasureAHeightOnly) {
  std::ofstream(Path("small.toml")) << "device = \"sidewinder-ff2\"\n"
                                    << kProtocol << "[staircase]\nstart_mm = 20.0\n";
  try {
    Whole(1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("sidewinder-ff2"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("[staircase]"), std::string::npos) << error.what();
  }
  // without one it only traces
  std::ofstream(Path("small.toml")) << "device = \"sidewinder-ff2\"\n" << kProtocol;
  EXPECT_FALSE(Whole(1).empty());
}

TEST_F(Study, GivesTheSameBytesForAnyNumberOfThreads) {
  const std::string one = Whole(1);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1 + 4 * 6);
  EXPECT_EQ(one, Whole(3));
}

TEST_F(Study, GoesOnWhereItWasEnded) {
  const std::string whole = Whole(1);
  const StudyProtocol protocol = LoadStudy(Path("small.toml"));
  StudyOutput output;
  output.path = Path("ended.csv");
  fs::create_directories(output.path + ".parts");
  // Three trials of the first learner, and a line that was cut off.
  std::size_t end = 0;
  for (int line = 0; line < 4; ++line) end = whole.find('\n', end) + 1;
  std::ofstream(output.path + ".parts/full-1.csv") << whole.substr(0, end + 20);
  RunStudy(protocol, output);
  EXPECT_EQ(BytesOf(output.path), whole);
  EXPECT_FALSE(fs::exists(output.path + ".parts"));
}

// What is told of a study follows from its rows, so they must be the same numbers to the last bit
// whether they were run just now, gone on with, merged or read again.
TEST_F(Study, GivesTheNumbersThatItsFileHolds) {
  const StudyProtocol protocol = LoadStudy(Path("small.toml"));
  StudyOutput output;
  output.path = Path("rows.csv");
  const std::vector<StudyRow> run = RunStudy(protocol, output);
  const std::vector<StudyRow> read = RunStudy(protocol, output);
  ASSERT_EQ(run.size(), read.size());
  for (std::size_t i = 0; i < run.size(); ++i) {
    EXPECT_EQ(run[i].mean_error, read[i].mean_error) << i;
    EXPECT_EQ(run[i].rms_error, read[i].rms_error) << i;
    EXPECT_EQ(run[i].given.size, read[i].given.size) << i;
  }
}

TEST_F(Study, RunsNoFinishedTrialAgain) {
  const StudyProtocol protocol = LoadStudy(Path("small.toml"));
  const StudyPlace place{0, 1};
  std::vector<StudyRow> rows;
  RunStudyLearner(protocol, place, {}, [&rows](const StudyRow& row) { rows.push_back(row); });
  ASSERT_EQ(rows.size(), RowsOf(protocol, place));
  const std::vector<StudyRow> first(rows.begin(), rows.begin() + 4);
  std::vector<StudyRow> rest;
  RunStudyLearner(protocol, place, first, [&rest](const StudyRow& row) { rest.push_back(row); });
  ASSERT_EQ(rest.size(), rows.size() - 4);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    EXPECT_EQ(FormatRow(rest[i]), FormatRow(rows[i + 4]));
  }
}

TEST_F(Study, LosesNothingWhenKilled) {
  const std::string whole = Whole(1);
  const std::string path = Path("killed.csv");
  const StudyProtocol protocol = LoadStudy(Path("small.toml"));
  for (const int trials : {2, 9, 17}) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      StudyOutput output;
      output.path = path;
      // One thread: this one gives the lines, and dies by SIGKILL after so many.
      const std::vector<StudyPlace> places = PlacesOf(protocol, 1, 1);
      fs::create_directories(path + ".parts");
      int left = trials;
      for (const StudyPlace& place : places) {
        const std::string part = path + ".parts/" + protocol.conditions[place.condition].name +
                                 "-" + std::to_string(place.seed) + ".csv";
        std::vector<StudyRow> before;
        if (fs::exists(part)) before = ParseRows(BytesOf(part), part);
        std::ofstream file(part, std::ios::app);
        if (before.empty() && fs::file_size(part) == 0)
          file << StudyHeader(StudyKind::kTracing) << std::flush;
        RunStudyLearner(protocol, place, before, [&](const StudyRow& row) {
          file << FormatRow(row) << std::flush;
          if (--left == 0) {
            file << "half a li" << std::flush;
            kill(getpid(), SIGKILL);
          }
        });
      }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    StudyOutput output;
    output.path = path;
    RunStudy(protocol, output);
    EXPECT_EQ(BytesOf(path), whole) << trials;
    fs::remove(path);
  }
}

TEST_F(Study, ShardsOfTwoProcessesMergeToTheWhole) {
  const std::string whole = Whole(1);
  std::vector<pid_t> children;
  for (const int shard : {1, 2}) {
    children.push_back(fork());
    if (children.back() == 0) {
      StudyOutput output;
      output.path = Path("shard-" + std::to_string(shard) + ".csv");
      output.shard = shard;
      output.shards = 2;
      RunStudy(LoadStudy(Path("small.toml")), output);
      _exit(0);
    }
  }
  for (const pid_t child : children) waitpid(child, nullptr, 0);
  const Outcome merged = RunLine(
      {"study", "merge", Path("shard-2.csv"), Path("shard-1.csv"), "--output", Path("merged.csv")});
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(BytesOf(Path("merged.csv")), whole);
  ExpectTextFace(merged.out);
  EXPECT_EQ(RunLine({"study", "merge", Path("shard-1.csv"), "--output", Path("m.csv")}).code, 3);
}

TEST_F(Study, SaysWhatCameOfIt) {
  const std::vector<std::string> line = {"study", Path("small.toml"), "--output", Path("a.csv")};
  const Outcome first = RunLine(line);
  EXPECT_EQ(first.code, 0) << first.err;
  ExpectTextFace(first.out);
  EXPECT_EQ(first.out.rfind("Study done: 24 trials of 4 learners.\n", 0), 0u);
  EXPECT_NE(first.out.find("not how people learn"), std::string::npos);
  EXPECT_EQ(RunLine(line).out, first.out);  // nothing is left to do
  const auto json = RunLine(With(line, {"--json"})).Json();
  EXPECT_EQ(json["cells"].size(), 2u * 4);
  EXPECT_EQ(json["trials"], 24);
  EXPECT_TRUE(json["shard"].is_null());
  EXPECT_GT(json["cells"][0]["mean_mm"], 0);
  // each is compared with the first that is never guided, as the words have it
  for (std::size_t i = 0; i < 8; i += 2) {
    const auto &full = json["cells"][i], &none = json["cells"][i + 1];
    EXPECT_EQ(full["condition"], "full");
    EXPECT_EQ(full["reference"], "none");
    EXPECT_EQ(full["pairs"], 2);
    const double more = full["more_mm"];
    EXPECT_NEAR(more, full["mean_mm"].get<double>() - none["mean_mm"].get<double>(), 1e-9);
    EXPECT_LE(full["more_ci95_mm"][0], more);
    EXPECT_GE(full["more_ci95_mm"][1], more);
    for (const char* key : {"reference", "pairs", "more_mm", "more_ci95_mm"}) {
      EXPECT_TRUE(none[key].is_null()) << key;
    }
  }
}

TEST_F(Study, SaysWhatAStopLeaves) {
  const std::atomic<bool> stop{true};
  const Outcome stopped =
      RunLine({"study", Path("small.toml"), "--output", Path("a.csv")}, "", &stop);
  EXPECT_EQ(stopped.code, 130);
  EXPECT_NE(stopped.err.find(Path("a.csv") + ".parts"), std::string::npos) << stopped.err;
}

TEST_F(Study, ComparesNothingInAShare) {
  const Outcome share =
      RunLine({"study", Path("small.toml"), "--shard", "1/2", "--output", Path("share.csv")});
  EXPECT_EQ(share.code, 0) << share.err;
  EXPECT_NE(share.out.find("This is share 1/2 of the study"), std::string::npos) << share.out;
  EXPECT_EQ(share.out.find("least first"), std::string::npos) << share.out;
  const auto json = RunLine({"study", Path("small.toml"), "--shard", "1/2", "--output",
                             Path("share.csv"), "--json"})
                        .Json();
  EXPECT_EQ(json["shard"], "1/2");
  ASSERT_FALSE(json["cells"].empty());
  EXPECT_EQ(json["cells"][0]["learners"], 1);
  for (const char* key : {"mean_mm", "sd_mm", "ci95_mm", "reference", "more_mm"}) {
    EXPECT_TRUE(json["cells"][0][key].is_null()) << key;
  }
}

TEST_F(Study, MergesIntoNoneOfItsFiles) {
  ASSERT_EQ(RunLine({"study", Path("small.toml"), "--output", Path("a.csv")}).code, 0);
  const std::string before = ReadAll(Path("a.csv"));
  const Outcome refused = RunLine({"study", "merge", Path("a.csv"), "--output", Path("./a.csv")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("is one of the files to merge"), std::string::npos) << refused.err;
  EXPECT_EQ(ReadAll(Path("a.csv")), before);
}

TEST_F(Study, RefusesWhatItCannotUse) {
  EXPECT_EQ(RunLine({"study"}).code, 2);
  EXPECT_EQ(RunLine({"study", "merge"}).code, 2);
  EXPECT_EQ(RunLine({"study", "merge", Path("x.csv")}).code, 2);
  EXPECT_EQ(RunLine({"study", Path("small.toml"), "--shard", "3/2"}).code, 2);
  EXPECT_EQ(RunLine({"study", Path("small.toml"), "--threads", "0"}).code, 2);
  EXPECT_EQ(RunLine({"study", Path("missing.toml")}).code, 3);
  const Outcome mistyped = RunLine({"study", "guidence"});
  EXPECT_EQ(mistyped.code, 3);
  EXPECT_EQ(
      mistyped.err,
      "no study \"guidence\": did you mean guidance? there is arms, defaults, figure2, guidance, "
      "joysticks and reading; or name a TOML file by its path\n");
  std::ofstream(Path("other.csv")) << "a,b\n";
  EXPECT_EQ(RunLine({"study", Path("small.toml"), "--output", Path("other.csv")}).code, 3);
  const Outcome nowhere = RunLine({"study", Path("small.toml"), "--output", Path("none/a.csv")});
  EXPECT_EQ(nowhere.code, 4);
  EXPECT_EQ(std::count(nowhere.err.begin(), nowhere.err.end(), '\n'), 1) << nowhere.err;
  std::ofstream(Path("nope.toml")) << "script = \"nope\"\n" << kProtocol;
  const Outcome unknown = RunLine({"study", Path("nope.toml")});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_EQ(unknown.err.rfind(Path("nope.toml") + ": script: ", 0), 0U) << unknown.err;
}

TEST_F(Study, TakesLettersThatAreOneSign) {
  const std::string whole = "[\"l\", \"v\"]";
  const auto refusal = [&](const std::string& letter) {
    std::string text = kProtocol;
    text.replace(text.find(whole), whole.size(), "[\"l\", \"" + letter + "\"]");
    WriteAll(Path("letters.toml"), text);
    const Outcome outcome = RunLine({"study", Path("letters.toml"), "--output", Path("l.csv")});
    EXPECT_EQ(outcome.code, 3) << letter;
    return outcome.err;
  };
  const std::string at = Path("letters.toml") + ":3:11: letters: '";
  for (const char* letter : {"你", "你a", "a你", "zz", "a ", " "}) {
    EXPECT_EQ(refusal(letter), at + letter + "' is not one sign of moon: give letters that are\n");
  }
  WriteAll(Path("t.toml"), kProtocol + "[transfer]\nletters = [\"é\", \"th\"]\n");
  const Outcome transfer = RunLine({"study", Path("t.toml"), "--output", Path("t.csv")});
  EXPECT_EQ(transfer.err.rfind(Path("t.toml") + ":20:11: letters: 'th' is not one sign", 0), 0U)
      << transfer.err;
  EXPECT_FALSE(fs::exists(Path("t.csv.parts")));
}

TEST(StudySummary, GivesMeanDeviationAndInterval) {
  std::vector<StudyRow> rows;
  for (int seed = 1; seed <= 4; ++seed) {
    StudyRow row;
    row.condition = "none";
    row.given.phase = "training";
    row.seed = static_cast<std::uint64_t>(seed);
    row.mean_error = seed;
    rows.push_back(row);
  }
  rows.push_back(rows.front());
  rows.back().excluded = "why";
  const StudySummary summary = Summarise(rows);
  ASSERT_EQ(summary.cells.size(), 1u);
  const StudyCell& cell = summary.cells.front();
  EXPECT_DOUBLE_EQ(cell.mean, 2.5);
  EXPECT_NEAR(cell.deviation, 1.2910, 1e-4);         // of 1, 2, 3, 4
  EXPECT_NEAR(cell.high - cell.mean, 2.0543, 1e-3);  // 3.182 x 1.2910 / 2
  EXPECT_EQ(summary.exclusions.size(), 1u);
}

TEST(StudyMessages, OneLearnerHasNoSpread) {
  StudyCell cell;
  cell.phase = "training";
  cell.condition = "none";
  cell.mean = cell.low = cell.high = 596e-6;
  cell.learners = 1;
  EXPECT_EQ(say::StudyCellLine(cell), "training, none: 0.596 mm, n 1");
}

TEST(StudySummary, ComparesTheSameLearners) {
  std::vector<StudyRow> rows;
  for (int seed = 1; seed <= 3; ++seed) {
    for (const char* condition : {"full", "none"}) {
      StudyRow row;
      row.condition = condition;
      row.given.phase = "training";
      if (row.condition == "full") row.given.mode = GuidanceMode::kRail;
      row.seed = static_cast<std::uint64_t>(seed);
      row.mean_error = 10 * seed + (row.condition == "full" ? seed : 0);
      rows.push_back(row);
    }
  }
  const StudySummary summary = Summarise(rows);
  EXPECT_EQ(summary.reference, "none");
  ASSERT_EQ(summary.cells.size(), 2u);
  EXPECT_DOUBLE_EQ(summary.cells[0].more, 2);                // of 1, 2, 3
  EXPECT_NEAR(summary.cells[0].more_high - 2, 2.484, 1e-3);  // 4.303 x 1 / sqrt 3
  EXPECT_EQ(summary.cells[1].pairs, 0u);
}

TEST(StudySummary, KnowsStudentsT) {  // from the usual table
  EXPECT_NEAR(StudentT95(1), 12.706, 1e-3);
  EXPECT_NEAR(StudentT95(12), 2.179, 2e-3);
  EXPECT_NEAR(StudentT95(19), 2.093, 2e-3);
  EXPECT_NEAR(StudentT95(1000), 1.962, 1e-3);
}

// Training-and-ux 1.2 and 1.7: guided is best while training and worst at retention, amplified the
// reverse, fading between; 20 learners of each condition.
TEST(SlowStudy, ShowsTheOrderOfTheLiterature) {
  const std::string path =
      fs::temp_directory_path() / ("moontrace-guidance-" + std::to_string(getpid()) + ".csv");
  StudyOutput output;
  output.path = path;
  output.threads = 2;
  const auto rows = RunStudy(LoadStudy(SourcePath("lessons/studies/guidance.toml")), output);
  fs::remove(path);
  std::map<std::string, std::map<std::string, StudyCell>> cells;
  for (const StudyCell& cell : Summarise(rows).cells) cells[cell.phase][cell.condition] = cell;
  auto& training = cells["training"];
  EXPECT_LT(training["full"].high, training["fading"].low);
  EXPECT_LT(training["fading"].high, training["none"].low);
  EXPECT_LT(training["none"].mean, training["amplified"].mean);
  auto& week = cells["retention-7"];
  // The same learners are in each condition: their differences to those who had no help.
  EXPECT_GT(week["full"].more_low, 0);
  EXPECT_LT(week["amplified"].more_high, 0);
  EXPECT_GT(week["full"].more, week["fading"].more);
  EXPECT_GT(week["fading"].more, week["amplified"].more);
}

}  // namespace
}  // namespace moontrace

// Studies of pages that are read by touch: what is asked, what is found, and how sure it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "sim/study/page_reading.h"
#include "sim/study/reading_summary.h"
#include "sim/study/study_files.h"
#include "sim/trial/trial.h"
#include "tests/sim/cli_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

std::string ErrorOf(const std::string& reading) {
  try {
    StudyProtocol protocol = ParseStudy("title = \"T\"\n[reading]\n" + reading, "r.toml");
    CompleteSweep(*protocol.reading, "r.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadingSweep, CombinesAllValuesAndNamesThemByWhatDiffers) {
  const StudyProtocol protocol = ParseStudy(
      "title = \"T\"\nfirst_seed = 7\n[reading]\npages = 3\nsize_mm = [6.0, 8.5]\n"
      "press_n = [0.5, 1.0, 2.0]\nunsure_mm = [0.5]\ndevice = [\"woodenhaptics\"]",
      "r.toml");
  EXPECT_EQ(protocol.kind(), StudyKind::kReading);
  EXPECT_EQ(protocol.learners, 3);
  std::string names;
  for (const StudyCondition& condition : protocol.conditions) names += condition.name + " ";
  EXPECT_EQ(names, "6mm-0.5n 6mm-1n 6mm-2n 8.5mm-0.5n 8.5mm-1n 8.5mm-2n ");
  const ReadingCell& last = protocol.reading->cells.back();
  EXPECT_EQ(last.size, 8.5e-3);
  EXPECT_EQ(last.press, 2);
  EXPECT_EQ(last.unsure, 0.5e-3);
  EXPECT_EQ(last.device, "woodenhaptics");
  EXPECT_EQ(PlacesOf(protocol, 1, 1).size(), 18U);
  EXPECT_EQ(PlacesOf(protocol, 1, 1).back().seed, 9U);
}

TEST(ReadingSweep, RefusesWhatCannotBeRead) {
  const std::string twice = ErrorOf("size_mm = [6.0, 6.0]");
  EXPECT_NE(twice.find("6mm stands there twice"), std::string::npos) << twice;
  EXPECT_NE(ErrorOf("text = \"words\"").find("give \"letters\" or \"signs\""), std::string::npos);
  EXPECT_NE(ErrorOf("sizes_mm = [6.0]").find("size_mm"), std::string::npos);
  EXPECT_NE(ErrorOf("size_mm = []").find("give 1 to"), std::string::npos);
  EXPECT_NE(ErrorOf("size_mm = [1000.0]"), "");
  EXPECT_NE(ErrorOf("size_mm = [nan]"), "");
  for (const char* pages : {"pages = 0", "pages = -1"}) {
    EXPECT_NE(ErrorOf(pages).find("give 1 to"), std::string::npos) << pages;
  }
  std::string many = "[0.0";
  for (int i = 1; i < 100; ++i) many += ", " + std::to_string(0.01 * i);
  many += "]";
  const std::string all =
      ErrorOf("unsure_mm = " + many + "\nfriction = " + many + "\ndrift_share = " + many);
  EXPECT_NE(all.find("more than 10000 combinations"), std::string::npos) << all;
  EXPECT_NE(ErrorOf("width_share = [5.0]"), "");  // wider than half a letter
  EXPECT_NE(ErrorOf("script = [\"nowhere\"]").find("r.toml: reading, page: "), std::string::npos);
  EXPECT_EQ(ErrorOf("script = [\"braille\"]\nrelief = [\"engraved\", \"embossed\"]"), "");
  EXPECT_NE(ErrorOf("relief = [\"flat\"]").find("give \"engraved\", \"embossed\" or both"),
            std::string::npos);
  const std::string puck = ErrorOf("device = [\"spacemouse\"]");
  EXPECT_NE(puck.find("does not measure and push all that it takes"), std::string::npos) << puck;
  EXPECT_EQ(ErrorOf("device = [\"sidewinder-ff2\"]\nsize_mm = [20.0]"), "");
  // which does not feel how high its hand is
  const std::string ridges =
      ErrorOf("device = [\"sidewinder-ff2\"]\nsize_mm = [20.0]\nrelief = [\"embossed\"]");
  EXPECT_NE(ridges.find("does not measure and push all that it takes"), std::string::npos)
      << ridges;
}

// Grooves hold a firm hand; a ridge wants a light one, and raised dots a lighter one still.
TEST(ReadingSweep, GivesEachReliefItsUsualPressUnlessOneIsAskedFor) {
  StudyProtocol protocol = ParseStudy(
      "title = \"T\"\n[reading]\nscript = [\"moon\", \"braille\"]\nsize_mm = [6.0]\n"
      "relief = [\"engraved\", \"embossed\"]",
      "r.toml");
  CompleteSweep(*protocol.reading, "r.toml");
  const std::vector<ReadingCell>& cells = protocol.reading->cells;
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[0].press, ShippedHand().press);
  EXPECT_EQ(cells[1].press, ShippedHand().light_press);
  EXPECT_LT(cells[3].press, cells[1].press);
  EXPECT_LT(cells[3].press, cells[2].press);
  EXPECT_EQ(cells[2].name, "braille-engraved");
  StudyProtocol asked =
      ParseStudy("title = \"T\"\n[reading]\npress_n = [0.5]\nrelief = [\"embossed\"]", "r.toml");
  CompleteSweep(*asked.reading, "r.toml");
  EXPECT_EQ(asked.reading->cells.front().press, 0.5);
}

TEST(ReadingSweep, HasTheSameTextForASeedOnly) {
  ReadingSweep sweep;
  sweep.letters = 30;
  const std::string text = SweepText(sweep, 3);
  EXPECT_EQ(std::count_if(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; }),
            30);
  EXPECT_EQ(std::count(text.begin(), text.end(), ' '), 5);
  EXPECT_EQ(SweepText(sweep, 3), text);
  EXPECT_NE(SweepText(sweep, 4), text);
  sweep.text = ReadingSweep::Text::kSigns;
  sweep.letters = 500;
  EXPECT_NE(SweepText(sweep, 3).find_first_of("0123456789"), std::string::npos);
  EXPECT_NE(SweepText(sweep, 3).find_first_of(".,;:?!"), std::string::npos);
}

StudyRow Page(const std::string& condition, std::uint64_t seed, std::size_t signs,
              std::size_t right, double seconds) {
  StudyRow row;
  row.condition = condition;
  row.seed = seed;
  row.trial = 1;
  row.page.emplace();
  row.page->read.signs = signs;
  row.page->read.signs_right = right;
  row.page->read.wrong = signs - right;
  row.page->read.duration = seconds;
  row.page->read.ended = true;
  return row;
}

// Wilson's lower end for none wrong of n is n / (n + z^2).
TEST(ReadingSummary, PagesWithoutAnErrorAreNoSurerThanTheirSigns) {
  std::vector<StudyRow> rows;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) rows.push_back(Page("a", seed, 20, 20, 100));
  const ReadingSummary summary = SummariseReading(rows);
  ASSERT_EQ(summary.cells.size(), 1U);
  EXPECT_EQ(summary.cells[0].right.value, 1);
  EXPECT_NEAR(summary.cells[0].right.low, 80 / (80 + 1.959964 * 1.959964), 1e-9);
  EXPECT_EQ(summary.cells[0].right.high, 1);
  EXPECT_NEAR(summary.cells[0].seconds.value, 5, 1e-12);
  EXPECT_NEAR(summary.cells[0].seconds.low, 5, 1e-12);
}

// Wilson's upper end for none right of n is z^2 / (n + z^2).
TEST(ReadingSummary, PagesWithNothingRightAreNoSurerThanTheirSigns) {
  std::vector<StudyRow> rows;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) rows.push_back(Page("a", seed, 20, 0, 100));
  const Estimate right = SummariseReading(rows).cells.at(0).right;
  EXPECT_EQ(right.value, 0);
  EXPECT_NEAR(right.low, 0, 1e-12);
  EXPECT_NEAR(right.high, 1.959964 * 1.959964 / (80 + 1.959964 * 1.959964), 1e-9);
}

// Each page is wholly right or wholly wrong, so that 100 pages say as much as 100 signs, not as
// their 2000: the standard error of the share is sqrt(p (1 - p) / 100) = 0.04.
TEST(ReadingSummary, ErrorsThatStandTogetherWidenTheInterval) {
  std::vector<StudyRow> rows;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    rows.push_back(Page("a", seed, 20, seed % 5 == 0 ? 0 : 20, 100));
  }
  const Estimate right = SummariseReading(rows).cells[0].right;
  EXPECT_NEAR(right.value, 0.8, 1e-12);
  EXPECT_NEAR(right.low, 0.8 - 1.96 * 0.04, 0.012);
  EXPECT_NEAR(right.high, 0.8 + 1.96 * 0.04, 0.012);
}

TEST(ReadingSummary, TheBestIsTheSurestThenTheQuickest) {
  std::vector<StudyRow> rows;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    rows.push_back(Page("poor", seed, 20, 10, 50));
    rows.push_back(Page("slow", seed, 20, 20, 200));
    rows.push_back(Page("quick", seed, 20, 20, 100));
  }
  const ReadingSummary summary = SummariseReading(rows);
  EXPECT_EQ(summary.cells.at(summary.best.value()).condition, "quick");
}

const std::string kSmall = R"(title = "Small"
[reading]
pages = 2
letters = 5
size_mm = [6.0, 12.0]
)";

class ReadingStudy : public CliTest {
 protected:
  std::string Whole(int threads) {
    WriteAll(In("small.toml"), kSmall);
    StudyOutput output;
    output.path = In("whole-" + std::to_string(threads) + ".csv");
    output.threads = threads;
    StudyProtocol protocol = LoadStudy(In("small.toml"));
    CompleteSweep(*protocol.reading, "small.toml");
    RunStudy(protocol, output);
    std::ifstream file(output.path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(ReadingStudy, GivesTheSameBytesForAnyNumberOfThreadsAndReadsThemBack) {
  const std::string one = Whole(1);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1 + 4);
  EXPECT_EQ(one, Whole(3));
  const std::vector<StudyRow> rows = ParseRows(one, "whole-1.csv");
  ASSERT_EQ(rows.size(), 4U);
  for (const StudyRow& row : rows) EXPECT_EQ(FormatRow(row), row.line);
  EXPECT_EQ(rows[0].page->read.signs, 5U);
  EXPECT_EQ(rows[3].condition, "12mm");
  EXPECT_GT(rows[3].page->read.duration, 10);
}

TEST_F(ReadingStudy, TakesNoOutputThatAnotherStudyHasBegun) {
  WriteAll(In("small.toml"), kSmall);
  std::filesystem::create_directories(In("a.csv.parts"));
  WriteAll(In("a.csv.parts/full-1.csv"), "begun\n");
  const Outcome outcome = RunLine({"study", In("small.toml"), "--output", In("a.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("full-1.csv: is another study's"), std::string::npos) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(In("a.csv.parts/full-1.csv")));
}

TEST_F(ReadingStudy, IsDrawnToo) {
  WriteAll(In("small.toml"), kSmall);
  const Outcome drawn = RunLine({"study", In("small.toml"), "--output", In("drawn.csv"),
                                 "--picture", In("drawn.svg"), "--json"});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(drawn.Json()["picture"], In("drawn.svg"));
  EXPECT_TRUE(std::filesystem::exists(In("drawn.svg")));
  const Outcome learners = RunLine({"study", "guidance", "--picture", In("drawn.svg")});
  EXPECT_EQ(learners.code, 2);
  EXPECT_NE(learners.err.find("leave it out"), std::string::npos) << learners.err;
}

TEST_F(ReadingStudy, AShareMayHaveNoPage) {
  WriteAll(In("small.toml"), kSmall);
  const Outcome none =
      RunLine({"study", In("small.toml"), "--shard", "9/9", "--json", "--output", In("none.csv")});
  EXPECT_EQ(none.code, 0) << none.err;
  EXPECT_EQ(none.Json()["pages"], 0);
  EXPECT_TRUE(none.Json()["best"].is_null());
}

TEST_F(ReadingStudy, SharesMergeToTheWhole) {
  const std::string whole = Whole(2);
  for (const char* shard : {"1/2", "2/2"}) {
    const Outcome share = RunLine({"study", In("small.toml"), "--shard", shard, "--output",
                                   In(std::string("share") + shard[0] + ".csv")});
    EXPECT_EQ(share.code, 0) << share.err;
    EXPECT_NE(share.out.find("This is share "), std::string::npos);
    EXPECT_EQ(share.out.find("Surest"), std::string::npos) << share.out;
  }
  const Outcome json = RunLine({"study", In("small.toml"), "--shard", "2/2", "--json", "--output",
                                In("share2.csv"), "--picture", In("share.svg")});
  EXPECT_TRUE(json.Json()["best"].is_null());
  EXPECT_EQ(json.Json()["shard"], "2/2");
  EXPECT_EQ(ReadAll(In("share.svg")).find("Surest"), std::string::npos);
  const Outcome merged =
      RunLine({"study", "merge", In("share1.csv"), In("share2.csv"), "--output", In("merged.csv")});
  EXPECT_EQ(merged.code, 0) << merged.err;
  std::ifstream file(In("merged.csv"), std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), whole);
}

TEST_F(ReadingStudy, SaysWhatCameOfIt) {
  WriteAll(In("small.toml"), kSmall);
  const std::vector<std::string> line = {"study", In("small.toml"), "--output", In("a.csv")};
  const Outcome outcome = RunLine(line);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  ExpectTextFace(outcome.out);
  EXPECT_EQ(outcome.out.rfind("Study done: 4 pages of 2 kinds read.\n6mm: ", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("not people"), std::string::npos);
  const auto json = RunLine(With(line, {"--json"})).Json();
  EXPECT_EQ(json["pages"], 4);
  EXPECT_EQ(json["cells"][1]["size_mm"], 12);
  EXPECT_EQ(json["cells"][1]["signs"], 10);
  EXPECT_TRUE(json["best"].is_string());
  EXPECT_TRUE(json["shard"].is_null());
}

}  // namespace
}  // namespace moontrace

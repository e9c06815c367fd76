#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/trial/record_columns.h"
#include "tests/sim/cli_fixture.h"
#include "textures/base/resources.h"

namespace moontrace {
namespace {

class ReplayCommand : public CliTest {
 protected:
  void Record(const std::vector<std::string>& more = {}, const std::string& text = "IT") {
    const Outcome outcome = RunLine(With({"trace", text, "--record", In("r")}, more));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  /// Turns the last bit of one number in samples.f64.
  void Flip(std::size_t tick, std::string_view column) {
    const auto found = std::find(kRecordColumns.begin(), kRecordColumns.end(), column);
    ASSERT_NE(found, kRecordColumns.end());
    std::string samples = ReadAll(In("r/samples.f64"));
    const auto index = static_cast<std::size_t>(found - kRecordColumns.begin());
    char& byte = samples.at(tick * kRowBytes + 8 * index);
    byte = static_cast<char>(byte ^ 1);
    WriteAll(In("r/samples.f64"), samples);
  }

  /// One line on what is altered, and no result; with --check also what the replay came to.
  void ExpectAltered(const std::string& replayed) {
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--check"}, std::vector<std::string>{"--check", "--json"},
          std::vector<std::string>{}}) {
      const Outcome outcome = RunLine(With({"replay", In("r")}, more));
      EXPECT_EQ(outcome.code, 3) << outcome.out << outcome.err;
      EXPECT_EQ(outcome.out, "");
      EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
      EXPECT_EQ(outcome.err.rfind(In("r/samples.f64") + ": altered within ticks ", 0), 0U);
      const bool checked = !more.empty();
      EXPECT_EQ(outcome.err.find(replayed) != std::string::npos, checked) << outcome.err;
    }
  }
};

TEST_F(ReplayCommand, IsBitEqualWhateverTheOptions) {
  const std::vector<std::vector<std::string>> all = {
      {},
      {"--blank"},
      {"--render", "direct", "--law", "paper", "--seed", "7"},
      {"--embossed", "--size-mm", "9", "--friction", "0.2", "--tilt-deg", "15"},
      {"--h-form", "pocket", "--grade", "0.5", "--letter-gap-mm", "1.3", "--page", "a5"},
  };
  for (const std::vector<std::string>& more : all) {
    Record(more, "HI");
    const Outcome outcome = RunLine({"replay", In("r"), "--check"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.rfind("Replay is bit-equal over ", 0), 0U);
    std::filesystem::remove_all(In("r"));
  }
}

TEST_F(ReplayCommand, SaysWhatWasTracedAndTheResults) {
  Record();
  const Outcome outcome = RunLine({"replay", In("r")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Recorded: \"IT\", letters 12 mm high."), std::string::npos);
  EXPECT_EQ(outcome.out.find("_mm"), std::string::npos) << outcome.out;  // keys are for programs
  ExpectTextFace(outcome.out);
  const nlohmann::json json = RunLine({"replay", In("r"), "--json", "--quiet"}).Json();
  EXPECT_EQ(json["text"], "IT");
  EXPECT_TRUE(json["bit_equal"]);
  EXPECT_GT(json["ticks"], 1000);
  EXPECT_GE(json["total"]["coverage"], 0.98);
}

// What `trace` said when it was recorded, word for word; before, 39 lines of keys and values.
TEST_F(ReplayCommand, SaysTheResultsInTheSentencesOfTrace) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, std::vector<std::string>{"--blank", "--guide", "rail"}}) {
    const Outcome trace = RunLine(With({"trace", "ME", "--record", In("r")}, more));
    const std::string replay = RunLine({"replay", In("r")}).out;
    ExpectTextFace(replay);
    int same = 0;
    for (const std::string& line : Lines(trace.out)) {
      const bool told_now_only = line.rfind("Time:", 0) == 0 || line.rfind("Record", 0) == 0 ||
                                 line.rfind("Weakest", 0) == 0 || line == In("r");
      if (told_now_only) continue;
      EXPECT_NE(("\n" + replay).find("\n" + line + "\n"), std::string::npos) << line << "\n"
                                                                             << replay;
      ++same;
    }
    EXPECT_GE(same, 8);
    EXPECT_NE(replay.find(" s of hand time, "), std::string::npos);
    std::filesystem::remove_all(In("r"));
  }
}

TEST_F(ReplayCommand, SameSeedWritesTheSameSamples) {
  Record();
  const std::string first = ReadAll(In("r/samples.f64"));
  std::filesystem::remove_all(In("r"));
  Record();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(ReadAll(In("r/samples.f64")), first);
}

TEST_F(ReplayCommand, RefusesAnAlteredRecordAndCheckNamesTheFirstTickThatDiffers) {
  Record();
  Flip(700, "device_x_m");  // the last bit of what was put in: what comes out differs there
  ExpectAltered("replay differs first at tick 700: tip_x_m");
}

TEST_F(ReplayCommand, RefusesARecordAlteredWhereNothingIsComputed) {
  Record();
  for (const char* column : {"phase", "stroke"}) {
    Flip(700, column);
    ExpectAltered("what the scene computes from it is unchanged");
    Flip(700, column);  // back again
  }
  EXPECT_EQ(RunLine({"replay", In("r"), "--check"}).code, 0);
}

TEST_F(ReplayCommand, ReportsTheFirstTickOfARecordThatIsWholeButComesOutOtherwise) {
  Record();
  // As another processor's rounding would: one output is another's, and the record is sound.
  const moontrace::Record record = ReadRecord(In("r"));
  Scene scene = Scene::FromXml(record.model_xml, "model.xml", record.options);
  scene.SetState(record.state);
  Recorder recorder(In("other"), record.head, scene);
  for (std::size_t tick = 0; tick < record.rows.size(); ++tick) {
    RecordRow row = record.rows[tick];
    if (tick == 700) row.output.force_P.z += 1e-9;
    recorder.Add(row);
  }
  recorder.Finish(record.result_json, false);
  const Outcome outcome = RunLine({"replay", In("other"), "--check"});
  EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.rfind("Replay differs first at tick 700 of ", 0), 0U) << outcome.out;
  const Outcome json = RunLine({"replay", In("other"), "--check", "--json"});
  EXPECT_EQ(json.code, 1);
  EXPECT_EQ(json.Json()["first_difference"], 700);
  EXPECT_EQ(json.Json()["column"], "force_z_n");
  EXPECT_FALSE(json.Json()["bit_equal"]);
}

TEST_F(ReplayCommand, FindsAScriptOfOnesOwnFromAnyFolder) {
  const std::filesystem::path before = std::filesystem::current_path();
  const std::string moon = ResourcePath("textures/scripts/moon.svg");
  std::filesystem::copy_file(moon, In("own.svg"));
  std::filesystem::current_path(folder_);
  const Outcome trace = RunLine({"trace", "I", "--script", "./own.svg", "--record", "r"});
  std::filesystem::current_path(before);
  ASSERT_EQ(trace.code, 0) << trace.err;
  const Outcome replay = RunLine({"replay", In("r"), "--check"});
  EXPECT_EQ(replay.code, 0) << replay.err;
  const Outcome named = RunLine({"trace", "I", "--script", "moon", "--record", In("m")});
  ASSERT_EQ(named.code, 0) << named.err;
  const nlohmann::json sheet = nlohmann::json::parse(ReadAll(In("m") + "/trial.json"));
  EXPECT_EQ(sheet["parameters"]["script"], "moon");
}

TEST_F(ReplayCommand, WantsAFolder) {
  EXPECT_EQ(RunLine({"replay"}).code, 2);
  EXPECT_EQ(RunLine({"replay", In("none")}).code, 3);
}

}  // namespace
}  // namespace moontrace

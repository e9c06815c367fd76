#include "sim/app/replay_command.h"

#include <gtest/gtest.h>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class ReplayCommand : public CliTest {
 protected:
  void Record(const std::vector<std::string>& more = {}, const std::string& text = "IT") {
    const Outcome outcome = RunLine(With({"trace", text, "--record", In("r")}, more));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
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
  EXPECT_NE(outcome.out.find("\ncoverage: "), std::string::npos);
  ExpectTextFace(outcome.out);
  const nlohmann::json json = RunLine({"replay", In("r"), "--json", "--quiet"}).Json();
  EXPECT_EQ(json["text"], "IT");
  EXPECT_TRUE(json["bit_equal"]);
  EXPECT_GT(json["ticks"], 1000);
  EXPECT_GE(json["total"]["coverage"], 0.98);
}

TEST_F(ReplayCommand, SameSeedWritesTheSameSamples) {
  Record();
  const std::string first = ReadAll(In("r/samples.f64"));
  std::filesystem::remove_all(In("r"));
  Record();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(ReadAll(In("r/samples.f64")), first);
}

TEST_F(ReplayCommand, CheckNamesTheFirstTickThatDiffers) {
  Record();
  const nlohmann::json sheet = nlohmann::json::parse(ReadAll(In("r/trial.json")));
  std::string samples = ReadAll(In("r/samples.f64"));
  const std::size_t ticks = RunLine({"replay", In("r"), "--json"}).Json()["ticks"];
  const std::size_t row = samples.size() / ticks;
  ASSERT_EQ(samples.size() % ticks, 0U);
  // The last bit of the tip's x position as put in at tick 700 differs: what comes out differs
  // there.
  const std::size_t input_x = 700 * row + 8;
  samples[input_x] = static_cast<char>(samples[input_x] ^ 1);
  WriteAll(In("r/samples.f64"), samples);
  const Outcome outcome = RunLine({"replay", In("r"), "--check"});
  EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.rfind("Replay differs first at tick 700 of ", 0), 0U) << outcome.out;
  const Outcome json = RunLine({"replay", In("r"), "--check", "--json"});
  EXPECT_EQ(json.Json()["first_difference"], 700);
  // Without --check an altered record is refused.
  EXPECT_EQ(RunLine({"replay", In("r")}).code, 3);
}

TEST_F(ReplayCommand, WantsAFolder) {
  EXPECT_EQ(RunLine({"replay"}).code, 2);
  EXPECT_EQ(RunLine({"replay", In("none")}).code, 3);
}

}  // namespace
}  // namespace moontrace

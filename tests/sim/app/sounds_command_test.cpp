#include "sim/app/commands.h"

#include <cstdlib>

#include "sim/audio/earcon.h"
#include "sim/audio/sound_messages.h"
#include "sim/audio/wav.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class SoundsCommand : public CliTest {
 protected:
  SoundsCommand() { setenv("XDG_CONFIG_HOME", In("config").c_str(), 1); }
  ~SoundsCommand() override { unsetenv("XDG_CONFIG_HOME"); }
};

TEST_F(SoundsCommand, NamesEachSoundAndWhatItMeans) {
  const Outcome outcome = RunLine({"sounds"});
  EXPECT_EQ(outcome.code, 0);
  ExpectTextFace(outcome.out);
  EXPECT_EQ(outcome.out.find("path: the tip touches."), 0U);
  for (const Earcon earcon : AllEarcons()) {
    const std::string begin = say::EarconName(earcon) + ": ";
    std::size_t lines = 0;
    for (const std::string& line : Lines(outcome.out)) lines += line.find(begin) == 0 ? 1 : 0;
    EXPECT_EQ(lines, 1U) << KeyOf(earcon);
  }
}

TEST_F(SoundsCommand, WritesEachAsAWavFile) {
  const Outcome outcome = RunLine({"sounds", "--wav", In("out")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const Earcon earcon : AllEarcons()) {
    const std::string path = In("out/" + std::string(KeyOf(earcon)) + ".wav");
    EXPECT_NE(outcome.out.find(path + "\n"), std::string::npos);
    const Wav wav = ParseWav(ReadAll(path), path, 0.53);
    EXPECT_EQ(wav.channels, 2U);
    EXPECT_GT(*std::max_element(wav.samples.begin(), wav.samples.end()), 0.05F) << path;
  }
  const Wav path = ParseWav(ReadAll(In("out/path.wav")), "", 5);
  EXPECT_GT(path.samples.size(), 4U * 2 * 48000);
}

TEST_F(SoundsCommand, LeavesOutWhatIsSwitchedOff) {
  WriteAll(In("own.toml"), "[right]\non = false\n[path]\non = false\n");
  const Outcome outcome = RunLine({"sounds", "--sounds", In("own.toml"), "--wav", In("out")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("right: that was right. Two brassy notes, rising. Switched off."),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(In("out/right.wav")));
  EXPECT_FALSE(std::filesystem::exists(In("out/path.wav")));
  EXPECT_TRUE(std::filesystem::exists(In("out/wrong.wav")));
}

TEST_F(SoundsCommand, ListsAsJson) {
  const nlohmann::json list = RunLine({"sounds", "--json"}).Json()["sounds"];
  ASSERT_EQ(list.size(), kEarcons + 1);
  EXPECT_EQ(list[0]["name"], "path");
  for (std::size_t i = 1; i < list.size(); ++i) {
    EXPECT_EQ(list[i]["name"], KeyOf(AllEarcons()[i - 1]));
    EXPECT_EQ(list[i]["on"], true);
    EXPECT_LT(list[i]["seconds"].get<double>(), 0.5);
  }
}

TEST_F(SoundsCommand, RefusesWhatIsWrongInOneLine) {
  WriteAll(In("own.toml"), "[rihgt]\non = false\n");
  const Outcome broken = RunLine({"sounds", "--sounds", In("own.toml")});
  EXPECT_EQ(broken.code, 3);
  EXPECT_EQ(Lines(broken.err).size(), 1U);
  EXPECT_EQ(RunLine({"sounds", "--sounds", In("none.toml")}).code, 3);
  EXPECT_EQ(RunLine({"sounds", "--wav", ""}).code, 2);
  EXPECT_EQ(RunLine({"sounds", "loud"}).code, 2);
  WriteAll(In("file"), "");
  EXPECT_EQ(RunLine({"sounds", "--wav", In("file/below")}).code, 4);
}

}  // namespace
}  // namespace moontrace

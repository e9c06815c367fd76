#include "sim/audio/sound_table.h"

#include <cstdlib>

#include "sim/audio/wav.h"
#include "tests/sim/cli_fixture.h"
#include "textures/base/error.h"
#include "textures/base/resources.h"

namespace moontrace {
namespace {

class SoundTableTest : public CliTest {
 protected:
  SoundTableTest() { setenv("XDG_CONFIG_HOME", In("config").c_str(), 1); }
  ~SoundTableTest() override { unsetenv("XDG_CONFIG_HOME"); }
  /// What LoadSounds says of a file with this text, without the file's name.
  std::string WhyNot(const std::string& text) {
    WriteAll(In("own.toml"), text);
    try {
      LoadSounds(In("own.toml"));
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find('\n'), std::string::npos);
      return what.find(In("own.toml")) == 0 ? what.substr(In("own.toml").size() + 1) : what;
    }
    return {};
  }
};

const EarconSound& Of(const SoundTable& table, Earcon earcon) {
  return table.earcons[static_cast<std::size_t>(earcon)];
}

TEST_F(SoundTableTest, ShippedHasNotesForEveryEarcon) {
  const SoundTable table = LoadSounds();
  for (const Earcon earcon : AllEarcons()) {
    EXPECT_TRUE(Of(table, earcon).on) << KeyOf(earcon);
    EXPECT_FALSE(Of(table, earcon).notes.empty()) << KeyOf(earcon);
  }
  EXPECT_EQ(table.path.low, 200);  // 2008 study: 200 to 400 Hz
  EXPECT_EQ(table.path.high, 400);
}

TEST_F(SoundTableTest, OfTheUserChangesWhatItHoldsAndNoMore) {
  std::filesystem::create_directories(In("config/moontrace"));
  WriteAll(In("config/moontrace/sounds.toml"),
           "volume = 0.25\n[right]\non = false\n[wrong]\nhz = [300]\nms = [100]\n");
  const SoundTable shipped = LoadSounds(ResourcePath("sim/app/sounds.toml"));
  const SoundTable table = LoadSounds();
  EXPECT_EQ(table.volume, 0.25);
  EXPECT_FALSE(Of(table, Earcon::kRight).on);
  ASSERT_EQ(Of(table, Earcon::kWrong).notes.size(), 1U);
  EXPECT_EQ(Of(table, Earcon::kWrong).notes[0].pitch, 300);
  EXPECT_DOUBLE_EQ(Of(table, Earcon::kWrong).notes[0].length, 0.1);
  EXPECT_EQ(Of(table, Earcon::kWrong).timbre, Of(shipped, Earcon::kWrong).timbre);
  EXPECT_EQ(Of(table, Earcon::kPageEnd).notes.size(), Of(shipped, Earcon::kPageEnd).notes.size());
}

TEST_F(SoundTableTest, TakesARecordingFromBesideTheFile) {
  Wav wav{24000, 1, std::vector<float>(6000, 0.5F)};
  WriteAll(In("ding.wav"), WavBytes(wav));
  EXPECT_EQ(WhyNot("[right]\nfile = 'ding.wav'\n"), "");
  EXPECT_EQ(Of(LoadSounds(In("own.toml")), Earcon::kRight).recording.size(), 12000U);
  wav.samples.resize(13000);
  WriteAll(In("ding.wav"), WavBytes(wav));
  EXPECT_EQ(WhyNot("[right]\nfile = 'ding.wav'\n"),
            In("ding.wav") + ": is longer than 0.5 s; cut it");
  WriteAll(In("ding.wav"), std::string((1 << 20) + 1, 'R'));
  EXPECT_NE(WhyNot("[right]\nfile = 'ding.wav'\n").find(In("ding.wav")), std::string::npos);
  EXPECT_NE(WhyNot("[right]\nfile = 'none.wav'\n").find("none.wav"), std::string::npos);
}

TEST_F(SoundTableTest, ThatIsWrongIsRefusedWithItsPlace) {
  EXPECT_EQ(WhyNot("volume = 2\n"), "1:10: volume: is out of range: 0 to 1");
  EXPECT_EQ(WhyNot("[rihgt]\non = true\n").find("1:"), 0U);
  EXPECT_NE(WhyNot("[rihgt]\non = true\n").find("right"), std::string::npos);
  EXPECT_NE(WhyNot("[right]\ntimbre = 'brss'\n").find("did you mean brass?"), std::string::npos);
  EXPECT_NE(WhyNot("[right]\nhz = [100]\nms = [100]\n").find("2:6: hz: holds 100"),
            std::string::npos);
  EXPECT_NE(WhyNot("[right]\nhz = [6000]\nms = [100]\n").find("holds 6000"), std::string::npos);
  EXPECT_NE(WhyNot("[right]\nhz = [300, 400]\nms = [100]\n").find("as many values as hz"),
            std::string::npos);
  EXPECT_NE(WhyNot("[right]\nhz = [300, 400]\nms = [300, 200]\n").find("500 or more"),
            std::string::npos);
  EXPECT_NE(WhyNot("[right]\nhz = [300]\nms = [1]\n").find("click"), std::string::npos);
  EXPECT_NE(WhyNot("[path]\nlow_hz = 400\n").find("must be above"), std::string::npos);
  EXPECT_NE(WhyNot("[path]\nvolume = 0.9\n").find("more than 1 together"), std::string::npos);
  EXPECT_NE(WhyNot("[path\n").find("1:"), std::string::npos);
}

}  // namespace
}  // namespace moontrace

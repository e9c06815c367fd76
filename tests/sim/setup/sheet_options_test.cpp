// Rules, raised margin and texture, from the command line to page, record and picture.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "sim/physics/label.h"
#include "sim/setup/sheet_options.h"
#include "tests/sim/cli_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

class SheetOptionsOf : public CliTest {
 protected:
  /// A picture of 3 x 2 samples.
  std::string Picture() const {
    const std::string path = In("rough.pgm");
    std::ofstream(path) << "P2 3 2 255 0 128 255 255 0 0\n";
    return path;
  }
};

TEST_F(SheetOptionsOf, PageSaysWhatTheSheetHas) {
  const std::vector<std::string> line{"page",
                                      "moon",
                                      "--size-mm",
                                      "10",
                                      "--rules",
                                      "--rule-width-mm",
                                      "1",
                                      "--rule-height-mm",
                                      "0.09",
                                      "--raised-margin",
                                      "--raised-margin-width-mm",
                                      "1.5",
                                      "--raised-margin-height-mm",
                                      "0.3",
                                      "--texture",
                                      "sine",
                                      "--texture-amplitude-mm",
                                      "0.05",
                                      "--texture-wavelength-mm",
                                      "3",
                                      "--texture-angle-deg",
                                      "20"};
  const Outcome words = RunLine(line);
  EXPECT_EQ(words.code, 0) << words.err;
  ExpectTextFace(words.out);
  // slopes: 0.09 / (0.5 - 0.2), 0.3 / (0.75 - 0.3)
  for (const char* part : {"Line rules: 2, 1 mm wide, 0.09 mm high.",
                           "A rule turns the tip back up to 0.30 N at 1 N of press.",
                           "Raised margin: 1.5 mm wide, 0.3 mm high.",
                           "The margin turns the tip back up to 0.67 N at 1 N of press.",
                           "Texture: parallel waves, 0.05 mm up and down, every 3 mm."}) {
    EXPECT_NE(words.out.find(part), std::string::npos) << part << "\n" << words.out;
  }
  const nlohmann::json json = RunLine(With(line, {"--json"})).Json();
  EXPECT_EQ(json["rules"]["count"], 2);
  EXPECT_NEAR(json["rules"]["turning_force_n"], 0.3, 1e-9);
  EXPECT_NEAR(json["raised_margin"]["height_mm"], 0.3, 1e-9);
  EXPECT_EQ(json["texture"]["kind"], "sine");
  EXPECT_NEAR(json["texture"]["wavelength_mm"], 3, 1e-9);
  const nlohmann::json plain = RunLine({"page", "moon", "--json"}).Json();
  EXPECT_TRUE(plain["rules"].is_null() && plain["texture"].is_null());
}

TEST_F(SheetOptionsOf, APictureIsATexture) {
  const Outcome words = RunLine({"page", "moon", "--texture", Picture()});
  EXPECT_NE(words.out.find("Texture: a picture of 3 by 2 heights, 0.03 mm up and down, stretched."),
            std::string::npos)
      << words.out << words.err;
  const nlohmann::json json =
      RunLine({"page", "moon", "--texture", Picture(), "--texture-wavelength-mm", "9", "--json"})
          .Json();
  EXPECT_EQ(json["texture"]["samples"], (std::vector<int>{3, 2}));
  EXPECT_NEAR(json["texture"]["wavelength_mm"], 9, 1e-9);
  EXPECT_EQ(json["texture"]["memory_bytes"], 24);
}

TEST_F(SheetOptionsOf, MistakesAreOneLine) {
  const auto fails = [](const std::vector<std::string>& more, int code, const std::string& part) {
    const Outcome outcome = RunLine(With({"page", "moon\nline"}, more));
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
  };
  fails({"--rule-width-mm", "1"}, 2, "--rule-width-mm needs --rules beside it");
  fails({"--raised-margin-height-mm", "1"}, 2, "needs --raised-margin beside it");
  fails({"--texture-wavelength-mm", "1"}, 2, "needs --texture beside it");
  fails({"--texture", "sand"}, 2, "choose none, sine, grid, noise or a .pgm file");
  fails({"--texture", "none.pgm"}, 3, "none.pgm");
  fails({"--texture", "sine", "--texture-amplitude-mm", "1"}, 3,
        "texture amplitude 1 mm is too steep for the wavelength 2 mm: at most 0.318 mm");
  fails({"--rules", "--line-pitch-mm", "14"}, 3, "leaves no room for rules 1.2 mm wide");
  fails({"--raised-margin", "--margin-mm", "1"}, 3, "no room in a margin of 1 mm");
  fails({"--rules", "--rule-height-mm", "9"}, 3, "too steep");
  // slope 1.67 of the letters and 0.8 of the sheet, times 0.5
  const Outcome stuck = RunLine(
      {"trace", "i", "--friction", "0.5", "--texture", "sine", "--texture-amplitude-mm", "0.25"});
  EXPECT_EQ(stuck.code, 3);
  EXPECT_NE(stuck.err.find("friction 0.5 is too high for the slope"), std::string::npos)
      << stuck.err;
}

TEST_F(SheetOptionsOf, ATraceIsReplayedBitForBit) {
  for (const std::string& texture : {std::string("noise"), Picture()}) {
    const std::string record = In("record" + std::to_string(texture.size()));
    const Outcome traced =
        RunLine({"trace", "i", "--page", "60x50", "--rules", "--rule-width-mm", "1.5",
                 "--raised-margin", "--texture", texture, "--record", record});
    ASSERT_EQ(traced.code, 0) << traced.err;
    const Outcome replayed = RunLine({"replay", record});
    EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
  }
}

TEST_F(SheetOptionsOf, APictureOfAWholeSheetIsOpenedByOtherPrograms) {
  // libxml2, which most of them read SVG with, refuses an attribute of ten million characters.
  for (const char* texture : {"sine", "grid", "noise"}) {
    const std::string picture = In("sheet.svg");
    ASSERT_EQ(RunLine({"page", "moon", "--texture", texture, "--picture", picture}).code, 0);
    const std::string svg = ReadAll(picture);
    EXPECT_LT(svg.size(), 4'000'000U) << texture;
    for (const std::string& mark : Lines(svg)) EXPECT_LT(mark.size(), 1'000'000U) << texture;
  }
}

TEST_F(SheetOptionsOf, PicturesShowThemAndSaySo) {
  const std::string picture = In("page.svg");
  const Outcome outcome = RunLine({"page", "moon", "--page", "120x50", "--rules", "--raised-margin",
                                   "--texture", "grid", "--picture", picture});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::ifstream file(picture);
  const std::string svg{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(svg.find("Line rules 1.2 mm wide, green. Raised margin 1.2 mm wide, green. Paper rough "
                     "with waves"),
            std::string::npos);
  EXPECT_NE(svg.find("its crests shaded"), std::string::npos);
}

TEST(SheetLabel, HasATextureOfItsOwn) {
  const Label label = ParseLabel(
      "moontrace:mug", "{texture='grid', texture_amplitude_mm=0.02, texture_wavelength_mm=1.5}",
      "mug.xml");
  const SheetTexture texture = SheetTextureOf({}, label);
  ASSERT_TRUE(texture.paper.has_value());
  EXPECT_EQ(texture.paper->kind, PaperKind::kGrid);
  EXPECT_NEAR(texture.paper->amplitude, 20e-6, 1e-15);
  EXPECT_NEAR(texture.paper->wavelength, 1.5e-3, 1e-15);
  SheetOptions none;
  none.texture = "none";
  EXPECT_FALSE(SheetTextureOf(none, label).paper.has_value());
  EXPECT_THROW(ParseLabel("moontrace:mug", "{texture='sand'}", "mug.xml"), InputError);
}

// A line pitch that somebody gives is theirs; the usual one makes room for the rules.
TEST(LineRules, FitByThemselvesWhereNoPitchIsGiven) {
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--script", "braille"},
                                             {"--script", "braille", "--embossed"},
                                             {"--script", "braille", "--size-mm", "8"},
                                             {"--size-mm", "2"},
                                             {"--size-mm", "2", "--links", "words"},
                                             {"--size-mm", "3", "--rule-width-mm", "1"}}) {
    const Outcome outcome = RunLine(With({"page", "mug (wh/who)\nmug", "--rules"}, more));
    EXPECT_EQ(outcome.code, 0) << more.back() << ": " << outcome.err;
  }
  const auto pitch = [](const std::vector<std::string>& more) {
    return RunLine(With({"page", "moon", "--json"}, more)).Json()["line_pitch_mm"].get<double>();
  };
  EXPECT_DOUBLE_EQ(pitch({"--rules"}), pitch({}));  // 1.8 sizes have room at 12 mm
  // as the refusal says of 10 mm, the usual pitch
  EXPECT_NEAR(pitch({"--rules", "--script", "braille"}), 10.5, 1e-9);
  const Outcome given =
      RunLine({"page", "mug\nmug", "--rules", "--script", "braille", "--line-pitch-mm", "8"});
  EXPECT_EQ(given.code, 3);
  EXPECT_NE(given.err.find("choose a line pitch of"), std::string::npos) << given.err;
}

}  // namespace
}  // namespace moontrace

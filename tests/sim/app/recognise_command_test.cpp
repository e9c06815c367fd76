#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <utility>

#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class RecogniseCommand : public CliTest {};

nlohmann::json Recognised(const std::vector<std::string>& more) {
  const Outcome outcome = RunLine(With({"recognise", "so", "--json"}, more));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.Json();
}

/// Without the one value that depends on the machine.
nlohmann::json Exact(nlohmann::json json) {
  json.erase("real_time_factor");
  return json;
}

TEST_F(RecogniseCommand, SaysWhatWasReadAndHowWell) {
  const Outcome outcome = RunLine({"recognise", "so"});
  EXPECT_EQ(outcome.code, 0);
  const std::vector<std::string> lines = Lines(outcome.out);
  // two letters and the line's end
  EXPECT_EQ(lines.front(), "3 of 3 right; 0 wrong, 0 missed, 0 extra. Spaces and line ends count.");
  EXPECT_EQ(lines.back(), "so");
  ExpectTextFace(outcome.out);
}

TEST_F(RecogniseCommand, GivesItsFiguresAsJson) {
  const nlohmann::json json = Recognised({});
  EXPECT_EQ(json["text"], "so\n");
  EXPECT_EQ(json["right"], 3);
  EXPECT_EQ(json["wrong"], 0);
  EXPECT_EQ(json["missed"], 0);
  EXPECT_EQ(json["extra"], 0);
  EXPECT_EQ(json["signs"], 2);
  EXPECT_EQ(json["ended"], true);
  EXPECT_NEAR(json["seconds_per_sign"], json["duration_s"].get<double>() / 2, 1e-9);
  EXPECT_GT(json["real_time_factor"], 0);
  ASSERT_EQ(json["read"].size(), 2U);
  EXPECT_EQ(json["read"][0]["sign"], "s");
  EXPECT_GT(json["read"][0]["probability"], 0.9);
  EXPECT_LE(json["read"][0]["probability"], 1);
  EXPECT_LT(json["read"][0]["time_s"], json["duration_s"]);
}

// Which form of h it was is not told apart, so none is named.
TEST_F(RecogniseCommand, NamesASignByItsPlainForm) {
  for (const char* form : {"crescent", "arc", "pocket"}) {
    const Outcome outcome = RunLine({"recognise", "hah", "--h-form", form, "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json json = outcome.Json();
    EXPECT_EQ(json["text"], "hah\n") << form;
    for (const nlohmann::json& read : json["read"]) {
      EXPECT_EQ(read["sign"].get<std::string>().find('.'), std::string::npos) << read["sign"];
    }
  }
}

TEST_F(RecogniseCommand, TheSeedDecidesEverything) {
  EXPECT_EQ(Exact(Recognised({"--seed", "5"})), Exact(Recognised({"--seed", "5"})));
  EXPECT_NE(Recognised({"--seed", "5"})["duration_s"], Recognised({"--seed", "6"})["duration_s"]);
}

TEST_F(RecogniseCommand, ReadsNothingOnBlankPaper) {
  const nlohmann::json json = Recognised({"--blank"});
  EXPECT_EQ(json["text"], "");
  EXPECT_EQ(json["extra"], 0);
  EXPECT_TRUE(json["seconds_per_sign"].is_null());
  const Outcome words = RunLine({"recognise", "so", "--blank"});
  EXPECT_EQ(Lines(words.out).front().substr(0, 17), "Nothing was read:");
  EXPECT_EQ(words.out.find("there."), std::string::npos) << words.out;
  const Outcome light = RunLine({"recognise", "so", "--press-n", "0.01"});  // it floats over them
  EXPECT_NE(light.out.find("s. 2 signs lie there.\n"), std::string::npos) << light.out;
}

TEST_F(RecogniseCommand, DrawsItsPath) {
  const nlohmann::json json = Recognised({"--picture", In("path.svg")});
  EXPECT_EQ(json["pictures"][0], In("path.svg"));
  ExpectOnly({"path.svg"});
  const std::string svg = ReadAll(folder_ / "path.svg");
  EXPECT_NE(svg.find("Read: so"), std::string::npos);
  EXPECT_NE(svg.find("<path"), std::string::npos);
}

TEST_F(RecogniseCommand, TakesTheTextFromAFileAndTheOptionsOfPages) {
  WriteAll(folder_ / "text.txt", "so\n");
  const Outcome outcome = RunLine(
      {"recognise", "--file", In("text.txt"), "--size-mm", "6", "--press-n", "0.8", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.Json()["text"], "so\n");
  EXPECT_EQ(outcome.Json()["size_mm"], 6.0);
}

TEST_F(RecogniseCommand, PutsTheHandOnADevice) {
  const nlohmann::json json = Recognised({"--device", "moontrace-raw"});
  EXPECT_EQ(json["text"], "so\n");
  EXPECT_EQ(json["device"], "moontrace-raw");
  EXPECT_EQ(json["through"], 0);
  EXPECT_TRUE(Recognised({})["device"].is_null());
  const Outcome refused = RunLine({"recognise", "so", "--device", "spacemouse"});
  EXPECT_EQ(refused.code, 3);  // it has no force
  EXPECT_NE(refused.err.find("measures and pushes x and y"), std::string::npos);
  EXPECT_EQ(RunLine({"recognise", "so", "--device", "nowhere"}).code, 3);
}

// Its stick goes 140 mm each way and has no height: letters of 20 mm stand on two sheets.
TEST_F(RecogniseCommand, TurnsThePagesOfAJoystick) {
  const Outcome outcome = RunLine({"recognise", "so moon shine on rain", "--device", "openffboard",
                                   "--size-mm", "20", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.Json()["read"].back()["page"], 1);
  EXPECT_GE(outcome.Json()["signs_right"], 16);  // of 17; of 800 others 1 was wrong
}

TEST_F(RecogniseCommand, SaysWhereThePaperGaveWay) {
  const Outcome outcome =
      RunLine({"recognise", "so", "--device", "woodenhaptics", "--press-n", "8"});
  EXPECT_NE(outcome.err.find("the paper gave way"), std::string::npos) << outcome.err;
}

TEST_F(RecogniseCommand, TakesAnUnsureHand) {
  const nlohmann::json json = Recognised({"--unsure-mm", "0.2"});
  EXPECT_EQ(json["unsure_mm"], 0.2);
  EXPECT_NE(json["duration_s"], Recognised({})["duration_s"]);
  EXPECT_EQ(RunLine({"recognise", "so", "--unsure-mm", "-1"}).code, 2);
}

TEST_F(RecogniseCommand, SaysBeforehandWhereItGetsLost) {
  for (const char* text : {"so we", "so  we", "   so", "so\n  we"}) {
    EXPECT_EQ(RunLine({"recognise", text, "--blank"}).err, "") << text;
  }
  for (const char* text : {"so   we", "so\n     we"}) {
    const Outcome outcome = RunLine({"recognise", text, "--blank"});
    EXPECT_NE(outcome.err.find("wide gaps"), std::string::npos) << text;
  }
  const Outcome wide = RunLine({"recognise", "so we", "--word-gap-mm", "8", "--blank"});
  EXPECT_NE(wide.err.find("wide gaps"), std::string::npos) << wide.err;
  EXPECT_EQ(RunLine({"recognise", "so we", "--word-gap-mm", "6", "--blank"}).err, "");
  // over ridges it hatches whole lines
  for (const char* text : {"so  we", "  so"}) {
    const Outcome ridges = RunLine({"recognise", text, "--blank", "--embossed"});
    EXPECT_NE(ridges.err.find("wide gaps"), std::string::npos) << text;
  }
}

// On paper without letters there is nothing that could buzz.
TEST_F(RecogniseCommand, WarnsOfDirectRendering) {
  const Outcome outcome = RunLine({"recognise", "i", "--render", "direct"});
  EXPECT_NE(outcome.err.find("Direct rendering will buzz"), std::string::npos) << outcome.err;
  EXPECT_EQ(RunLine({"recognise", "i", "--render", "direct", "--blank"}).err, "");
}

TEST_F(RecogniseCommand, ReadsLinesHoweverTheyRun) {
  for (const char* lines : {"alternate", "right-to-left", "vertical"}) {
    const Outcome outcome =
        RunLine({"recognise", "the moon rose\nthe sea rose", "--lines", lines, "--json"});
    EXPECT_EQ(outcome.err, "");
    for (const char* fault : {"wrong", "missed", "extra"}) {
      EXPECT_EQ(outcome.Json()[fault], 0) << outcome.out;
    }
  }
}

// By this seed it has looked beyond a line's end already, before it finds that the line ends: no
// way is left to look along.
TEST_F(RecogniseCommand, EndsALineBeyondWhichItHasLooked) {
  const Outcome outcome = RunLine({"recognise", "(abc) 12. de, fg\n(abc) 12. de, fg", "--size-mm",
                                   "6", "--seed", "37", "--json"});
  EXPECT_TRUE(outcome.Json()["ended"]);
  EXPECT_EQ(outcome.Json()["signs"], 28);  // with that of numbers
}

// Where guides are ridges, or links lie as in no line to the right, it gets lost, but not for ever.
TEST_F(RecogniseCommand, SaysWhichLinesLeadItAstray) {
  const std::vector<std::vector<std::string>> astray = {
      {"--lines", "alternate", "--embossed"}, {"--lines", "vertical", "--links", "letters"}};
  for (const std::vector<std::string>& how : astray) {
    const Outcome outcome = RunLine(With({"recognise", "the moon\nrose", "--json"}, how));
    EXPECT_NE(outcome.err.find("little."), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.Json()["ended"]);
    EXPECT_LT(outcome.Json()["duration_s"], 1200);
  }
}

TEST_F(RecogniseCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(RunLine({"recognise"}).code, 2);
  EXPECT_EQ(RunLine({"recognise", "so", "--press-n", "0"}).code, 2);
  EXPECT_EQ(RunLine({"recognise", "so", "--seed", "x"}).code, 2);
  EXPECT_EQ(RunLine({"recognise", "so", "--script", "nowhere"}).code, 3);
  EXPECT_EQ(RunLine({"recognise", "so", "--picture", In("none/p.svg")}).code, 4);
  EXPECT_EQ(RunLine({"recognise", "so", "more"}).code, 2);
  // nothing on a joystick tells how high a ridge is
  const Outcome ridges = RunLine({"recognise", "so", "--embossed", "--device", "sidewinder-ff2"});
  EXPECT_EQ(ridges.code, 3);
  EXPECT_NE(ridges.err.find("measures z too"), std::string::npos) << ridges.err;
  // or where a link leaves a letter
  const Outcome links =
      RunLine({"recognise", "so", "--links", "words", "--device", "sidewinder-ff2"});
  EXPECT_EQ(links.code, 3);
  EXPECT_NE(links.err.find("linked letters"), std::string::npos) << links.err;
}

using SlowRecogniseCommand = RecogniseCommand;

TEST_F(SlowRecogniseCommand, ReadsLinkedLetters) {
  const Outcome words = RunLine({"recognise", "so we met", "--links", "letters", "--seed", "1"});
  EXPECT_EQ(words.code, 0) << words.err;
  EXPECT_NE(words.out.find("so we met"), std::string::npos) << words.out;
}

// Told from the beginning of the first line, without its links, size and turn of this page were
// off, and 46 of the 60 letters were read. Where 97 of 100 are read, less than these of 60 would be
// on one page in 300.
TEST_F(SlowRecogniseCommand, TellsALinkedPagesFrameByItsLinksAndAllOfItsFirstLine) {
  const Outcome outcome = RunLine(
      {"recognise", "jdx pecca rjzyb qrl yfdi auz zigf juxl tk mqhfhpi rj js jyqgnnt nofh izbc o",
       "--links", "letters", "--size-mm", "10", "--seed", "4", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.Json()["signs"], 60);
  EXPECT_GE(outcome.Json()["signs_right"], 54) << outcome.Json()["text"];
}

TEST_F(SlowRecogniseCommand, TellsBrailleInPrintToo) {
  const Outcome words = RunLine({"recognise", "lego", "--script", "braille", "--seed", "2"});
  ASSERT_EQ(words.code, 0) << words.err;
  EXPECT_NE(words.out.find("⠇⠑⠛⠕\nIn print, line by line:\nlego\n"), std::string::npos)
      << words.out;
}

/// A word on a button of 58 by 26 mm that gives way, its letters 4 mm from the edge and more.
TEST_F(RecogniseCommand, ReadsALabelWithinTheEdgesOfItsFace) {
  const Outcome outcome = RunLine({"recognise", "--model", SourcePath("models/panel.xml"),
                                   "--label", "down", "--seed", "2", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.Json()["text"], "down\n");
  EXPECT_EQ(outcome.Json()["ended"], true);
}

/// Words of letters of 10 mm on all faces of a box, round a cylinder, over a sphere, and on a plate
/// that slides on a spring.
constexpr const char* kLabelled = R"(<mujoco>
  <custom>
    <text name="moontrace:box" data="{text='SALT', size_mm=10, middle_mm=[0,0]}"/>
    <text name="moontrace:box:2" data="{text='RICE', size_mm=10, middle_mm=[0,0], face='bottom'}"/>
    <text name="moontrace:box:3" data="{text='TEA', size_mm=10, middle_mm=[0,0], face='front'}"/>
    <text name="moontrace:box:4" data="{text='OATS', size_mm=10, middle_mm=[0,0], face='back'}"/>
    <text name="moontrace:box:5" data="{text='NUTS', size_mm=10, middle_mm=[0,0], face='left'}"/>
    <text name="moontrace:box:6" data="{text='BEAN', size_mm=10, middle_mm=[0,0], face='right'}"/>
    <text name="moontrace:tin" data="{text='COFFEE BEANS', size_mm=10}"/>
    <text name="moontrace:ball" data="{text='PACIFIC', size_mm=10}"/>
    <text name="moontrace:key" data="{text='HEAT', size_mm=10, middle_mm=[0,0]}"/>
  </custom>
  <worldbody>
    <geom name="box" type="box" size="0.035 0.035 0.035"/>
    <geom name="tin" type="cylinder" size="0.04 0.06" pos="0.3 0 0"/>
    <geom name="ball" type="sphere" size="0.1" pos="0.6 0 0"/>
    <body pos="0.9 0 0">
      <joint type="slide" axis="0 0 1" stiffness="300" damping="8" limited="true" range="-0.01 0"/>
      <geom name="key" type="box" size="0.035 0.015 0.01" mass="0.1"/>
    </body>
  </worldbody>
</mujoco>)";

class SlowRecogniseLabels : public CliTest {
 protected:
  /// Signs, spaces and line ends that were right, and those that were there, over ten seeds that
  /// nothing was chosen by.
  struct Score {
    int right = 0, all = 0, extra = 0;
    double Share() const { return static_cast<double>(right - extra) / all; }
  };
  static void Read(const std::string& model, const std::string& label, Score& score) {
    for (int seed = 101; seed <= 110; ++seed) {
      const Outcome outcome = RunLine({"recognise", "--model", model, "--label", label, "--seed",
                                       std::to_string(seed), "--json"});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      const nlohmann::json json = outcome.Json();
      EXPECT_EQ(json["ended"], true) << model << label << seed;
      const int right = json["right"], wrong = json["wrong"], missed = json["missed"];
      const int extra = json["extra"];
      score.right += right;
      score.all += right + wrong + missed;
      score.extra += extra;
      if (wrong + missed + extra > 0) {
        std::cout << label << " seed " << seed << ": " << json["text"] << '\n';
      }
    }
  }
};

TEST_F(SlowRecogniseLabels, OnAllKindsOfFaces) {
  WriteAll(In("labelled.xml"), kLabelled);
  Score score;
  for (const char* label :
       {"box", "box:2", "box:3", "box:4", "box:5", "box:6", "tin", "ball", "key"}) {
    Read(In("labelled.xml"), label, score);
  }
  std::cout << score.right << " of " << score.all << ", " << score.extra << " extra\n";
  EXPECT_GE(score.Share(), 0.98);
}

TEST_F(SlowRecogniseLabels, OfTheSamples) {
  Score score;
  const std::pair<const char*, const char*> labels[] = {
      {"sign", "plate"},    {"mug", "mug"},       {"mug", "handle"},    {"globe", "globe"},
      {"globe", "globe:2"}, {"globe", "globe:3"}, {"globe", "globe:4"}, {"globe", "globe:5"},
      {"door", "plate"},    {"panel", "panel"},   {"panel", "up"},      {"panel", "down"},
      {"panel", "help"}};
  for (const auto& [model, label] : labels) {
    Read(SourcePath("models/" + std::string(model) + ".xml"), label, score);
  }
  std::cout << score.right << " of " << score.all << ", " << score.extra << " extra\n";
  EXPECT_GE(score.Share(), 0.98);
}

// A letter that stands alone, of a size that is not told, could be another one of another size.
TEST_F(SlowRecogniseLabels, OfTheDiceMost) {
  Score score;
  for (const char* label : {"dice:1", "dice:2", "dice:3", "dice:4", "dice:5", "dice:6"}) {
    Read(SourcePath("models/dice.xml"), label, score);
  }
  std::cout << score.right << " of " << score.all << ", " << score.extra << " extra\n";
  EXPECT_GE(score.Share(), 0.8);
}

}  // namespace
}  // namespace moontrace

#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/picture/cairo_writer.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class TraceCommand : public CliTest {};

nlohmann::json TraceJson(const std::vector<std::string>& more, const std::string& text = "LO") {
  const Outcome outcome = RunLine(With({"trace", text, "--json"}, more));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.Json();
}

/// Without the one value that depends on the machine.
nlohmann::json Exact(nlohmann::json json) {
  json["total"].erase("real_time_factor");
  return json;
}

TEST_F(TraceCommand, CoversTheLettersAndStaysInTheGrooves) {
  const nlohmann::json json =
      TraceJson({}, "The quick brown fox jumps over the lazy dog, 0123456789.");
  const nlohmann::json& total = json["total"];
  // The bars of the issue: coverage 0.98, mean error a tenth of the width.
  EXPECT_GE(total["coverage"], 0.98);
  EXPECT_LE(total["mean_error_mm"], 0.1 * json["width_mm"].get<double>());
  EXPECT_GE(total["rms_error_mm"], total["mean_error_mm"]);
  EXPECT_GE(total["max_error_mm"], total["rms_error_mm"]);
  EXPECT_EQ(total["faults"], 0);
  EXPECT_GT(total["duration_s"], 1.0);
  EXPECT_GT(total["real_time_factor"], 0.0);
  EXPECT_GE(total["energy_out_uj"], 0.0);
  // The hand presses with 1 N.
  EXPECT_NEAR(total["mean_force_n"], 1.0, 0.15);
  EXPECT_GE(total["peak_force_n"], total["mean_force_n"]);
}

TEST_F(TraceCommand, TellsHowTheHandWent) {
  const nlohmann::json json = TraceJson({}, "JON");
  const nlohmann::json& total = json["total"];
  // The hand's plan follows the strokes from start to end, in order; tremor may turn it round for
  // a moment at a corner.
  EXPECT_GT(total["direction"], 0.9);
  EXPECT_EQ(total["order"], 1);
  EXPECT_LE(std::abs(total["bias_mm"].get<double>()), total["mean_error_mm"]);
  EXPECT_GE(total["frechet_mm"], total["hausdorff_mm"]);
  EXPECT_GT(total["contact_share"], 0.5);
  EXPECT_LT(total["contact_share"], 1);
  EXPECT_GT(total["mean_speed_mm_s"], 5);
  EXPECT_NEAR(total["letters_per_second"].get<double>(), 3 / total["duration_s"].get<double>(),
              1e-9);
  EXPECT_LT(total["log_jerk"], -5.3220);      // no hand is smoother than minimum jerk
  EXPECT_LT(total["spectral_arc"], -1.4024);  // nor by this measure
  EXPECT_GE(total["speed_peaks"], 3);
  EXPECT_EQ(total["smoothness_rate_hz"], 100);
  EXPECT_EQ(total["smoothness_low_pass_hz"], 10);
  for (const nlohmann::json& letter : json["letters"]) EXPECT_LT(letter["log_jerk"], -5.3220);
}

TEST_F(TraceCommand, TellsTheForceBound) {
  const nlohmann::json proxy = TraceJson({}, "L")["total"];
  // Integral of |h| of the coupling, 200 e^(-100 t) cos(100 t) for 1000 N/m, 10 N s/m and 50 g, is
  // n = 1 + 2 e^(-pi/2) / (1 - e^-pi); times 2.2 N sideways, (n + 1) / 2 times 3.34 N upwards. The
  // steps of 1 ms or less, a tenth of the coupling's time constant of 10 ms, change it by less than
  // that tenth.
  const double pi = std::acos(-1.0);
  const double n = 1 + 2 * std::exp(-pi / 2) / (1 - std::exp(-pi));
  const double exact = std::hypot(n * 2.2, (n + 1) / 2 * 3.34);
  EXPECT_NEAR(proxy["force_bound_n"], exact, 0.1 * exact);
  EXPECT_LE(proxy["peak_force_n"], proxy["force_bound_n"]);
  EXPECT_NEAR(proxy["force_bound_per_m_per_s2_n"], n * 0.05, 0.1 * n * 0.05);
  EXPECT_NEAR(proxy["carried_press_n"], 0.94 * 3.34, 1e-12);
  // Direct: the cap, and friction of at most as much.
  const nlohmann::json direct =
      TraceJson({"--render", "direct", "--friction", "0.2", "--quiet"}, "L")["total"];
  EXPECT_NEAR(direct["force_bound_n"], std::hypot(2.2, 3.34) + 0.2 * 4, 1e-12);
}

// On the far side of its axis lengths run backwards: a hand that got there was flung for
// kilometres.
TEST_F(TraceCommand, AHandThatIsThroughARoundLabelStaysThere) {
  const std::string mug = SourcePath("models/mug.xml");
  const Outcome outcome =
      RunLine({"trace", "--model", mug, "--label", "handle", "--press-n", "3.5", "--json"});
  const nlohmann::json total = outcome.Json()["total"];
  EXPECT_GT(total["through"], 0);
  EXPECT_EQ(total["faults"], 0);
  EXPECT_LT(total["peak_force_n"], total["force_bound_n"]);
  EXPECT_LT(total["energy_out_uj"], 1000);
}

// A sign on a free hinge turns under the press for ever; a hand that held on would go round with
// it.
TEST_F(TraceCommand, LetsGoOfALabelThatTurnsAway) {
  const std::string sign =
      "<mujoco><custom><text name='moontrace:g' data=\"{text='OPEN', size_mm=10, face='front'}\"/>"
      "</custom><worldbody><body pos='0 0 0.3'><joint type='hinge' axis='1 0 0'/>"
      "<geom name='g' type='box' size='0.08 0.003 0.04' pos='0 0 -0.05' mass='0.1'/></body>"
      "</worldbody></mujoco>";
  WriteAll(In("sign.xml"), sign);
  const std::vector<std::string> line = {"trace", "--model", In("sign.xml")};
  const nlohmann::json total = RunLine(With(line, {"--json"})).Json()["total"];
  EXPECT_GT(total["page_gone_s"], 0);
  EXPECT_EQ(total["faults"], 0);
  // the coupling's damping at 1.5 m/s, beside what the page gives
  EXPECT_LT(total["peak_force_n"], 10 * 1.5 + 5.5);
  EXPECT_LT(total["energy_out_uj"], 1000);
  const Outcome words = RunLine(line);
  EXPECT_NE(words.out.find("went away under the hand"), std::string::npos) << words.out;
}

TEST_F(TraceCommand, ScoresEachLetterApart) {
  const nlohmann::json json = TraceJson({});
  ASSERT_EQ(json["letters"].size(), 2U);
  EXPECT_EQ(json["letters"][0]["glyph"], "l");
  EXPECT_EQ(json["letters"][1]["text"], "O");
  for (const nlohmann::json& letter : json["letters"]) {
    EXPECT_GE(letter["coverage"], 0.98);
    EXPECT_GE(letter["entries"], 1);
    EXPECT_TRUE(letter.contains("lifts"));
  }
}

// Alone and among links; the bar is that of sim/README.md. No wall keeps a hand on the middle of a
// filled half, nor on the ring beside it. Where a link reaches the ring there it has no wall at
// all.
TEST_F(TraceCommand, CoversTheFilledHalfOfAnH) {
  for (const char* seed : {"1", "2", "3"}) {
    EXPECT_GE(TraceJson({"--seed", seed}, "h")["total"]["coverage"], 0.98) << seed;
    EXPECT_GE(TraceJson({"--seed", seed, "--size-mm", "40"}, "h")["total"]["coverage"], 0.98);
    EXPECT_GE(TraceJson({"--seed", seed, "--links", "words"}, "oh hi")["total"]["coverage"], 0.95);
    EXPECT_LT(TraceJson({"--seed", seed, "--blank"}, "h")["total"]["coverage"], 0.98);
  }
}

TEST_F(TraceCommand, DoesNotScoreARunningHead) {
  const nlohmann::json json = TraceJson({"--running-head", "mine", "--page-numbers"}, "LO");
  ASSERT_EQ(json["letters"].size(), 2U);
  EXPECT_EQ(json["letters"][0]["glyph"], "l");
  EXPECT_EQ(json["letters"][1]["glyph"], "o");
  EXPECT_EQ(json["total"]["entries"], 2);
  const Outcome outcome = RunLine({"trace", "LO", "--running-head", "mine"});
  EXPECT_NE(outcome.out.find("covered, 2 letters."), std::string::npos) << outcome.out;
}

TEST_F(TraceCommand, BlankPageLosesTheHand) {
  const nlohmann::json json = TraceJson({"--blank"}, "LOON");
  const nlohmann::json& total = json["total"];
  EXPECT_TRUE(total["coverage"] < 0.98 ||
              total["mean_error_mm"] > 0.1 * json["width_mm"].get<double>());
  EXPECT_TRUE(json["blank"]);
}

TEST_F(TraceCommand, BlankPageTellsOfNoGroove) {
  const Outcome outcome = RunLine({"trace", "L", "--blank"});
  EXPECT_EQ(outcome.out.find("the groove is"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Left the groove"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("there is no groove."), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
}

// Six times the press that the paper carries: each landing goes through, and zero for an error that
// nobody measured would read as perfect.
TEST_F(TraceCommand, TellsNoErrorWhereItFollowedNothing) {
  const nlohmann::json json = TraceJson({"--press-n", "20"}, "L");
  EXPECT_GT(json["total"]["through"], 0);
  EXPECT_EQ(json["total"]["coverage"], 0);
  EXPECT_GT(json["total"]["contact_share"], 0);
  for (const char* key : {"mean_error_mm", "max_error_mm", "hausdorff_mm", "excursions"}) {
    EXPECT_TRUE(json["total"][key].is_null()) << key;
  }
  const Outcome outcome = RunLine(
      {"trace", "L", "--press-n", "20", "--picture", In("l.svg"), "--record", In("record")});
  EXPECT_NE(outcome.out.find("no stroke was followed"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Mean error"), std::string::npos) << outcome.out;
  EXPECT_NE(ReadAll(folder_ / "l.svg").find("No stroke was followed"), std::string::npos);
  ExpectTextFace(outcome.out);
  const Outcome replay = RunLine({"replay", In("record")});
  EXPECT_EQ(replay.out.find("Mean error"), std::string::npos) << replay.out;
}

TEST_F(TraceCommand, SameSeedSameNumbersOtherSeedOthers) {
  const nlohmann::json one = Exact(TraceJson({"--seed", "1"}, "L"));
  EXPECT_EQ(one, Exact(TraceJson({"--seed", "1"}, "L")));
  EXPECT_NE(one["total"], Exact(TraceJson({"--seed", "2"}, "L"))["total"]);
}

TEST_F(TraceCommand, EveryOptionChangesTheTrace) {
  const nlohmann::json plain = Exact(TraceJson({}, "L"))["total"];
  const std::vector<std::vector<std::string>> lines = {
      {"--size-mm", "16"},   {"--width-mm", "2"},  {"--depth-mm", "0.5"},  {"--rounding-mm", "0.3"},
      {"--embossed"},        {"--tilt-deg", "10"}, {"--render", "direct"}, {"--law", "paper"},
      {"--friction", "0.1"}, {"--press-n", "0.5"}, {"--speed-mm-s", "20"}, {"--blank"}};
  std::set<std::string> seen{plain.dump()};
  for (const std::vector<std::string>& more : lines) {
    const nlohmann::json total = Exact(TraceJson(more, "L"))["total"];
    EXPECT_TRUE(seen.insert(total.dump()).second) << more.front();
  }
  EXPECT_EQ(TraceJson({"--h-form", "arc"}, "H")["letters"][0]["glyph"], "h.arc");
  EXPECT_EQ(TraceJson({"--grade", "0.5"}, "AND")["letters"].size(), 3U);
  const std::string script = SourcePath("textures/scripts/moon.svg");
  EXPECT_EQ(Exact(TraceJson({"--script", script}, "L"))["total"], plain);
}

TEST_F(TraceCommand, LayoutOptionsMoveTheLetters) {
  const double plain = TraceJson({}, "I I")["total"]["duration_s"];
  EXPECT_NE(TraceJson({"--letter-gap-mm", "20"}, "I I")["total"]["duration_s"], plain);
  EXPECT_NE(TraceJson({"--word-gap-mm", "40"}, "I I")["total"]["duration_s"], plain);
  EXPECT_NE(TraceJson({"--line-pitch-mm", "60"}, "I\nI")["total"]["duration_s"],
            TraceJson({}, "I\nI")["total"]["duration_s"]);
  EXPECT_EQ(TraceJson({"--page", "a5"}, "I")["paper"]["name"], "a5");
  // Wide margins leave room for one letter a line, so the way from letter to letter is another.
  EXPECT_NE(TraceJson({"--margin-mm", "97"}, "I I")["total"]["duration_s"], plain);
}

TEST_F(TraceCommand, DirectIsDoneAsAskedAndWarnedOf) {
  const Outcome outcome = RunLine({"trace", "I", "--render", "direct", "--size-mm", "6"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("Direct rendering will buzz"), std::string::npos) << outcome.err;
  ExpectTextFace(outcome.err);
  EXPECT_TRUE(
      RunLine({"trace", "I", "--render", "direct", "--size-mm", "6", "--quiet"}).err.empty());
  EXPECT_EQ(RunLine({"trace", "I"}).err.find("buzz"), std::string::npos);
}

TEST_F(TraceCommand, TracesEveryPageAndCountsThemAll) {
  const nlohmann::json json = TraceJson(
      {"--page", "60x40", "--margin-mm", "5", "--picture", In("p.svg"), "--record", In("r")},
      "LI\nIL\nLL");
  EXPECT_EQ(json["pages"], 3);
  EXPECT_EQ(json["letters"].size(), 6U);
  EXPECT_EQ(json["letters"][5]["page"], 2);
  EXPECT_GE(json["total"]["coverage"], 0.98);
  EXPECT_EQ(json["total"]["entries"], 6);
  ExpectOnly({"p-1.svg", "p-2.svg", "p-3.svg", "r-1", "r-2", "r-3"});
  EXPECT_EQ(RunLine({"replay", In("r-2"), "--check"}).code, 0);
}

TEST_F(TraceCommand, SaysTheOutcomeFirstAndPathsAlone) {
  const Outcome outcome =
      RunLine({"trace", "LO", "--picture", In("p.svg"), "--record", In("r"), "--csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = Lines(outcome.out);
  EXPECT_EQ(lines.front().rfind("Traced: ", 0), 0U);
  EXPECT_LE(lines.front().size(), 40U);
  EXPECT_EQ(lines.back(), In("r"));
  EXPECT_NE(std::find(lines.begin(), lines.end(), In("p.svg")), lines.end());
  EXPECT_NE(outcome.out.find("\nForce bound: "), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
  const std::string svg = ReadAll(In("p.svg"));
  EXPECT_NE(svg.find("<desc>Text: LO. Covered: "), std::string::npos);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(In("r/samples.csv")));
}

TEST_F(TraceCommand, RingsMarkWhereTheTipLeft) {
  const Outcome outcome =
      RunLine({"trace", "MOON", "--blank", "--size-mm", "20", "--json", "--picture", In("p.svg")});
  const auto left = outcome.Json()["total"]["excursions"].get<std::size_t>();
  ASSERT_GT(left, 0U);  // else this seed shows nothing
  const std::string svg = ReadAll(In("p.svg"));
  std::size_t rings = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos;
       at = svg.find("<circle", at + 1)) {
    ++rings;
  }
  EXPECT_EQ(rings, left);
  EXPECT_NE(svg.find("Orange"), std::string::npos);
}

TEST_F(TraceCommand, WritesEachKindOfPicture) {
  if (!HaveCairo()) GTEST_SKIP() << "built without cairo";
  EXPECT_EQ(RunLine({"trace", "I", "--picture", In("p.png")}).code, 0);
  EXPECT_EQ(RunLine({"trace", "I", "--picture", In("p.pdf")}).code, 0);
  EXPECT_EQ(ReadAll(In("p.png")).substr(1, 3), "PNG");
  EXPECT_EQ(ReadAll(In("p.pdf")).substr(0, 4), "%PDF");
}

TEST_F(TraceCommand, TextComesFromAFileOrStandardInput) {
  WriteAll(In("text"), "IL");
  EXPECT_EQ(RunLine({"trace", "--json", "--file", In("text")}).Json()["text"], "IL");
  EXPECT_EQ(RunLine({"trace", "--json", "-"}, "LI").Json()["text"], "LI");
}

constexpr const char* kSign =
    "<mujoco><custom><text name='moontrace:sign' data=\"{LABEL}\"/></custom>"
    "<worldbody><geom name='sign' type='plane' size='0.2 0.2 0.01' pos='0.1 0.2 0.3'/>"
    "</worldbody></mujoco>";

std::string Model(const std::string& label) {
  std::string xml = kSign;
  return xml.replace(xml.find("{LABEL}"), 7, "{" + label + "}");
}

TEST_F(TraceCommand, ModelsLabelGivesTextAndLettersAndTheCommandLineOverrides) {
  WriteAll(In("sign.xml"), Model("text='LI', size_mm=20, at_mm=[-100,-100]"));
  const Outcome outcome = RunLine({"trace", "--json", "--model", In("sign.xml")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.Json();
  EXPECT_EQ(json["text"], "LI");
  EXPECT_NEAR(json["size_mm"], 20.0, 1e-9);
  EXPECT_GE(json["total"]["coverage"], 0.98);
  const nlohmann::json over = TraceJson({"--model", In("sign.xml"), "--size-mm", "14"}, "O");
  EXPECT_EQ(over["text"], "O");
  EXPECT_NEAR(over["size_mm"], 14.0, 1e-9);
}

TEST_F(TraceCommand, TextIsWrappedToTheGeomThatCarriesIt) {
  // 0.2 m from the label's corner to the far edge, 1 mm margins: one letter of 100 mm a line
  WriteAll(In("sign.xml"), Model("at_mm=[0,0]"));
  const nlohmann::json json = TraceJson({"--model", In("sign.xml"), "--size-mm", "100"}, "II LL");
  EXPECT_NEAR(json["paper"]["width_mm"], 200, 1e-9);
  EXPECT_NEAR(json["paper"]["height_mm"], 200, 1e-9);
  EXPECT_EQ(json["pages"], 3);  // of one line each: II, L, L
  const Outcome large = RunLine({"trace", "WWW", "--model", In("sign.xml"), "--size-mm", "300"});
  EXPECT_EQ(large.code, 3);
  EXPECT_NE(large.err.find("198 mm"), std::string::npos) << large.err;
}

TEST_F(TraceCommand, ALabelBesideItsGeomIsRefused) {
  WriteAll(In("sign.xml"), Model("text='I', at_mm=[9000,0]"));
  const Outcome outcome = RunLine({"trace", "--model", In("sign.xml")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("at_mm lies outside the geom"), std::string::npos) << outcome.err;
}

TEST_F(TraceCommand, LooksAtAllFoldersBeforeTheFirstPage) {
  std::filesystem::create_directory(In("n-2"));
  WriteAll(In("n-2/x"), "");
  const Outcome outcome = RunLine(
      {"trace", "the moon is bright tonight and still", "--page", "80x60", "--record", In("n")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err.rfind(In("n-2") + ": exists and is not an empty folder", 0), 0U)
      << outcome.err;
  ExpectOnly({"n-2"});
}

TEST_F(TraceCommand, PutsNoFramesAmongOtherFiles) {
  std::filesystem::create_directory(In("r"));
  WriteAll(In("r/trial.json"), "{}");
  const Outcome outcome = RunLine({"trace", "I", "--frames", In("r")});
  if (outcome.code == 4) GTEST_SKIP() << outcome.err;  // built without a view
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find(In("r") + ": is not empty"), std::string::npos) << outcome.err;
}

TEST_F(TraceCommand, PictureShowsRulesAndMarginAndNamesThePaper) {
  const std::vector<std::string> line = {"trace",  "LO", "--size-mm", "8",
                                         "--page", "a5", "--picture"};
  ASSERT_EQ(RunLine(With(line, {In("plain.svg")})).code, 0);
  ASSERT_EQ(
      RunLine(With(line, {In("sheet.svg"), "--rules", "--raised-margin", "--texture", "sine"}))
          .code,
      0);
  const std::string green = "#009e73";  // the colour of rules on a page's own picture
  ASSERT_EQ(RunLine({"page", "LO", "--size-mm", "8", "--rules", "--picture", In("page.svg")}).code,
            0);
  ASSERT_NE(ReadAll(In("page.svg")).find(green), std::string::npos);
  EXPECT_EQ(ReadAll(In("plain.svg")).find(green), std::string::npos);
  const std::string sheet = ReadAll(In("sheet.svg"));
  EXPECT_NE(sheet.find(green), std::string::npos);
  EXPECT_NE(sheet.find("Raised margin"), std::string::npos);
  EXPECT_NE(sheet.find("left out"), std::string::npos);
}

TEST_F(TraceCommand, StopsAtOnceAndLeavesNothing) {
  const std::atomic<bool> stop{true};
  const Outcome outcome =
      RunLine({"trace", "MOON", "--record", In("r"), "--picture", In("p.svg")}, "", &stop);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err.rfind("Stopped", 0), 0U);
  ExpectOnly({});
}

// Readings in steps, late forces, a softer coupling: the page is still felt, and told by whom.
TEST_F(TraceCommand, PutsTheHandOnADevice) {
  const nlohmann::json json = TraceJson({"--device-profile", "woodenhaptics"});
  const nlohmann::json& total = json["total"];
  EXPECT_EQ(json["device_profile"], "woodenhaptics");
  EXPECT_GE(total["coverage"], 0.98);
  EXPECT_LE(total["force_bound_n"], 3.8 + 1e-9);  // the profile's peak
  EXPECT_LT(total["energy_out_uj"], 1000);
  EXPECT_TRUE(total.contains("energy_out_by_readings_uj"));
  EXPECT_FALSE(TraceJson({})["total"].contains("energy_out_by_readings_uj"));
  const nlohmann::json again = TraceJson({"--device-profile", "woodenhaptics"});
  EXPECT_EQ(Exact(json), Exact(again));
  EXPECT_EQ(
      Exact(json),
      Exact(TraceJson({"--device-profile", SourcePath("devices/profiles/woodenhaptics.toml")})));
  const Outcome told = RunLine({"trace", "LO", "--device-profile", "woodenhaptics"});
  EXPECT_NE(told.out.find("by the hand's true way"), std::string::npos) << told.out;
}

TEST_F(TraceCommand, RefusesADeviceProfileThatDoesNotFit) {
  const Outcome unknown = RunLine({"trace", "LO", "--device-profile", "wooden"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_NE(unknown.err.find("one of generic-pid, moontrace-raw"), std::string::npos)
      << unknown.err;
  const Outcome puck = RunLine({"trace", "LO", "--device-profile", "spacemouse"});
  EXPECT_EQ(puck.code, 3);
  EXPECT_NE(puck.err.find("pushes nothing"), std::string::npos) << puck.err;
  EXPECT_EQ(RunLine({"trace", "LO", "--device-profile", "none.toml"}).code, 3);
  EXPECT_EQ(RunLine({"trace", "LO", "--device", "spacemouse", "--device-profile", "polhem"}).code,
            2);
}

}  // namespace
}  // namespace moontrace

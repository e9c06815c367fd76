#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/cli_fixture.h"

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
  // a joystick has no depth, a puck no force
  for (const char* name : {"generic-pid", "spacemouse"}) {
    const Outcome refused = RunLine({"recognise", "so", "--device", name});
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("measures and pushes x, y and z"), std::string::npos);
  }
  EXPECT_EQ(RunLine({"recognise", "so", "--device", "nowhere"}).code, 3);
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

TEST_F(RecogniseCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(RunLine({"recognise"}).code, 2);
  EXPECT_EQ(RunLine({"recognise", "so", "--press-n", "0"}).code, 2);
  EXPECT_EQ(RunLine({"recognise", "so", "--seed", "x"}).code, 2);
  EXPECT_EQ(RunLine({"recognise", "so", "--script", "nowhere"}).code, 3);
  EXPECT_EQ(RunLine({"recognise", "so", "--picture", In("none/p.svg")}).code, 4);
  EXPECT_EQ(RunLine({"recognise", "so", "more"}).code, 2);
  const Outcome ridges = RunLine({"recognise", "so", "--embossed"});
  EXPECT_EQ(ridges.code, 2);
  EXPECT_NE(ridges.err.find("leave --embossed out"), std::string::npos);
  const Outcome links = RunLine({"recognise", "so", "--links", "words"});
  EXPECT_EQ(links.code, 2);
  EXPECT_NE(links.err.find("leave --links out"), std::string::npos) << links.err;
}

}  // namespace
}  // namespace moontrace

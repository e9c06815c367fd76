// Groove links from the command line to page, picture and record.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "sim/setup/link_options.h"
#include "tests/sim/cli_fixture.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/groove_links.h"

namespace moontrace {
namespace {

class LinkOptionsTest : public CliTest {};

TEST_F(LinkOptionsTest, ArePutOnThePageAndTold) {
  const nlohmann::json plain = RunLine({"page", "la la", "--json"}).Json();
  EXPECT_EQ(plain["links"]["reach"], "none");
  const nlohmann::json json = RunLine({"page", "la la", "--links", "words", "--link-depth", "0.5",
                                       "--link-gap-mm", "0.3", "--json"})
                                  .Json();
  EXPECT_EQ(json["links"]["reach"], "words");
  EXPECT_EQ(json["links"]["count"], 3);
  EXPECT_EQ(json["links"]["missing"], 0);
  EXPECT_DOUBLE_EQ(json["links"]["depth"], 0.5);
  EXPECT_DOUBLE_EQ(json["links"]["gap_mm"], 0.3);
  const Outcome words = RunLine({"page", "la la", "--links", "letters"});
  EXPECT_NE(words.out.find("Links: 2, 0.6 of the letters' depth."), std::string::npos) << words.out;
  ExpectTextFace(words.out);
  const Outcome crowded = RunLine({"page", "la", "--links", "words", "--link-gap-mm", "12"});
  EXPECT_NE(crowded.out.find("no room for 1."), std::string::npos) << crowded.out;
}

// Where lines stand closer there is less room to lead links round each other.
TEST_F(LinkOptionsTest, ThatCrossAreCountedAndTold) {
  const std::vector<std::string> line = {
      "page", "gugmgy through", "--links", "words", "--line-pitch-mm", "18", "--page", "300x100"};
  const nlohmann::json json = RunLine(With(line, {"--json", "--picture", In("p.svg")})).Json();
  const int crossings = json["links"]["crossings"];
  EXPECT_GT(crossings, 1);
  const std::string said = std::to_string(crossings) + " pairs cross";
  const Outcome words = RunLine(line);
  EXPECT_NE(words.out.find(said + "."), std::string::npos) << words.out;
  ExpectTextFace(words.out);
  EXPECT_NE(ReadAll(In("p.svg")).find(said), std::string::npos);
  const nlohmann::json apart =
      RunLine({"page", "bright moon", "--links", "words", "--json"}).Json();
  EXPECT_EQ(apart["links"]["crossings"], 0);
}

TEST_F(LinkOptionsTest, AreFoundOnceForAllPages) {
  std::ostringstream out, err;
  std::istringstream in;
  Console console(in, out, err);
  Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  style.links.reach = LinkReach::kWords;
  Typeset set = SetText("moon\nmoon\nmoon", script, style, {"custom", 0.2, 0.05, 0.01});
  ASSERT_GT(set.pages.size(), 1u);
  KeepLinks(set, script, console);
  for (const TextPage& page : set.pages) {
    ASSERT_NE(page.links, nullptr);
    EXPECT_EQ(LinksOf(page, script, style), page.links);
  }
}

TEST_F(LinkOptionsTest, AreRefusedWhereTheyCannotBe) {
  EXPECT_EQ(RunLine({"page", "a", "--links", "lines"}).code, 2);
  EXPECT_GE(RunLine({"page", "a", "--links", "words", "--link-depth", "0"}).code, 2);
  EXPECT_GE(RunLine({"page", "a", "--links", "words", "--link-gap-mm", "-1"}).code, 2);
  EXPECT_EQ(RunLine({"page", "a", "--links", "words", "--link-gap-mm", "900"}).code, 3);
  EXPECT_EQ(RunLine({"page", "a", "--link-depth", "0.5"}).code, 2);
  EXPECT_EQ(RunLine({"page", "a", "--link-gap-mm", "1"}).code, 2);
}

TEST_F(LinkOptionsTest, ARecordReplaysToTheBit) {
  const Outcome trace = RunLine(
      {"trace", "lo", "--links", "words", "--link-depth", "0.45", "--record", In("r"), "--json"});
  ASSERT_EQ(trace.code, 0) << trace.err;
  EXPECT_EQ(trace.Json()["total"]["lifts_within_lines"], 0);
  const Outcome replay = RunLine({"replay", In("r"), "--check"});
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
}

TEST_F(LinkOptionsTest, LiftsAreTold) {
  const Outcome trace = RunLine({"trace", "la", "--links", "words"});
  EXPECT_NE(trace.out.find("Lifted within lines: 0 times, 1 line."), std::string::npos)
      << trace.out;
  ExpectTextFace(trace.out);
}

TEST_F(LinkOptionsTest, LeftOnesAreToldCountedAndRinged) {
  const std::vector<std::string> line = {"trace",  "moon moon", "--links", "words",
                                         "--page", "200x50",    "--seed",  "2"};
  const nlohmann::json json = RunLine(With(line, {"--json", "--picture", In("p.svg")})).Json();
  const int left = json["total"]["links_left"];
  const std::string svg = ReadAll(In("p.svg"));
  std::size_t rings = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos;
       at = svg.find("<circle", at + 1)) {
    ++rings;
  }
  EXPECT_EQ(rings, static_cast<std::size_t>(left) + json["total"]["excursions"].get<std::size_t>());
  EXPECT_NE(svg.find("Pale blue: links"), std::string::npos);
  const Outcome words = RunLine(line);
  const std::string said = left == 0 ? "none" : std::to_string(left);
  EXPECT_NE(words.out.find("Links: 7, " + said + " of them left"), std::string::npos) << words.out;
  EXPECT_TRUE(RunLine({"trace", "I", "--json"}).Json()["total"]["links_left"].is_null());
}

TEST_F(LinkOptionsTest, AreDrawnAndSaidBesideThePicture) {
  const std::string file = In("p.svg");
  ASSERT_EQ(RunLine({"page", "la", "--links", "words", "--picture", file}).code, 0);
  const std::string linked = ReadAll(file);
  EXPECT_NE(linked.find("1 link, drawn thin and light."), std::string::npos);
}

}  // namespace
}  // namespace moontrace

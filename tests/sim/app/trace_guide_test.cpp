// trace --guide MODE --help-level N.

#include <gtest/gtest.h>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class GuideOptionsTest : public CliTest {};

nlohmann::json TotalOf(const std::vector<std::string>& more) {
  const Outcome outcome = RunLine(With({"trace", "LO", "--json"}, more));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.Json();
}

TEST_F(GuideOptionsTest, TheHandIsPushedAndToldSo) {
  const nlohmann::json guided = TotalOf({"--guide", "rail", "--help-level", "10"});
  EXPECT_EQ(guided["guide"], "rail");
  EXPECT_EQ(guided["help_level"], 10);
  EXPECT_GT(guided["total"]["mean_guidance_n"], 0.0);
  const nlohmann::json alone = TotalOf({});
  EXPECT_EQ(alone["guide"], "off");
  EXPECT_EQ(alone["total"]["mean_guidance_n"], 0.0);
  EXPECT_EQ(alone["total"]["guidance_work_mj"], 0.0);
  EXPECT_LT(guided["total"]["mean_error_mm"], alone["total"]["mean_error_mm"]);
}

TEST_F(GuideOptionsTest, WordsTellModeHelpAndForce) {
  const Outcome outcome = RunLine({"trace", "LO", "--guide", "bead", "--help-level", "2.5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nPush: bead, help 2.5; "), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
  EXPECT_EQ(RunLine({"trace", "LO"}).out.find("Push"), std::string::npos);
}

TEST_F(GuideOptionsTest, HelpIsSixWhereNoneIsNamed) {
  EXPECT_EQ(TotalOf({"--guide", "attract"})["help_level"], 6);
}

TEST_F(GuideOptionsTest, RefusesWhatIsNone) {
  const std::vector<std::vector<std::string>> wrong = {{"--guide", "pull"},
                                                       {"--guide", "rail", "--help-level", "11"},
                                                       {"--guide", "rail", "--help-level", "-1"},
                                                       {"--guide", "rail", "--help-level", "much"},
                                                       {"--help-level", "5"},
                                                       {"--guide", "rail", "--device", "mouse"}};
  for (const std::vector<std::string>& more : wrong) {
    const Outcome outcome = RunLine(With({"trace", "LO"}, more));
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    ExpectTextFace(outcome.err);
  }
}

TEST_F(GuideOptionsTest, TheHelpPageNamesThem) {
  const std::string help = RunLine({"trace", "--help-all"}).out;
  EXPECT_NE(help.find("--guide MODE"), std::string::npos);
  EXPECT_NE(help.find("--help-level NUMBER"), std::string::npos);
}

TEST_F(GuideOptionsTest, ReplayOfAPushedTraceIsBitEqual) {
  for (const char* mode : {"attract", "rail", "bead", "amplify", "corridor"}) {
    const Outcome traced = RunLine({"trace", "IT", "--guide", mode, "--help-level", "7.3",
                                    "--tilt-deg", "10", "--record", In("r")});
    ASSERT_EQ(traced.code, 0) << traced.err;
    const Outcome outcome = RunLine({"replay", In("r"), "--check"});
    EXPECT_EQ(outcome.code, 0) << mode << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.rfind("Replay is bit-equal over ", 0), 0U);
    std::filesystem::remove_all(In("r"));
  }
}

TEST_F(GuideOptionsTest, APushOnATiltedPageActsInItsPlane) {
  // The same trace, page and hand turned together, to what rounding leaves after some seconds.
  const nlohmann::json level = TotalOf({"--guide", "rail"})["total"];
  const nlohmann::json tilted = TotalOf({"--guide", "rail", "--tilt-deg", "20"})["total"];
  EXPECT_NEAR(level["mean_guidance_n"], tilted["mean_guidance_n"],
              1e-4 * level["mean_guidance_n"].get<double>());
  EXPECT_NEAR(level["mean_error_mm"], tilted["mean_error_mm"], 1e-4);
}

}  // namespace
}  // namespace moontrace

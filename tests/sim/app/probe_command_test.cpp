#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

// The letter I is one upright line at x = 0 from 0 to 1 em. With w = 2, D = 1, r = 0.4 (w/5) the
// flank's slope is s = D / (w/2 - r) = 1 / 0.6; the expected values are the design's closed forms.
const std::vector<std::string> kLetter = {"I",          "--json", "--width-mm",    "2",
                                          "--depth-mm", "1",      "--rounding-mm", "0.4"};

nlohmann::json Probe(const std::string& x, const std::string& y, const std::string& z,
                     const std::vector<std::string>& more = {}) {
  const Outcome outcome = RunLine(With(With({"probe", x, y, z}, kLetter), more));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.Json();
}

constexpr double kSlope = 1 / 0.6;

TEST(ProbeCommand, FindsTheGroovesFloor) {
  const nlohmann::json at = Probe("0", "6", "-1.1");
  EXPECT_NEAR(at["displacement_mm"], -1.0, 1e-12);
  EXPECT_NEAR(at["depth_mm"], 0.1, 1e-9);
  EXPECT_NEAR(at["gradient"][0], 0.0, 1e-9);
  EXPECT_NEAR(at["normal"][2], 1.0, 1e-12);
  // k = 1000 N/m times 0.1 mm, straight up.
  EXPECT_NEAR(at["force_n"][0], 0.0, 1e-9);
  EXPECT_NEAR(at["force_n"][2], 0.1, 1e-9);
}

TEST(ProbeCommand, FindsTheFlank) {
  // At 0.5 mm: h = -D + s r/2 + s (d - r).
  const double height = -1 + kSlope * 0.2 + kSlope * 0.1;
  const nlohmann::json at = Probe("0.5", "6", "-0.6");
  EXPECT_NEAR(at["displacement_mm"], height, 1e-9);
  EXPECT_NEAR(at["gradient"][0], kSlope, 1e-9);
  EXPECT_NEAR(at["gradient"][1], 0.0, 1e-12);
  EXPECT_NEAR(at["normal"][0], -kSlope / std::hypot(1, kSlope), 1e-9);
  const double depth_mm = height + 0.6;
  EXPECT_NEAR(at["depth_mm"], depth_mm, 1e-9);
  // The potential law: k x depth x (-h', 1).
  EXPECT_NEAR(at["force_n"][0], -kSlope * depth_mm, 1e-9);
  EXPECT_NEAR(at["force_n"][2], depth_mm, 1e-9);
  // The paper's law: k x depth along the unit normal.
  const nlohmann::json paper = Probe("0.5", "6", "-0.6", {"--law", "paper"});
  EXPECT_NEAR(paper["force_n"][2], depth_mm / std::hypot(1, kSlope), 1e-9);
}

TEST(ProbeCommand, FeelsNothingAboveThePaper) {
  const nlohmann::json at = Probe("0", "6", "0.5");
  EXPECT_EQ(at["force_n"], nlohmann::json({0.0, 0.0, 0.0}));
  EXPECT_LT(at["depth_mm"], 0.0);
}

TEST(ProbeCommand, NegativePlacesAreNumbersNotOptions) {
  EXPECT_NEAR(Probe("-3", "-2", "-0.1")["displacement_mm"], 0.0, 0.0);
  EXPECT_NEAR(Probe("-0.5", "6", "0")["gradient"][0], -kSlope, 1e-9);
}

TEST(ProbeCommand, SaysTheOutcomeFirstInWords) {
  const Outcome outcome = RunLine({"probe", "0", "6", "-0.8", "I"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind("Contact: ", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("\nforce_n: 0, 0, "), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
  EXPECT_EQ(RunLine({"probe", "0", "6", "1", "I"}).out.rfind("No contact: ", 0), 0U);
}

TEST(ProbeCommand, SaysWhatIsMissingOnStderrAndQuietSilencesIt) {
  const std::vector<std::string> line = {"probe", "0", "0", "0", "I\xE2\x98\x83"};
  EXPECT_NE(RunLine(line).err.find("Left out"), std::string::npos);
  EXPECT_TRUE(RunLine(With(line, {"--quiet"})).err.empty());
}

TEST(ProbeCommand, WantsAPointAndAText) {
  EXPECT_EQ(RunLine({"probe", "1", "2"}).code, 2);
  EXPECT_EQ(RunLine({"probe", "1", "2", "3"}).code, 2);
  EXPECT_EQ(RunLine({"probe", "x", "2", "3", "A"}).code, 2);
  EXPECT_EQ(RunLine({"probe", "nan", "2", "3", "A"}).code, 2);
}

}  // namespace
}  // namespace moontrace

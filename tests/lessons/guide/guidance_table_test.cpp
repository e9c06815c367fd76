#include "lessons/guide/guidance_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "textures/base/error.h"
#include "textures/base/resources.h"

namespace moontrace {
namespace {

constexpr GuidanceMode kPushing[] = {GuidanceMode::kAttract, GuidanceMode::kRail,
                                     GuidanceMode::kBead, GuidanceMode::kAmplify,
                                     GuidanceMode::kCorridor};

std::string ShippedText() {
  std::ifstream file(ResourcePath("lessons/guidance.toml"));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The line that a table with `was` written as `is` gives.
std::string ErrorWith(const std::string& was, const std::string& is) {
  std::string text = ShippedText();
  const std::size_t at = text.find(was);
  if (at == std::string::npos) return "not in the file: " + was;
  text.replace(at, was.size(), is);
  try {
    GuidanceTable::Parse(text, "t.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(GuidanceTable, MoreHelpIsNeverLessPush) {
  const GuidanceTable table = GuidanceTable::Shipped();
  for (const GuidanceMode mode : kPushing) {
    GuidanceGains last = table.GainsOf(mode, 0);
    EXPECT_EQ(last.stiffness, 0);
    EXPECT_EQ(last.damping, 0);
    EXPECT_EQ(last.cue_amplitude, 0);
    for (int tenth = 1; tenth <= 100; ++tenth) {
      const GuidanceGains gains = table.GainsOf(mode, 0.1 * tenth);
      EXPECT_GE(gains.stiffness, last.stiffness);
      EXPECT_GE(gains.damping, last.damping);
      EXPECT_GE(gains.cue_amplitude, last.cue_amplitude);
      EXPECT_LE(gains.dead_zone_widths, last.dead_zone_widths);
      EXPECT_LE(gains.stiffness, 400);
      EXPECT_LE(gains.cap, 1.5);
      EXPECT_GE(gains.stiffness, tenth >= 10 && mode != GuidanceMode::kCorridor ? 20 : 0);
      last = gains;
    }
    EXPECT_GT(last.stiffness + last.cue_amplitude, 0);
  }
}

TEST(GuidanceTable, HelpBetweenLevelsLiesEvenlyBetween) {
  const GuidanceTable table = GuidanceTable::Shipped();
  const double below = table.GainsOf(GuidanceMode::kRail, 3).stiffness;
  const double above = table.GainsOf(GuidanceMode::kRail, 4).stiffness;
  EXPECT_NEAR(table.GainsOf(GuidanceMode::kRail, 3.25).stiffness, below + 0.25 * (above - below),
              1e-12);
}

TEST(GuidanceTable, HelpOutsideItsRangeIsHeld) {
  const GuidanceTable table = GuidanceTable::Shipped();
  const double full = table.GainsOf(GuidanceMode::kRail, 10).stiffness;
  EXPECT_EQ(table.GainsOf(GuidanceMode::kRail, 1e9).stiffness, full);
  EXPECT_EQ(table.GainsOf(GuidanceMode::kRail, -1).stiffness, 0);
  EXPECT_EQ(table.GainsOf(GuidanceMode::kRail, std::nan("")).stiffness, 0);
  EXPECT_EQ(table.GainsOf(GuidanceMode::kOff, 10).stiffness, 0);
}

TEST(GuidanceTable, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(ErrorWith("[rail]\nstiffness", "[rail]\nstifness").substr(0, 7), "t.toml:");
  EXPECT_NE(ErrorWith("leash_widths", "leash_width").find("leash_widths"), std::string::npos);
  EXPECT_NE(ErrorWith("[bead]", "[bread]").find("bead"), std::string::npos);
  EXPECT_NE(ErrorWith("= [40, 60, 85", "= [40, 600, 85").find("600 is not from 20 to 400"),
            std::string::npos);
  EXPECT_NE(ErrorWith("= [40, 60, 85", "= [40, 30, 85").find("30 after 40"), std::string::npos);
  EXPECT_NE(ErrorWith("= [40, 60, 85", "= [60, 85").find("9 numbers"), std::string::npos);
  EXPECT_NE(ErrorWith("cap_n = 1.5", "cap_n = 3.1").find("is not from 0.05 to 3"),
            std::string::npos);
  EXPECT_NE(ErrorWith("forgetting = 0.8", "forgetting = 1.0").find("forgetting"),
            std::string::npos);
  EXPECT_NE(ErrorWith("gate_good = 2", "gate_good = 0").find("gate_good"), std::string::npos);
  EXPECT_NE(ErrorWith("0.70, 0.65, 0.60", "0.70, 0.75, 0.60").find("only shrink"),
            std::string::npos);
}

TEST(GuidanceTable, WithoutAFilePushesNothing) {
  EXPECT_EQ(GuidanceTable().GainsOf(GuidanceMode::kRail, 10).stiffness, 0);
}

TEST(FadeRuleNamed, GivesTheShippedParametersOfEachRule) {
  FadeSettings settings;
  settings.rule = "as-needed";
  const FadeRule rule = FadeRuleNamed(settings);
  EXPECT_EQ(rule.kind, FadeRule::Kind::kAsNeeded);
  EXPECT_LT(rule.forgetting, 1);
  EXPECT_GT(rule.dead_zone, 0);
  for (const char* name : {"manual", "linear", "gate"}) {
    settings.rule = name;
    EXPECT_NO_THROW(FadeRuleNamed(settings));
  }
  settings.rule = "slowly";
  EXPECT_THROW(FadeRuleNamed(settings), InputError);
}

}  // namespace
}  // namespace moontrace

#include "devices/hand/hand.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::string kGood =
    "mass_kg = 0.2\n"
    "stiffness_n_per_m = 300\n"
    "damping_ns_per_m = 4.0\n"
    "press_n = 1.5\n"
    "light_press_n = 0.3\n"
    "tremor_rms_mm = 0.25\n"
    "tremor_low_hz = 7.0\n"
    "tremor_high_hz = 11.0\n"
    "drift_share = 0.05\n"
    "drift_wavelength_mm = 120\n"
    "late_ticks = 2\n";

std::string Replaced(std::string text, const std::string& was, const std::string& now) {
  return text.replace(text.find(was), was.size(), now);
}

std::string MessageFor(const std::string& text) {
  try {
    ParseHand(text, "some.toml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseHand, ReadsEveryValueInSiUnits) {
  const HandModel hand = ParseHand(kGood, "some.toml");
  EXPECT_DOUBLE_EQ(hand.mass, 0.2);
  EXPECT_DOUBLE_EQ(hand.stiffness, 300);
  EXPECT_DOUBLE_EQ(hand.damping, 4);
  EXPECT_DOUBLE_EQ(hand.press, 1.5);
  EXPECT_DOUBLE_EQ(hand.light_press, 0.3);
  EXPECT_DOUBLE_EQ(hand.tremor_rms, 0.25e-3);
  EXPECT_DOUBLE_EQ(hand.tremor_low, 7);
  EXPECT_DOUBLE_EQ(hand.tremor_high, 11);
  EXPECT_DOUBLE_EQ(hand.drift, 0.05);
  EXPECT_DOUBLE_EQ(hand.drift_wavelength, 0.12);
  EXPECT_EQ(hand.late_ticks, 2);
}

TEST(ParseHand, SaysWhatWhereAndHowInOneLine) {
  EXPECT_EQ(MessageFor(Replaced(kGood, "= 0.2\n", "= -1\n")),
            "some.toml:1:11: mass_kg is not a number from 0.001 to 10: give one");
  EXPECT_EQ(MessageFor(Replaced(kGood, "= 300\n", "= nan\n")),
            "some.toml:2:21: stiffness_n_per_m is not a number from 1 to 100000: give one");
  EXPECT_EQ(MessageFor(Replaced(kGood, "= 1.5\n", "= 'hard'\n")),
            "some.toml:4:11: press_n is not a number from 0.01 to 20: give one");
  EXPECT_EQ(MessageFor(Replaced(kGood, "late_ticks = 2", "late_ticks = 1.5")),
            "some.toml:11:14: late_ticks is not a whole number from 0 to 100: give one");
  EXPECT_EQ(MessageFor(Replaced(kGood, "press_n = 1.5\n", "")),
            "some.toml: press_n is missing: add it with a number");
  EXPECT_EQ(MessageFor(Replaced(kGood, "= 7.0", "= 12.0")),
            "some.toml:7:17: tremor_low_hz is not below tremor_high_hz: lower it");
}

TEST(ParseHand, NamesAnUnknownKeyAndTheKnownOnes) {
  const std::string message = MessageFor(kGood + "colour = 1\n");
  EXPECT_EQ(message.find("some.toml:12:1: unknown key 'colour': the keys are "), 0u) << message;
  EXPECT_NE(message.find("mass_kg"), std::string::npos);
}

TEST(ParseHand, ReportsBrokenTomlAtItsPlace) {
  const std::string message = MessageFor("mass_kg = 0.1\npress_n = = 2\n");
  EXPECT_EQ(message.find("some.toml:2:"), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(LoadHand, NamesAFileThatCannotBeRead) {
  const std::string path = testing::TempDir() + "no-such-hand.toml";
  try {
    LoadHand(path);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), path + ": cannot be read: name a hand's TOML file");
  }
  EXPECT_THROW(LoadHand(testing::TempDir()), std::runtime_error);  // a folder
}

// The figures of the design (section 6), which are the same for every letter size.
TEST(LoadHand, ShipsTheHandOfTheDesign) {
  const HandModel hand = LoadHand(SourcePath("devices/hand.toml"));
  EXPECT_DOUBLE_EQ(hand.mass, 0.1);
  EXPECT_DOUBLE_EQ(hand.stiffness, 200);
  EXPECT_DOUBLE_EQ(hand.damping, 3);
  EXPECT_DOUBLE_EQ(hand.press, 1);
  EXPECT_DOUBLE_EQ(hand.tremor_rms, 1e-4);
  EXPECT_DOUBLE_EQ(hand.tremor_low, 8);
  EXPECT_DOUBLE_EQ(hand.tremor_high, 12);
  EXPECT_DOUBLE_EQ(hand.drift, 0.06);
  EXPECT_EQ(hand.late_ticks, 1);
  EXPECT_GE(hand.light_press, 0.1);  // a light press: 0.1-0.3 N (design, section 3)
  EXPECT_LE(hand.light_press, 0.3);
}

}  // namespace
}  // namespace moontrace

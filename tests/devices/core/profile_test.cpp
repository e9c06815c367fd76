#include "devices/core/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "devices/core/device_error.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::string kGood =
    "title = \"A stick\"\n"
    "kind = \"pid\"\n"
    "measures = \"xy\"\n"
    "pushes = \"x\"\n"
    "buttons = 3\n"
    "workspace_mm = [100, 80, 60]\n"
    "peak_force_n = 4\n"
    "continuous_force_n = 1.5\n"
    "heat_time_s = 20\n"
    "stiffness_n_per_m = 700\n"
    "damping_ns_per_m = 2\n"
    "silence_ms = 120\n"
    "dead_man_ms = 50\n"
    "rate_hz = 500\n"
    "delay_ms = 2\n"
    "position_step_um = 20\n"
    "coulomb_friction_n = 0.01\n"
    "[[id]]\n"
    "vendor = 0x1209\n"
    "product = 0xFFB0\n"
    "own = true\n"
    "[stick]\n"
    "right_axis = \"rz\"\n"
    "away_axis = \"-y\"\n"
    "full_force_n = 9\n"
    "press = \"button\"\n"
    "press_button = 2\n";

std::string Replaced(std::string text, const std::string& was, const std::string& now) {
  return text.replace(text.find(was), was.size(), now);
}

std::string MessageFor(const std::string& text) {
  try {
    ParseProfile(text, "folder/some.toml");
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseProfile, ReadsEveryValueInSiUnits) {
  const DeviceProfile profile = ParseProfile(kGood, "folder/some.toml");
  EXPECT_EQ(profile.name, "some");
  EXPECT_EQ(profile.title, "A stick");
  EXPECT_EQ(profile.kind, DeviceKind::kPid);
  EXPECT_EQ(profile.limits.measures, glm::bvec3(true, true, false));
  EXPECT_EQ(profile.limits.pushes, glm::bvec3(true, false, false));
  EXPECT_EQ(profile.limits.buttons, 3);
  // Half of 100, 80 and 60 mm: edges around the middle.
  EXPECT_NEAR(profile.limits.workspace_D.x, 0.05, 1e-15);
  EXPECT_NEAR(profile.limits.workspace_D.y, 0.04, 1e-15);
  EXPECT_NEAR(profile.limits.workspace_D.z, 0.03, 1e-15);
  EXPECT_DOUBLE_EQ(profile.limits.peak_force, 4);
  EXPECT_DOUBLE_EQ(profile.limits.continuous_force, 1.5);
  EXPECT_DOUBLE_EQ(profile.limits.heat_time, 20);
  EXPECT_DOUBLE_EQ(profile.limits.silence, 0.12);
  EXPECT_DOUBLE_EQ(profile.limits.dead_man, 0.05);
  EXPECT_DOUBLE_EQ(profile.rate, 500);
  EXPECT_DOUBLE_EQ(profile.delay, 0.002);
  EXPECT_NEAR(profile.position_step, 20e-6, 1e-18);
  ASSERT_EQ(profile.ids.size(), 1u);
  EXPECT_EQ(profile.ids[0].vendor, 0x1209);
  EXPECT_EQ(profile.ids[0].product, 0xFFB0);
  EXPECT_TRUE(profile.ids[0].own);
  EXPECT_EQ(profile.stick.right.usage, 0x35);  // Rz in the USB HID Usage Tables
  EXPECT_EQ(profile.stick.right.sign, 1);
  EXPECT_EQ(profile.stick.away.usage, 0x31);
  EXPECT_EQ(profile.stick.away.sign, -1);
  EXPECT_DOUBLE_EQ(profile.stick.full_force, 9);
  EXPECT_EQ(profile.stick.press, StickMap::Press::kButton);
  EXPECT_EQ(profile.stick.press_button, 2);
}

TEST(ParseProfile, NamesTheNearestKeyAndItsPlace) {
  EXPECT_EQ(MessageFor(Replaced(kGood, "peak_force_n", "peak_froce_n")),
            "folder/some.toml:7:1: unknown key 'peak_froce_n': did you mean peak_force_n?");
}

TEST(ParseProfile, TellsWhereAValueIsWrong) {
  EXPECT_EQ(MessageFor(Replaced(kGood, "rate_hz = 500", "rate_hz = 0")),
            "folder/some.toml:14:11: rate_hz is not a number from 10 to 10000: give one");
  EXPECT_EQ(MessageFor(Replaced(kGood, "rate_hz = 500", "rate_hz = nan")),
            "folder/some.toml:14:11: rate_hz is not a number from 10 to 10000: give one");
  EXPECT_EQ(MessageFor(Replaced(kGood, "\"pid\"", "\"pit\"")),
            "folder/some.toml:2:8: kind is none of pid, wooden-haptics, raw-hid, puck, plugin: "
            "give one");
  EXPECT_NE(MessageFor(Replaced(kGood, "peak_force_n = 4", "peak_force_n =")).find(":7:"),
            std::string::npos);
}

TEST(ParseProfile, TakesEachAxisOnceAndBothAlongThePage) {
  const auto message = [](const std::string& axes) {
    return MessageFor(Replaced(kGood, "\"xy\"", "\"" + axes + "\""));
  };
  EXPECT_EQ(message("zyx"), "no error");
  EXPECT_EQ(message("xx"), "folder/some.toml:3:12: measures has x twice: write it once");
  for (const char* axes : {"", "z", "x", "yz"}) {
    EXPECT_EQ(message(axes).find("folder/some.toml:3:12: measures lacks x or y: "), 0U) << axes;
  }
  EXPECT_EQ(MessageFor(Replaced(kGood, "pushes = \"x\"", "pushes = \"xzz\"")),
            "folder/some.toml:4:10: pushes has z twice: write it once");
}

TEST(ParseProfile, RefusesForcesThatContradict) {
  EXPECT_NE(MessageFor(Replaced(kGood, "continuous_force_n = 1.5", "continuous_force_n = 5"))
                .find("above peak_force_n"),
            std::string::npos);
  EXPECT_NE(MessageFor(Replaced(kGood, "heat_time_s = 20\n", "")).find("belong together"),
            std::string::npos);
  EXPECT_NE(MessageFor(Replaced(kGood, "full_force_n = 9", "full_force_n = 3")).find("lower it"),
            std::string::npos);
  EXPECT_NE(MessageFor(Replaced(Replaced(kGood, "peak_force_n = 4", "peak_force_n = 0"),
                                "continuous_force_n = 1.5\nheat_time_s = 20\n", ""))
                .find("give its force"),
            std::string::npos);
}

TEST(ParseProfile, RefusesKeysOfAnotherKind) {
  EXPECT_NE(MessageFor(kGood + "[puck]\nfull_scale_counts = 350\n").find("unknown key 'puck'"),
            std::string::npos);
}

TEST(StableStiffness, IsTheLeastOfTheKnownTerms) {
  DeviceProfile profile = ParseProfile(kGood, "some.toml");
  // 2 b/T = 2 x 2 / (2 ms + 2 x 2 ms) = 667; 2 f_c/step = 2 x 0.01 / 20 um = 1000; the maker's 700.
  EXPECT_NEAR(StableStiffness(profile), 4 / 0.006, 1e-9);
  profile.delay = 0.001;
  EXPECT_DOUBLE_EQ(StableStiffness(profile), 700);
  profile.limits.stiffness = 5000;
  profile.delay = 0.003;
  EXPECT_NEAR(StableStiffness(profile), 500, 1e-9);  // 4 / 8 ms
  profile.limits.damping = 0;                        // unknown
  EXPECT_NEAR(StableStiffness(profile), 1000, 1e-9);
  profile.coulomb_friction = 0;  // unknown
  EXPECT_DOUBLE_EQ(StableStiffness(profile), 5000);
}

TEST(LimitsOf, CountsTheTicksThatAForceIsLate) {
  DeviceProfile profile = ParseProfile(kGood, "some.toml");
  EXPECT_EQ(LimitsOf(profile, 0.001).late_ticks, 3);  // 2 ms + 2 ms, less the tick itself
  EXPECT_EQ(LimitsOf(profile, 0.0001).late_ticks, 39);
  EXPECT_EQ(LimitsOf(profile, 0.004).late_ticks, 1);
  EXPECT_NEAR(LimitsOf(profile, 0.001).stiffness, 4 / 0.006, 1e-9);
}

TEST(Profiles, ThatAreShippedAreAllReadable) {
  const std::string folder = SourcePath("devices/profiles");
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const DeviceProfile profile = LoadProfile(entry.path().string());
    ++count;
    EXPECT_EQ(profile.name, entry.path().stem().string());
    EXPECT_GT(StableStiffness(profile), 0) << profile.name;
    // Whatever pushes must be able to rest its motors.
    EXPECT_EQ(glm::any(profile.limits.pushes), std::isfinite(profile.limits.continuous_force))
        << profile.name;
  }
  EXPECT_GE(count, 8);
}

TEST(Profiles, OfTheArmAgreeWithItsMotors) {
  const std::string path = SourcePath("devices/profiles/woodenhaptics.toml");
  const DeviceProfile profile = LoadProfile(path);
  // 3 A through 25.9 mNm/A and 12 : 1 on a lever of 245 mm; the profile rounds down to 0.1 N.
  EXPECT_NEAR(profile.limits.peak_force, 3 * 0.0259 * 12 / 0.245, 0.1);
  EXPECT_NEAR(profile.arm.reduction[0], 16, 1e-12);
  EXPECT_NEAR(profile.arm.rest[2], std::acos(0.0), 1e-12);
}

TEST(LoadProfile, NamesAMissingFile) {
  EXPECT_THROW(LoadProfile("/nowhere/none.toml"), DeviceError);
}

}  // namespace
}  // namespace moontrace

#include "devices/hid/puck.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <thread>

#include "tests/devices/device_run.h"
#include "tests/devices/fake_hid.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

DeviceProfile Profile() { return LoadProfile(SourcePath("devices/profiles/spacemouse.toml")); }

std::unique_ptr<Device> Open() { return MakePuck(FindHid(0x256f, 0xc635), Profile(), 0.001); }

TEST(TakePuckReport, ReadsTranslationAndButtons) {
  PuckState state;
  const std::array<std::uint8_t, 7> translation = {1, 0x5E, 0x01, 0xA2, 0xFE, 0, 0};
  EXPECT_TRUE(TakePuckReport(translation, state));
  EXPECT_EQ(state.translation, (std::array<std::int16_t, 3>{350, -350, 0}));
  const std::array<std::uint8_t, 3> buttons = {3, 0x02, 0x01};
  EXPECT_TRUE(TakePuckReport(buttons, state));
  EXPECT_EQ(state.buttons, 0x0102u);
  EXPECT_EQ(state.translation[0], 350);  // kept
}

TEST(TakePuckReport, TakesAllSixAxesInOneReport) {
  PuckState state;
  const std::array<std::uint8_t, 13> both = {1, 10, 0, 20, 0, 30, 0, 1, 1, 1, 1, 1, 1};
  EXPECT_TRUE(TakePuckReport(both, state));
  EXPECT_EQ(state.translation[2], 30);
}

TEST(TakePuckReport, RefusesWhatIsNoneOfAPucks) {
  PuckState state;
  EXPECT_FALSE(TakePuckReport({}, state));
  EXPECT_FALSE(TakePuckReport(std::array<std::uint8_t, 4>{1, 2, 3, 4}, state));
  EXPECT_FALSE(TakePuckReport(std::array<std::uint8_t, 7>{9, 2, 3, 4, 5, 6, 7}, state));
  EXPECT_EQ(state.translation[0], 0);
}

TEST(PuckVelocity, IsZeroInTheDeadZoneAndTheTopSpeedAtFullDeflection) {
  const PuckMap puck = Profile().puck;  // dead zone 10 of 350, 60 mm/s; away is -y, up is -z
  EXPECT_EQ(PuckVelocity(puck, {{10, -10, 10}, 0}), glm::dvec3(0, 0, 0));
  EXPECT_NEAR(PuckVelocity(puck, {{350, 0, 0}, 0}).x, 0.060, 1e-12);
  EXPECT_NEAR(PuckVelocity(puck, {{180, 0, 0}, 0}).x, 0.030, 1e-12);  // half of what is left
  EXPECT_NEAR(PuckVelocity(puck, {{0, 350, 0}, 0}).y, -0.060, 1e-12);
  EXPECT_NEAR(PuckVelocity(puck, {{0, 0, -32768}, 0}).z, 0.060, 1e-12);  // held at the top speed
}

TEST(Puck, MovesTheTipAndPushesNothing) {
  const FakeHid fake("spacemouse");
  const auto device = Open();
  EXPECT_FALSE(glm::any(device->Limits().pushes));
  // A second at full deflection to the right, then silence.
  const DeviceRun run = RunDevice(*device, 1600, {3, 3, 3});
  ASSERT_GT(run.states.size(), 5u);
  EXPECT_EQ(run.no_data, 0);  // silence is no fault
  const DeviceState& last = run.states.back();
  // 60 mm, less what passed before it was opened and in long gaps on a busy machine.
  EXPECT_GT(last.p_D.x, 0.01);
  EXPECT_LT(last.p_D.x, 0.0605);
  EXPECT_EQ(last.v_D, glm::dvec3(0, 0, 0));
  EXPECT_EQ(last.buttons, 1u);
  EXPECT_TRUE(fake.Log("out").empty());
}

TEST(Puck, NeverLeavesItsWorkspace) {
  const FakeHid fake("spacemouse", "jump20@0");  // deflected to the right for ever
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 3600, {0, 0, 0});
  ASSERT_FALSE(run.states.empty());
  EXPECT_NEAR(run.states.back().p_D.x, 0.15, 1e-9);  // half of 300 mm; 60 mm/s would be 192
}

TEST(Puck, IsLostWhenItIsUnpluggedAndWorksAgainAfterwards) {
  const FakeHid fake("spacemouse", "replug@100");
  auto device = Open();
  EXPECT_EQ(RunDevice(*device, 2000, {0, 0, 0}).last, DeviceStatus::kLost);
  device.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  device = Open();
  EXPECT_GT(RunDevice(*device, 200, {0, 0, 0}).states.back().p_D.x, 0);
}

TEST(Puck, IsLostOnTruncatedReports) {
  const FakeHid fake("spacemouse", "truncated@100");
  const auto device = Open();
  EXPECT_EQ(RunDevice(*device, 2000, {0, 0, 0}).last, DeviceStatus::kLost);
}

TEST(Puck, IsLostOrSlowOnGarbage) {
  const FakeHid fake("spacemouse", "garbage@100");
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 1000, {0, 0, 0});
  // Most garbage bears other numbers and is passed over; what looks like a report moves the tip no
  // faster than a hand could.
  for (const DeviceState& state : run.states) {
    EXPECT_LE(glm::length(state.v_D), 0.061 * std::sqrt(3.0));
  }
}

TEST(Puck, StaysFreshInAFlood) {
  const FakeHid fake("spacemouse", "flood@50");
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 1400, {0, 0, 0});
  EXPECT_NE(run.last, DeviceStatus::kLost);
  ASSERT_FALSE(run.states.empty());
  EXPECT_EQ(run.states.back().v_D, glm::dvec3(0, 0, 0));
}

}  // namespace
}  // namespace moontrace

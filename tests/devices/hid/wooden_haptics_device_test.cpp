#include "devices/hid/wooden_haptics_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <thread>
#include <vector>

#include "devices/hid/homing.h"
#include "tests/devices/device_run.h"
#include "tests/devices/fake_hid.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

// The emulated person homes the arm in 2.3 s (fake/arm_emulator.h): faults come after 2.6 s.

DeviceProfile Profile(const std::string& name) {
  return LoadProfile(SourcePath("devices/profiles/" + name + ".toml"));
}

std::unique_ptr<Device> Open(const std::string& name) {
  const DeviceProfile profile = Profile(name);
  return MakeWoodenHaptics(FindHid(profile.ids[0].vendor, profile.ids[0].product), profile, 0.001);
}

/// Homes it and tells the steps that were said; what an interrupted command would see after 10 s.
std::vector<HomingStep> HomeIt(Device& device) {
  std::vector<HomingStep> said;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  const bool is_homed = Home(
      device, [&](HomingStep step) { said.push_back(step); },
      [&] { return std::chrono::steady_clock::now() < end; });
  EXPECT_TRUE(is_homed);
  return said;
}

glm::dvec3 LastForce(const FakeHid& fake) {
  const auto lines = fake.Log("force");
  if (lines.empty()) return {0, 0, 0};
  const auto& force = lines.back().force;
  return {force.at(0), force.at(1), force.at(2)};
}

/// The last force that was one [N]: after 20 ms without a tick the guardian lets go, while a slow
/// machine still reads the log.
glm::dvec3 LastPush(const FakeHid& fake) {
  glm::dvec3 push(0, 0, 0);
  for (const FakeHid::Line& line : fake.Log("force")) {
    const glm::dvec3 force(line.force.at(0), line.force.at(1), line.force.at(2));
    if (glm::length(force) > 0) push = force;
  }
  return push;
}

/// Whether every byte of the last output report is 0: no current.
bool EndsWithoutCurrent(const FakeHid& fake) {
  const auto lines = fake.Log("out");
  if (lines.empty()) return false;
  for (const int byte : lines.back().bytes) {
    if (byte != 0) return false;
  }
  return true;
}

class SlowWoodenHaptics : public testing::TestWithParam<const char*> {};

TEST_P(SlowWoodenHaptics, IsHomedByWordsThenFollowsTheHandAndPushesIt) {
  const FakeHid fake(GetParam());
  const auto device = Open(GetParam());
  EXPECT_EQ(HomeIt(*device),
            (std::vector{HomingStep::kRest, HomingStep::kMove, HomingStep::kDone}));
  RunDevice(*device, 700, {0, 0, 0});
  EXPECT_TRUE(fake.Log("force").empty());  // nothing pushed before
  const DeviceRun run = RunDevice(*device, 500, {0, 0, 1});
  ASSERT_GT(run.states.size(), 5u);
  // 1 N on a hand of 200 N/m: 5 mm up, less what has not died down (time constant 0.07 s); a count
  // is 64 um, a milliampere 4 mN, and the currents are those of a position up to some ms old.
  EXPECT_NEAR(run.states.back().p_D.z, 0.005, 0.001);
  const glm::dvec3 force = LastPush(fake);
  EXPECT_NEAR(force.x, 0, 0.05);
  EXPECT_NEAR(force.y, 0, 0.05);
  EXPECT_NEAR(force.z, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Generations, SlowWoodenHaptics,
                         testing::Values("woodenhaptics", "polhem", "polhem-teensy"));

TEST(WoodenHaptics, IsNotReadyAndGetsNoCurrentBeforeItIsHomed) {
  const FakeHid fake("woodenhaptics");
  const auto device = Open("woodenhaptics");
  const DeviceRun run = RunDevice(*device, 200, {1, 1, 1});
  EXPECT_EQ(run.last, DeviceStatus::kNotReady);
  EXPECT_TRUE(run.states.empty());
  EXPECT_EQ(device->Write({1, 1, 1}), DeviceStatus::kNotReady);
  EXPECT_TRUE(fake.Log("force").empty());
  EXPECT_GT(fake.Log("out").size(), 2u);  // it is heard, or it would not answer
}

TEST(FitsArm, TellsGenerationsOfOneIdApart) {
  const FakeHid fake("polhem");
  const HidInfo info = FindHid(0x1234, 0x0006);
  EXPECT_TRUE(FitsArm(info, Profile("polhem")));
  EXPECT_FALSE(FitsArm(info, Profile("woodenhaptics")));
}

TEST(FitsArm, IsFalseForABrokenDescriptor) {
  const FakeHid fake("polhem", "wrong-descriptor");
  EXPECT_FALSE(FitsArm(FindHid(0x1234, 0x0006), Profile("polhem")));
}

TEST(WoodenHaptics, IsLostOnReportsOfAnotherSize) {
  for (const char* const fault : {"garbage@100", "truncated@100"}) {
    const FakeHid fake("woodenhaptics", fault);
    const auto device = Open("woodenhaptics");
    EXPECT_EQ(RunDevice(*device, 2000, {0, 0, 0}).last, DeviceStatus::kLost) << fault;
  }
}

TEST(SlowWoodenHapticsFaults, UnpluggedIsLostAndMustBeHomedAgain) {
  const FakeHid fake("woodenhaptics", "replug@2600");
  auto device = Open("woodenhaptics");
  HomeIt(*device);
  EXPECT_EQ(RunDevice(*device, 2000, {1, 0, 0}).last, DeviceStatus::kLost);
  device.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  device = Open("woodenhaptics");
  EXPECT_EQ(RunDevice(*device, 50, {1, 0, 0}).last, DeviceStatus::kNotReady);
  HomeIt(*device);
  EXPECT_GT(RunDevice(*device, 200, {1, 0, 0}).states.size(), 2u);
}

TEST(SlowWoodenHapticsFaults, GarbageInMidStrokeStopsTheCurrents) {
  for (const char* const fault : {"garbage@2600", "truncated@2600"}) {
    const FakeHid fake("woodenhaptics", fault);
    const auto device = Open("woodenhaptics");
    HomeIt(*device);
    const DeviceRun run = RunDevice(*device, 2000, {1, 0, 0});
    EXPECT_EQ(run.last, DeviceStatus::kLost) << fault;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_TRUE(EndsWithoutCurrent(fake)) << fault;
  }
}

TEST(SlowWoodenHapticsFaults, AStandingCounterIsNoNewData) {
  const FakeHid fake("woodenhaptics", "stuck@2600");
  const auto device = Open("woodenhaptics");
  HomeIt(*device);
  RunDevice(*device, 1200, {0, 0, 0});
  EXPECT_TRUE(RunDevice(*device, 100, {0, 0, 0}).states.empty());
}

TEST(SlowWoodenHapticsFaults, AJumpOfTwentyMillimetresIsShownAsItIs) {
  const FakeHid fake("woodenhaptics", "jump20@2600");
  const auto device = Open("woodenhaptics");
  HomeIt(*device);
  const DeviceRun run = RunDevice(*device, 1200, {0, 0, 0});
  // To stop on it is the safety stage's; without force nothing else moves z. Counts are 0.1 mm.
  ASSERT_FALSE(run.states.empty());
  EXPECT_NEAR(run.states.back().p_D.z, 0.02, 3e-4);
}

TEST(SlowWoodenHapticsFaults, AFloodLeavesItFresh) {
  const FakeHid fake("woodenhaptics", "flood@2600");
  const auto device = Open("woodenhaptics");
  HomeIt(*device);
  const DeviceRun run = RunDevice(*device, 1500, {0, 0, 1});
  EXPECT_NE(run.last, DeviceStatus::kLost);
  ASSERT_GT(run.states.size(), 5u);
  EXPECT_NEAR(run.states.back().p_D.z, 0.005, 0.001);
}

TEST(SlowWoodenHapticsFaults, ADeafOneIsLostAndItsDeadManLetsGo) {
  const FakeHid fake("woodenhaptics", "deaf@2600");
  auto device = Open("woodenhaptics");
  HomeIt(*device);
  EXPECT_EQ(RunDevice(*device, 3000, {1, 0, 0}).last, DeviceStatus::kLost);
  std::this_thread::sleep_for(std::chrono::milliseconds(700));  // the firmware's half second
  EXPECT_EQ(glm::length(LastForce(fake)), 0);
}

TEST(SlowWoodenHapticsFaults, ClosedItHasNoCurrent) {
  const FakeHid fake("polhem");
  {
    const auto device = Open("polhem");
    HomeIt(*device);
    RunDevice(*device, 100, {1, 0, 0});
  }
  EXPECT_TRUE(EndsWithoutCurrent(fake));
}

}  // namespace
}  // namespace moontrace

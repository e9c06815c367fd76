#include "devices/hid/raw_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <thread>

#include "devices/core/device_error.h"
#include "tests/devices/device_run.h"
#include "tests/devices/fake_hid.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const char* const kKind = "moontrace-raw";

DeviceProfile RawProfile() {
  return LoadProfile(SourcePath("devices/profiles/moontrace-raw.toml"));
}

std::unique_ptr<Device> Open() {
  return MakeRawDevice(FindHid(0x16c0, 0x0486), RawProfile(), 0.001);
}

/// The last force that the emulated motors had [N].
glm::dvec3 LastForce(const FakeHid& fake) {
  const auto lines = fake.Log("force");
  if (lines.empty()) return {0, 0, 0};
  const auto& force = lines.back().force;
  return {force.at(0), force.at(1), force.at(2)};
}

/// The last force that was one [N]: when nobody ticks any more the guardian lets go after 20 ms,
/// and the device's own dead-man, while a slow machine still reads the log.
glm::dvec3 LastPush(const FakeHid& fake) {
  glm::dvec3 push(0, 0, 0);
  for (const FakeHid::Line& line : fake.Log("force")) {
    const glm::dvec3 force(line.force.at(0), line.force.at(1), line.force.at(2));
    if (force != glm::dvec3(0, 0, 0)) push = force;
  }
  return push;
}

/// Whether the last output report that was handed over says: let go.
bool EndsLetGo(const FakeHid& fake) {
  const auto lines = fake.Log("out", kRawOutputNumber);
  return !lines.empty() && (lines.back().bytes.at(1) & 1) == 0;
}

TEST(RawDevice, IsRecognisedByItsUsageNotByItsIds) {
  const FakeHid fake(kKind);
  const HidInfo info = FindHid(0x16c0, 0x0486);
  EXPECT_TRUE(OffersRawProtocol(info));
  HidInfo other = info;
  other.usages = {{0xFFAB, 0x0200}};  // any Teensy's raw HID
  EXPECT_FALSE(OffersRawProtocol(other));
}

TEST(RawDevice, TakesItsLimitsFromTheDevice) {
  const FakeHid fake(kKind);
  const auto device = Open();
  const DeviceLimits limits = device->Limits();
  EXPECT_NEAR(limits.workspace_D.x, 0.08, 1e-9);  // half of 160 mm
  EXPECT_NEAR(limits.workspace_D.z, 0.03, 1e-9);
  EXPECT_NEAR(limits.peak_force, 5, 1e-9);  // less than the profile's 10
  EXPECT_NEAR(limits.dead_man, 0.015, 1e-9);
  EXPECT_EQ(limits.buttons, 2);
}

TEST(RawDevice, FollowsTheHandAndPushesIt) {
  const FakeHid fake(kKind);
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 700, {0, 0, 2});
  ASSERT_GT(run.states.size(), 5u);
  // The hand is a spring of 200 N/m: 2 N move it by 10 mm, once its swing (time constant
  // 2 m/b = 0.07 s) has died down to a few percent.
  EXPECT_NEAR(run.states.back().p_D.z, 0.010, 0.002);
  EXPECT_TRUE(run.states.back().velocity_known);
  EXPECT_NEAR(LastPush(fake).z, 2, 1e-3);
}

TEST(RawDevice, HoldsForcesUnderThePeakAndDropsWhatIsNoNumber) {
  const FakeHid fake(kKind);
  const auto device = Open();
  RunDevice(*device, 100, {std::nan(""), 50, -1});
  const glm::dvec3 force = LastPush(fake);
  EXPECT_EQ(force.x, 0);
  EXPECT_NEAR(force.y, 5, 1e-3);
  EXPECT_NEAR(force.z, -1, 1e-3);
}

TEST(RawDevice, LetsGoWhenItIsClosed) {
  const FakeHid fake(kKind);
  {
    const auto device = Open();
    RunDevice(*device, 60, {1, 0, 0});
  }
  EXPECT_TRUE(EndsLetGo(fake));
}

TEST(RawDevice, IsLetGoByItsOwnDeadManWhenTheProgramHangs) {
  const FakeHid fake(kKind);
  const auto device = Open();
  RunDevice(*device, 60, {1, 0, 0});
  ASSERT_NEAR(LastPush(fake).x, 1, 1e-3);
  // Nobody ticks: repeats stop after 20 ms, the dead-man comes 15 ms later.
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  EXPECT_EQ(LastForce(fake).x, 0);
}

TEST(RawDevice, IsLostWhenItIsUnpluggedAndWorksAgainAfterwards) {
  const FakeHid fake(kKind, "replug@100");
  auto device = Open();
  const DeviceRun run = RunDevice(*device, 2000, {1, 0, 0});
  EXPECT_EQ(run.last, DeviceStatus::kLost);
  EXPECT_GT(run.states.size(), 2u);
  DeviceState state;
  EXPECT_EQ(device->Read(state), DeviceStatus::kLost);  // for good
  device.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  device = Open();
  EXPECT_GT(RunDevice(*device, 100, {1, 0, 0}).states.size(), 2u);
  EXPECT_NEAR(LastPush(fake).x, 1, 1e-3);
}

TEST(RawDevice, IsLostAndLetGoOnGarbage) {
  for (const char* const fault : {"garbage@100", "truncated@100"}) {
    const FakeHid fake(kKind, fault);
    const auto device = Open();
    const DeviceRun run = RunDevice(*device, 2000, {1, 0, 0});
    EXPECT_EQ(run.last, DeviceStatus::kLost) << fault;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_TRUE(EndsLetGo(fake)) << fault;
  }
}

TEST(RawDevice, HasNoNewDataWhileItRepeatsItself) {
  const FakeHid fake(kKind, "stuck@100");
  const auto device = Open();
  RunDevice(*device, 400, {0, 0, 0});
  const DeviceRun run = RunDevice(*device, 100, {0, 0, 0});
  EXPECT_TRUE(run.states.empty());
  EXPECT_GT(run.no_data, 0);
}

TEST(RawDevice, ShowsAJumpAsItIs) {
  const FakeHid fake(kKind, "jump20@500");
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 800, {0, 0, 0});
  // To stop on a jump is the safety stage's; it must see it. No force: nothing else moves z.
  ASSERT_FALSE(run.states.empty());
  EXPECT_NEAR(run.states.front().p_D.z, 0, 1e-5);
  EXPECT_NEAR(run.states.back().p_D.z, 0.02, 1e-5);
}

TEST(RawDevice, StaysFreshInAFlood) {
  const FakeHid fake(kKind, "flood@50");
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 700, {0, 0, 2});
  EXPECT_NE(run.last, DeviceStatus::kLost);
  ASSERT_GT(run.states.size(), 5u);
  EXPECT_NEAR(run.states.back().p_D.z, 0.010, 0.002);
}

TEST(RawDevice, IsNotReadyWhileItsMotorsAreOff) {
  const FakeHid fake(kKind, "disabled@100");
  const auto device = Open();
  const DeviceRun run = RunDevice(*device, 500, {1, 0, 0});
  EXPECT_EQ(run.last, DeviceStatus::kNotReady);
  EXPECT_EQ(device->Write({1, 0, 0}), DeviceStatus::kNotReady);
  EXPECT_TRUE(EndsLetGo(fake));
}

TEST(SlowRawDevice, IsLostWhenItTakesNothingAnyMore) {
  const FakeHid fake(kKind, "deaf@100");
  auto device = Open();
  const DeviceRun run = RunDevice(*device, 3000, {1, 0, 0});
  EXPECT_EQ(run.last, DeviceStatus::kLost);
  EXPECT_EQ(LastForce(fake).x, 0);  // its own dead-man
  device.reset();                   // waits for no write
}

TEST(RawDevice, ThatDoesNotAnswerIsRefused) {
  const FakeHid fake("pid");
  try {
    MakeRawDevice(FindHid(0x1209, 0xffb0), RawProfile(), 0.001);
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("feature report 3"), std::string::npos);
  }
}

TEST(WithHello, LetsTheLesserPeakForceCount) {
  RawHello hello;
  hello.peak_force = 1;
  hello.rate = 500;
  EXPECT_DOUBLE_EQ(WithHello(RawProfile(), hello).limits.peak_force, 1);
  EXPECT_DOUBLE_EQ(WithHello(RawProfile(), hello).limits.continuous_force, 1);
  hello.peak_force = 50;
  EXPECT_DOUBLE_EQ(WithHello(RawProfile(), hello).limits.peak_force, 10);
}

}  // namespace
}  // namespace moontrace

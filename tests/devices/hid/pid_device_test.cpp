#include "devices/hid/pid_device.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <thread>

#include "devices/core/device_error.h"
#include "tests/devices/fake/pid_emulator.h"
#include "tests/devices/fake_hid.h"

namespace moontrace {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kTick = 0.001;

// Report numbers of the emulated board (mujoco-and-hid.md, 2.3).
constexpr int kEffect = 1, kConstant = 5, kOperation = 10, kFree = 11, kControl = 12, kGain = 13;

DeviceProfile Profile() {
  DeviceProfile profile;
  profile.name = "stick";
  profile.kind = DeviceKind::kPid;
  profile.limits.peak_force = 5;
  profile.limits.stiffness = 500;
  profile.limits.buttons = 8;
  profile.limits.workspace_D = {fake::kPidReach, fake::kPidReach, 0.5};
  profile.stick.full_force = fake::kPidFullForce;
  return profile;
}

std::unique_ptr<Device> Open(const DeviceProfile& profile = Profile(),
                             std::string* autocentre = nullptr) {
  const auto list = ListHid();
  if (list.empty()) throw DeviceError("nothing is plugged in");
  return MakePidDevice(list.front(), profile, kTick, 1, autocentre);
}

/// Ticks until `done` comes true, at most for far longer than it can take. False: it never did.
bool TickUntil(Device& device, glm::dvec3 f_D,
               const std::function<bool(DeviceStatus, const DeviceState&)>& done) {
  DeviceState state;
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (Clock::now() < end) {
    const DeviceStatus status = device.Read(state);
    if (done(status, state)) return true;
    device.Write(f_D);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

bool BecomesLost(Device& device, glm::dvec3 f_D) {
  return TickUntil(device, f_D,
                   [](DeviceStatus status, auto&) { return status == DeviceStatus::kLost; });
}

std::size_t IndexOf(const std::vector<FakeHid::Line>& log, std::vector<int> bytes) {
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log[i].bytes == bytes) return i;
  }
  return log.size();
}

TEST(PidDevice, SetsUpOneFiniteConstantForceForEachMotor) {
  FakeHid fake("pid");
  Open();
  const auto log = fake.Log();
  const std::size_t reset = IndexOf(log, {kControl, 8}), enable = IndexOf(log, {kControl, 1});
  const std::size_t gain = IndexOf(log, {kGain, 255});
  const std::size_t create = IndexOf(log, {0x11, 1, 0, 0});
  EXPECT_LT(reset, enable);
  EXPECT_LT(enable, gain);
  EXPECT_LT(gain, create);
  const auto effects = fake.Log("out", kEffect);
  ASSERT_EQ(effects.size(), 2u);
  for (const auto& effect : effects) {
    const int duration = effect.bytes[3] + 256 * effect.bytes[4];
    EXPECT_GT(duration, 0);
    EXPECT_LE(duration, 50);
  }
  // Each effect is at zero before it starts.
  EXPECT_LT(IndexOf(log, {kConstant, 1, 0, 0}), IndexOf(log, {kOperation, 1, 1, 1}));
  EXPECT_LT(IndexOf(log, {kConstant, 2, 0, 0}), IndexOf(log, {kOperation, 2, 1, 1}));
}

TEST(PidDevice, GivesTheForceThatIsWritten) {
  for (const char* kind : {"pid", "pid-array"}) {
    FakeHid fake(kind);
    const auto device = Open();
    const glm::dvec3 wanted(1.5, -0.75, 0);
    // One step of the magnitude, of 32767 or of 4096 for 10 N, half of it by rounding.
    const double step = kind == std::string("pid") ? 10.0 / 32767 : 10.0 / 4096;
    // The angle is told to 1 of 255 parts of a turn at the worst: a quarter turn is off by 1/4.
    const double askew = kind == std::string("pid") ? 0 : 6.2832 * 0.5 / 255 * 1.5;
    EXPECT_TRUE(TickUntil(*device, wanted, [&](auto, auto&) {
      const auto log = fake.Log("force");
      if (log.empty()) return false;
      const auto& f = log.back().force;
      return std::abs(f[0] - wanted.x) < step + askew && std::abs(f[1] - wanted.y) < step + askew;
    })) << kind;
  }
}

TEST(PidDevice, TellsWhereTheStickIs) {
  FakeHid fake("pid");
  const auto device = Open();
  EXPECT_FALSE(device->Limits().measures.z);
  EXPECT_EQ(device->Limits().pushes, glm::bvec3(true, true, false));
  EXPECT_EQ(device->Limits().buttons, 8);
  // The emulated hand swings 30 mm to either side in x.
  double last = -1;
  EXPECT_TRUE(TickUntil(*device, {0, 0, 0}, [&](DeviceStatus status, const DeviceState& s) {
    if (status != DeviceStatus::kOk) return false;
    EXPECT_LT(std::abs(s.p_D.x), 0.04);
    EXPECT_LT(std::abs(s.p_D.y), 0.02);
    EXPECT_EQ(s.p_D.z, 0);  // the setting presses
    EXPECT_EQ(s.buttons, 0u);
    EXPECT_GE(s.time, last);
    last = s.time;
    return s.p_D.x > 0.02;
  }));
}

// A force of 2 N against 200 N/m moves the hand by 10 mm, towards where it points: also in y,
// though HID's Y grows towards the person.
TEST(PidDevice, PushesTheWayItMeasures) {
  for (const char* kind : {"pid", "pid-array"}) {
    FakeHid fake(kind);
    const auto device = Open();
    EXPECT_TRUE(TickUntil(*device, {0, 4, 0}, [](DeviceStatus status, const DeviceState& s) {
      return status == DeviceStatus::kOk && s.p_D.y > 0.012;  // the aim alone reaches 10 mm
    })) << kind;
  }
}

TEST(PidDevice, StartsItsEffectsAgainWhileItTicks) {
  FakeHid fake("pid");
  const auto device = Open();
  // Set-up starts both once; 20 more are renewals, though the force stays the same.
  EXPECT_TRUE(TickUntil(*device, {1, 0, 0},
                        [&](auto, auto&) { return fake.Log("out", kOperation).size() > 22; }));
  for (const auto& line : fake.Log("out", kOperation)) EXPECT_EQ(line.bytes[2], 1);
}

TEST(PidDevice, LetsGoWhenTheTickHangs) {
  FakeHid fake("pid");
  const auto device = Open();
  ASSERT_TRUE(TickUntil(*device, {2, 0, 0}, [&](auto, auto&) {
    const auto log = fake.Log("force");
    return !log.empty() && log.back().force[0] > 1;
  }));
  // Nobody ticks any more; the device's own duration ends the force.
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (fake.Log("force").back().force[0] != 0 && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(fake.Log("force").back().force, (std::vector<double>{0, 0, 0}));
}

TEST(PidDevice, TakesItsLeaveWithZeroStopFreeAndDisable) {
  FakeHid fake("pid");
  {
    const auto device = Open();
    ASSERT_TRUE(TickUntil(*device, {2, 1, 0}, [&](auto, auto&) {
      const auto log = fake.Log("force");
      return !log.empty() && log.back().force[0] > 1;
    }));
  }
  const auto log = fake.Log("out");
  const std::vector<std::vector<int>> farewell = {
      {kConstant, 1, 0, 0},  {kConstant, 2, 0, 0}, {kOperation, 1, 3, 1}, {kFree, 1},
      {kOperation, 2, 3, 1}, {kFree, 2},           {kControl, 4},         {kControl, 2}};
  ASSERT_GE(log.size(), farewell.size());
  for (std::size_t i = 0; i < farewell.size(); ++i) {
    EXPECT_EQ(log[log.size() - farewell.size() + i].bytes, farewell[i]) << i;
  }
}

TEST(PidDevice, SwitchesTheCentringSpringOffAndReadsItBack) {
  FakeHid fake("pid-array");  // hands out blocks from 2 on: 1 is its own spring
  std::string autocentre;
  const auto device = Open(Profile(), &autocentre);
  EXPECT_NE(autocentre.find("is off, read back"), std::string::npos) << autocentre;
  // Without the spring and without commands nothing pulls, wherever the hand is.
  EXPECT_TRUE(TickUntil(*device, {0, 0, 0}, [](DeviceStatus status, const DeviceState& s) {
    return status == DeviceStatus::kOk && std::abs(s.p_D.x) > 0.01;
  }));
  const auto log = fake.Log();
  const std::size_t stop = IndexOf(log, {110, 1, 3, 1});
  ASSERT_LT(stop, log.size());
  for (std::size_t i = stop; i < log.size(); ++i) {
    if (log[i].what == "force") {
      EXPECT_EQ(log[i].force, (std::vector<double>{0, 0, 0}));
    }
  }
}

// A learner was told of a spring that is not there, with nothing to do about it.
TEST(PidDevice, SaysNothingOfACentringSpringThatIsNotThere) {
  FakeHid fake("pid");
  std::string autocentre;
  Open(Profile(), &autocentre);
  EXPECT_EQ(autocentre, "");
}

TEST(PidDevice, LiftsTheTipUnlessTheButtonPresses) {
  FakeHid fake("pid");
  DeviceProfile profile = Profile();
  profile.stick.press = StickMap::Press::kButton;
  const auto device = Open(profile);
  EXPECT_TRUE(TickUntil(*device, {0, 0, 0}, [](DeviceStatus status, const DeviceState& s) {
    return status == DeviceStatus::kOk && s.p_D.z > 0;
  }));
}

TEST(PidDevice, PressesByAnAxis) {
  FakeHid fake("pid");
  DeviceProfile profile = Profile();
  profile.stick.press = StickMap::Press::kAxis;
  profile.stick.press_axis = {0x36, 1};  // the slider rests in its middle: half of 1 N
  const auto device = Open(profile);
  EXPECT_TRUE(TickUntil(*device, {0, 0, 0}, [](DeviceStatus status, const DeviceState& s) {
    return status == DeviceStatus::kOk && std::abs(s.p_D.z + 0.5 / 500) < 1e-6;
  }));
}

TEST(PidDevice, IsLostWhenUnplugged) {
  FakeHid fake("pid", "unplug@200");
  const auto device = Open();
  EXPECT_TRUE(BecomesLost(*device, {1, 0, 0}));
  DeviceState state;
  EXPECT_EQ(device->Write({1, 0, 0}), DeviceStatus::kLost);
  EXPECT_EQ(device->Read(state), DeviceStatus::kLost);
  EXPECT_THROW(Open(), DeviceError);
}

TEST(PidDevice, WorksAgainAfterReplugging) {
  FakeHid fake("pid", "replug@200");
  auto device = Open();
  ASSERT_TRUE(BecomesLost(*device, {1, 0, 0}));
  device.reset();
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (ListHid().empty() && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  device = Open();
  EXPECT_TRUE(TickUntil(*device, {1, 0, 0}, [&](DeviceStatus status, auto&) {
    return status == DeviceStatus::kOk && fake.Log("force").back().force[0] > 0.9;
  }));
}

TEST(PidDevice, IsLostWhenDeafAndItsForceEndsByItself) {
  FakeHid fake("pid", "deaf@200");
  auto device = Open();
  EXPECT_TRUE(BecomesLost(*device, {1, 0, 0}));
  // The last effect it took is over after 50 ms; it is deaf to the farewell.
  EXPECT_EQ(fake.Log("force").back().force, (std::vector<double>{0, 0, 0}));
}

TEST(PidDevice, CannotBeOpenedWhenDeaf) {
  FakeHid fake("pid", "deaf");
  EXPECT_THROW(Open(), DeviceError);
}

TEST(PidDevice, IsLostByGarbage) {
  FakeHid fake("pid", "garbage@200");
  const auto device = Open();
  EXPECT_TRUE(BecomesLost(*device, {1, 0, 0}));
}

TEST(PidDevice, IsLostByReportsCutShort) {
  FakeHid fake("pid", "truncated@200");
  const auto device = Open();
  EXPECT_TRUE(BecomesLost(*device, {1, 0, 0}));
}

TEST(PidDevice, StaysUsableInAFlood) {
  FakeHid fake("pid", "flood@100");
  const auto device = Open();
  int readings = 0;
  EXPECT_TRUE(TickUntil(*device, {1, 0, 0}, [&](DeviceStatus status, auto&) {
    EXPECT_NE(status, DeviceStatus::kLost);
    return (readings += status == DeviceStatus::kOk) > 300;
  }));
}

TEST(PidDevice, PassesJumpsOnToTheSafetyStage) {
  FakeHid fake("pid", "jump20@300");
  const auto device = Open();
  double before = 0;
  bool has_read = false;
  EXPECT_TRUE(TickUntil(*device, {0, 0, 0}, [&](DeviceStatus status, const DeviceState& s) {
    if (status != DeviceStatus::kOk) return false;
    const bool jumped = has_read && std::abs(s.p_D.x - before) > 0.015;
    before = s.p_D.x;
    has_read = true;
    return jumped;
  }));
}

TEST(PidDevice, TellsTheSamePlaceWhileStuck) {
  FakeHid fake("pid", "stuck@100");
  const auto device = Open();
  int same = 0;
  DeviceState last;
  EXPECT_TRUE(TickUntil(*device, {0, 0, 0}, [&](DeviceStatus status, const DeviceState& s) {
    EXPECT_NE(status, DeviceStatus::kLost);
    if (status != DeviceStatus::kOk) return false;
    same = s.p_D == last.p_D ? same + 1 : 0;
    last = s;
    return same > 200;
  }));
}

TEST(PidDevice, IsNotReadyAndGivesNothingWhileItsMotorsAreOff) {
  FakeHid fake("pid", "disabled@200");
  const auto device = Open();
  ASSERT_TRUE(TickUntil(*device, {1, 0, 0}, [](DeviceStatus status, auto&) {
    return status == DeviceStatus::kNotReady;
  }));
  EXPECT_EQ(device->Write({1, 0, 0}), DeviceStatus::kNotReady);
  // The last command handed over becomes zero.
  const auto end = Clock::now() + std::chrono::seconds(20);
  const auto zero = std::vector<int>{kConstant, 1, 0, 0};
  while (fake.Log("out", kConstant).back().bytes != zero && Clock::now() < end) {
    const auto last = fake.Log("out", kConstant);
    if (last.size() > 1 && last[last.size() - 2].bytes == zero) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  bool is_zero = false;
  for (const auto& line : fake.Log("out", kConstant)) {
    if (line.bytes[1] == 1) is_zero = line.bytes == zero;
  }
  EXPECT_TRUE(is_zero);
}

TEST(PidDevice, RefusesAWrongDescriptorInOneLine) {
  FakeHid fake("pid", "wrong-descriptor");
  try {
    Open();
    FAIL() << "opened";
  } catch (const DeviceError& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find("descriptor"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace moontrace

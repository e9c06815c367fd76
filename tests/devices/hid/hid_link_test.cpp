#include "devices/hid/hid_link.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <utility>

#include "devices/core/device_error.h"
#include "devices/hid/hid_port.h"
#include "tests/devices/fake_hid.h"

namespace moontrace {
namespace {

using Clock = std::chrono::steady_clock;

// The emulated stick numbers its reports: 1 position, 2 state; out 5 constant force, 10 operation.
constexpr std::uint8_t kPosition = 1, kConstant = 5, kOperation = 10;

std::array<std::uint8_t, 4> ConstantForce(int magnitude) {
  return {kConstant, 1, static_cast<std::uint8_t>(magnitude & 0xff),
          static_cast<std::uint8_t>(magnitude >> 8 & 0xff)};
}

HidReport ReportOf(std::initializer_list<std::uint8_t> bytes) {
  HidReport report;
  report.size = static_cast<std::uint16_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), report.bytes.begin());
  return report;
}

HidLinkOptions Options() {
  HidLinkOptions options;
  options.inputs = {kPosition, 2};
  return options;
}

std::string ThePath() {
  const auto list = ListHid();
  return list.empty() ? "" : list.front().path;
}

/// Waits for something that comes sooner or later; far longer than it can take.
bool ComesTrue(const std::function<bool()>& what) {
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (!what()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

TEST(HidLink, HandsOverTheNewestReportOfItsNumber) {
  FakeHid fake("pid");
  HidLink link(ThePath(), Options());
  HidReport report;
  ASSERT_TRUE(ComesTrue([&] { return link.Take(0, report); }));
  EXPECT_EQ(report.span().size(), 25u);
  EXPECT_EQ(report.bytes[0], kPosition);
  const auto first = report.count;
  ASSERT_TRUE(ComesTrue([&] { return link.Take(0, report) && report.count > first + 10; }));
  EXPECT_EQ(link.Strays(), 0u);
}

TEST(HidLink, SendsAnOutputOnceWhenItIsPutAgainUnchanged) {
  FakeHid fake("pid");
  {
    HidLink link(ThePath(), Options());
    for (int i = 0; i < 50; ++i) {
      link.Put(0, ConstantForce(100), true);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    link.Put(0, ConstantForce(200), true);
  }
  const auto sent = fake.Log("out", kConstant);
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[0].bytes[2], 100);
  EXPECT_EQ(sent[1].bytes[2], 200);
}

TEST(HidLink, RepeatsAnUnchangedOutputWhileTheTickLives) {
  FakeHid fake("pid");
  auto options = Options();
  options.repeat_every = 0.005;
  HidLink link(ThePath(), options);
  EXPECT_TRUE(ComesTrue([&] {
    link.Put(0, ConstantForce(100), true);
    return fake.Log("out", kConstant).size() > 5;
  }));
}

TEST(HidLink, RenewsAndRepeatsNothingWhenTheTickHangs) {
  FakeHid fake("pid");
  auto options = Options();
  options.repeat_every = 0.002;
  options.renewed = {ReportOf({kOperation, 1, 1, 1})};
  options.renew_every = 0.002;
  HidLink link(ThePath(), options);
  ASSERT_TRUE(ComesTrue([&] {
    link.Put(0, ConstantForce(100), true);
    return fake.Log("out", kOperation).size() > 5 && fake.Log("out", kConstant).size() > 5;
  }));
  // From here the tick puts nothing: sooner or later the number of reports stands still.
  std::size_t before = 0;
  EXPECT_TRUE(ComesTrue([&] {
    before = fake.Log("out").size();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return fake.Log("out").size() == before;
  }));
}

TEST(HidLink, SendsWhatIsPutAndItsFarewellLast) {
  FakeHid fake("pid");
  {
    auto options = Options();
    options.farewell = {ReportOf({kOperation, 1, 3, 0}), ReportOf({12, 2})};
    HidLink link(ThePath(), options);
    link.Put(0, ConstantForce(0), false);
  }
  const auto sent = fake.Log("out");
  ASSERT_EQ(sent.size(), 3u);
  EXPECT_EQ(sent[0].bytes, (std::vector<int>{kConstant, 1, 0, 0}));
  EXPECT_EQ(sent[1].bytes, (std::vector<int>{kOperation, 1, 3, 0}));
  EXPECT_EQ(sent[2].bytes, (std::vector<int>{12, 2}));
}

TEST(HidLink, SeesThatTheDeviceIsUnplugged) {
  FakeHid fake("pid", "unplug@50");
  HidLink link(ThePath(), Options());
  EXPECT_TRUE(link.IsAlive());
  EXPECT_TRUE(ComesTrue([&] { return !link.IsAlive(); }));
  EXPECT_TRUE(ListHid().empty());
}

TEST(HidLink, CanBeOpenedAgainAfterReplugging) {
  FakeHid fake("pid", "replug@50");
  const std::string path = ThePath();
  HidLink link(path, Options());
  ASSERT_TRUE(ComesTrue([&] { return !link.IsAlive(); }));
  ASSERT_TRUE(ComesTrue([] { return !ListHid().empty(); }));
  HidLink again(path, Options());
  HidReport report;
  EXPECT_TRUE(ComesTrue([&] { return again.Take(0, report); }));
  EXPECT_FALSE(link.IsAlive());
}

TEST(HidLink, LeavesADeafDeviceToItsThread) {
  FakeHid fake("pid", "deaf");  // a write takes 5 s
  const auto began = Clock::now();
  {
    HidLink link(ThePath(), Options());
    link.Put(0, ConstantForce(100), true);
    ASSERT_TRUE(ComesTrue([&] { return link.WaitingWrite() > 0.01; }));
  }
  // Not a measurement: a destructor that waited for the write would take 5 s.
  EXPECT_LT(Clock::now() - began, std::chrono::milliseconds(4900));
}

TEST(HidLink, OutlivesAFlood) {
  FakeHid fake("pid", "flood");
  HidLink link(ThePath(), Options());
  HidReport report;
  ASSERT_TRUE(ComesTrue([&] { return link.Take(0, report) && report.count > 1000; }));
  link.Put(0, ConstantForce(100), true);
  EXPECT_TRUE(ComesTrue([&] { return !fake.Log("out", kConstant).empty(); }));
}

TEST(HidLink, CountsReportsOfNumbersThatNobodyAskedFor) {
  FakeHid fake("pid", "garbage");
  HidLink link(ThePath(), Options());
  EXPECT_TRUE(ComesTrue([&] { return link.Strays() > 0; }));
}

TEST(HidPort, ListsADeviceOnceWithAllItsUsages) {
  FakeHid fake("pid,pid-array");
  const auto list = ListHid();
  ASSERT_EQ(list.size(), 2u);
  const auto bits = std::find_if(list.begin(), list.end(),
                                 [](const HidInfo& info) { return info.vendor == 0x1209; });
  ASSERT_NE(bits, list.end());
  EXPECT_EQ(bits->product, 0xffb0);
  EXPECT_EQ(bits->name, "Stick of bits");
  EXPECT_EQ(bits->usages.size(), 2u);
}

TEST(HidPort, TellsTheUdevLineWhereThePermissionIsRefused) {
  FakeHid fake("pid", "refused");
  try {
    HidHandle::Open(ThePath());
    FAIL() << "opened";
  } catch (const PermissionError& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find("no permission"), std::string::npos) << line;
    EXPECT_NE(error.rule().find("KERNELS==\"*:1209:FFB0.*\""), std::string::npos);
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(HidPort, OpensNothingButHidDevices) {
  FakeHid fake("pid");
  EXPECT_THROW(HidHandle::Open("/etc/hostname"), DeviceError);
  EXPECT_THROW(HidHandle::Open("/dev/hidraw-absent"), DeviceError);
  EXPECT_THROW(ReportDescriptorOf("/dev/hidraw-absent"), DeviceError);
}

}  // namespace
}  // namespace moontrace

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <thread>

#include "devices/hid/puck.h"
#include "devices/hid/raw_device.h"
#include "devices/hid/wooden_haptics_device.h"
#include "tests/devices/device_run.h"
#include "tests/devices/fake_hid.h"
#include "tests/source_path.h"

namespace {
// Of this thread only: the I/O threads and the fake hidapi may allocate.
thread_local long allocations = 0;
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace moontrace {
namespace {

/// Allocations in the tick of a device over half a second, through whatever states it goes.
long AllocationsOf(Device& device) {
  long counted = 0;
  for (int i = 0; i < 500; ++i) {
    DeviceState state;
    const long before = allocations;
    device.Read(state);
    device.Write({0.5, 0, 0});
    counted += allocations - before;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return counted;
}

DeviceProfile Profile(const std::string& name) {
  return LoadProfile(SourcePath("devices/profiles/" + name + ".toml"));
}

TEST(RawDevice, AllocatesNothingInTheTickEvenWhenItIsLost) {
  const FakeHid fake("moontrace-raw", "unplug@250");
  const auto device = MakeRawDevice(FindHid(0x16c0, 0x0486), Profile("moontrace-raw"), 0.001);
  EXPECT_EQ(AllocationsOf(*device), 0);
}

TEST(WoodenHaptics, AllocatesNothingInTheTick) {
  const FakeHid fake("woodenhaptics");
  const auto device = MakeWoodenHaptics(FindHid(0x1234, 0x0006), Profile("woodenhaptics"), 0.001);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(AllocationsOf(*device), 0);  // homed on the way
  DeviceState state;
  EXPECT_NE(device->Read(state), DeviceStatus::kNotReady);
}

TEST(Puck, AllocatesNothingInTheTick) {
  const FakeHid fake("spacemouse");
  const auto device = MakePuck(FindHid(0x256f, 0xc635), Profile("spacemouse"), 0.001);
  EXPECT_EQ(AllocationsOf(*device), 0);
}

}  // namespace
}  // namespace moontrace

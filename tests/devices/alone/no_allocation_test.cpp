#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "devices/hand/aimed_stylus.h"
#include "devices/hand/simulated_stylus.h"
#include "tests/source_path.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace moontrace {
namespace {

TEST(SimulatedStylus, AllocatesNothingInTheTick) {
  const HandModel hand = LoadHand(SourcePath("devices/hand.toml"));
  HandPath path;
  for (int i = 0; i < 200; ++i) {  // pressing and lifting in turn
    path.points.push_back({0.01 * i, {1e-4 * i, 0, 0}, i / 20 % 2 == 0 ? 1.0 : 0.0});
  }
  const auto device = MakeSimulatedStylus(hand, path, 0.001, 1);
  DeviceState state;
  const long before = allocations;
  for (int i = 0; i < 3000; ++i) {
    device->Read(state);
    device->Write({0, 0, 0.5});
  }
  EXPECT_EQ(allocations, before);
  EXPECT_GT(before, 0);  // the counter counts
}

TEST(AimedStylus, AllocatesNothingInTheTick) {
  const HandModel hand = LoadHand(SourcePath("devices/hand.toml"));
  const auto aims = std::make_shared<Mailbox<StylusAim>>();
  const auto device = MakeAimedStylus(hand, aims, {0, 0, -1}, 0.001);
  DeviceState state;
  const long before = allocations;
  for (int i = 0; i < 3000; ++i) {
    aims->Put({{1e-4 * i, 0, 0}, i / 200 % 2 == 0 ? 1.0 : 0.0});
    device->Read(state);
    device->Write({0, 0, 0.5});
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace moontrace

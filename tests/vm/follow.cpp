// follow PROFILES NAME: opens a haptic device and lets it follow a groove along x for 3 s: 200 N/m
// pull the tip to y = 0. Then it waits until the device is unplugged. Prints how far aside the tip
// was in the last 2 s. The emulated hands of tests/devices/fake hold with 200 N/m as well and swing
// 10 mm aside: half of that is left in the groove. A stick whose profile takes its motors for three
// times as strong as they are pulls with a third, and 10 mm * 3 / 4 are left. Exit 0: it was held,
// and the end was noticed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <glm/vec3.hpp>
#include <thread>

#include "devices/catalogue/catalogue.h"

namespace {

using namespace moontrace;
using Clock = std::chrono::steady_clock;

int Follow(Device& device) {
  constexpr double kStiffness = 200, kMost = 3;  // [N/m], [N]
  constexpr double kHeld = 8.5e-3;               // [m], between 7.5 mm held and 10 mm free
  const auto began = Clock::now();
  auto next = began;
  double aside = 0, along = 0;
  int readings = 0;
  bool has_told = false;
  DeviceState state;
  for (;;) {
    const double time = std::chrono::duration<double>(Clock::now() - began).count();
    const DeviceStatus status = device.Read(state);
    if (status == DeviceStatus::kLost) {
      std::printf("lost after %.1f s\n", time);
      const bool is_good = has_told && aside < kHeld && along > 0.02 && readings > 300;
      return is_good ? 0 : 1;
    }
    if (time > 60) {
      std::printf("never unplugged\n");
      return 1;
    }
    readings += status == DeviceStatus::kOk;
    const glm::dvec3 pull(0, std::clamp(-kStiffness * state.p_D.y, -kMost, kMost), 0);
    device.Write(status == DeviceStatus::kNotReady ? glm::dvec3(0, 0, 0) : pull);
    if (time > 1 && time < 3) {
      aside = std::max(aside, std::abs(state.p_D.y));
      along = std::max(along, std::abs(state.p_D.x));
    }
    if (time > 3 && !has_told) {
      has_told = true;
      std::printf("held within %.2f mm, %.1f mm along, %d readings\n", aside * 1e3, along * 1e3,
                  readings);
      std::fflush(stdout);
    }
    next += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(next);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    DeviceRequest request;
    request.name = argv[2];
    return Follow(*OpenDevice(request, argv[1]));
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}

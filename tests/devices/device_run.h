#pragma once

#include <chrono>
#include <glm/vec3.hpp>
#include <thread>
#include <vector>

#include "devices/core/device.h"
#include "devices/hid/hid_port.h"

namespace moontrace {

/// The listed HID device of these ids; fails softly with an empty path.
inline HidInfo FindHid(std::uint16_t vendor, std::uint16_t product) {
  for (const HidInfo& info : ListHid()) {
    if (info.vendor == vendor && info.product == product) return info;
  }
  return {};
}

/// What a device did in a row of ticks.
struct DeviceRun {
  std::vector<DeviceState> states;  ///< of the ticks that read kOk
  int no_data = 0, not_ready = 0, lost = 0;
  DeviceStatus last = DeviceStatus::kNoNewData;
};

/// Ticks a device about once a millisecond as a loop does: the force while all is well, zero as
/// soon as it is not. Ends when it is lost.
inline DeviceRun RunDevice(Device& device, int milliseconds, glm::dvec3 force) {
  using Clock = std::chrono::steady_clock;
  DeviceRun run;
  const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
  while (Clock::now() < end && run.last != DeviceStatus::kLost) {
    DeviceState state;
    run.last = device.Read(state);
    switch (run.last) {
      case DeviceStatus::kOk:
        run.states.push_back(state);
        break;
      case DeviceStatus::kNoNewData:
        ++run.no_data;
        break;
      case DeviceStatus::kNotReady:
        ++run.not_ready;
        break;
      case DeviceStatus::kLost:
        ++run.lost;
        break;
    }
    const bool is_well = run.last == DeviceStatus::kOk || run.last == DeviceStatus::kNoNewData;
    device.Write(is_well ? force : glm::dvec3(0, 0, 0));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return run;
}

}  // namespace moontrace

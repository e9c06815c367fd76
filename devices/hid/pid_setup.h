#pragma once

#include <array>
#include <string>

#include "devices/hid/hid_port.h"
#include "devices/hid/pid_codec.h"
#include "devices/hid/pid_layout.h"

namespace moontrace {

/// A PID device made ready: one constant force of zero plays on each motor axis.
struct PidSetup {
  std::array<int, 2> blocks{};  ///< of HID's X, Y; 0: no motor there
  PidState state;               ///< last reported; all in order if nothing was
  std::string
      autocentre;  ///< what became of its own centring spring, one sentence; empty: it has none
};

/// An effect ends by itself after this time unless it is started again [s].
inline constexpr double kPidDuration = 0.05;

/// Reset, enable, gain; a block, an effect and its start for each motor; the device's own centring
/// spring off. Blocks for as long as the device takes, up to seconds if it is deaf. Throws
/// DeviceError: it refuses, is full, is gone or does not answer.
PidSetup SetUpPid(HidHandle& handle, const PidLayout& layout);

}  // namespace moontrace

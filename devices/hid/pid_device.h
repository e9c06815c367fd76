#pragma once

#include <memory>
#include <string>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/hid/hid_port.h"

namespace moontrace {

/// A force-feedback joystick that speaks PID (USB Device Class Definition for Physical Interface
/// Devices 1.0): one constant force for each of its one or two motors, of finite duration, started
/// again every 15 ms while the tick lives.
///
/// Position: the profile's axes over its workspace. Its height is not measured; z says what
/// presses: 0 the setting, > 0 nothing (the profile's button is up, its axis at rest), < 0 a
/// pressing axis, by limits.stiffness times z, up to `press` [N]. Forces beyond `full_force`
/// saturate.
///
/// kNotReady while the device says that its motors are off, paused or without power, or its safety
/// switch has moved since it was opened; kLost once it is unplugged, takes no reports for
/// limits.silence, or sends reports that its descriptor does not know.
///
/// `tick` [s]. `autocentre`, if given, receives one sentence about the device's own centring
/// spring; empty where there is none to switch off. Blocks while opening. Throws DeviceError.
std::unique_ptr<Device> MakePidDevice(const HidInfo& info, const DeviceProfile& profile,
                                      double tick, double press, std::string* autocentre = nullptr);

}  // namespace moontrace

#pragma once

#include <string>
#include <vector>

#include "devices/core/profile.h"

namespace moontrace {

/// The udev line that lets whoever sits at the computer open the HID device of these ids, on any
/// transport (USB, Bluetooth, virtual): the HID parent is called BUS:VVVV:PPPP.NNNN.
std::string UdevRule(const DeviceProfile::Id& id);

/// The file for such a line, and the command that puts it into effect; both need root.
inline constexpr const char* kUdevFile = "/etc/udev/rules.d/70-moontrace-hid.rules";
inline constexpr const char* kUdevReload = "udevadm control --reload-rules";

/// The file `devices/udev/70-moontrace-hid.rules` that these profiles make. It holds only ids that
/// belong to haptic devices, in ascending order: a generic board's id (Id::own is false) would open
/// other people's devices too, and a puck pushes nothing.
std::string UdevFile(const std::vector<DeviceProfile>& profiles);

}  // namespace moontrace

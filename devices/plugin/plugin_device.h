#pragma once

#include <memory>
#include <string>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/moontrace_device.h"

namespace moontrace {

/// Opens the device of a plug-in (moontrace_device.h), which runs in a helper process. It is lost
/// when the plug-in says so, ends, crashes, hangs for 0.1 s, or gives a position that is not
/// finite. `tick` [s] is the loop's period. Throws DeviceError: the file or a folder above it can
/// be written by others (trusted_file.h), it cannot be loaded, is made for another version,
/// describes an impossible device, or cannot open it.
std::unique_ptr<Device> MakePluginDevice(const std::string& path, double tick);

/// A plug-in's description of its device, as a profile. Throws DeviceError, with the field's name,
/// for impossible values.
DeviceProfile ProfileOf(const moontrace_description& description, const std::string& path);

/// The description of a plug-in; opens and closes its device. Throws as MakePluginDevice.
DeviceProfile DescribePlugin(const std::string& path);

}  // namespace moontrace

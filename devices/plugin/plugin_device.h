#pragma once

#include <memory>
#include <string>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/moontrace_device.h"

namespace moontrace {

/// Opens the device of a plug-in (moontrace_device.h), which runs in a helper process. It is lost
/// when the plug-in says so, ends, crashes, hangs for 0.1 s, or gives a position that is no number.
/// `tick` [s] is the loop's period. Throws DeviceError: the file or a folder above it can be
/// written by others (trusted_file.h), it cannot be loaded, is made for another version, describes
/// a device that cannot be, or cannot open it.
std::unique_ptr<Device> MakePluginDevice(const std::string& path, double tick);

/// What a plug-in tells of its device, as a profile. Throws DeviceError for what cannot be, with
/// the field's name.
DeviceProfile ProfileOf(const moontrace_description& description, const std::string& path);

/// The description of a plug-in; opens and closes its device. Throws as MakePluginDevice.
DeviceProfile DescribePlugin(const std::string& path);

}  // namespace moontrace

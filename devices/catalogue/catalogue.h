#pragma once

#include <memory>
#include <string>
#include <vector>

#include "devices/core/device.h"
#include "devices/core/profile.h"

namespace moontrace {

/// A device that is plugged in, or a kind that always is.
struct DeviceEntry {
  std::string name;  ///< what `--device` takes, unique in the list
  DeviceProfile profile;
  std::string path;     ///< of the HID node or plug-in
  std::string problem;  ///< why it cannot be opened and what mends it, one line; empty if it can
  std::string rule;     ///< of `problem`: the udev line that mends it, if one does
  /// Why no guardian (devices/guardian) watches over it while it is used, a clause; empty: one
  /// does.
  std::string unguarded;
  bool asked = false;  ///< its figures come from the device, not from its profile
};

/// Every profile of a folder, by name. Throws DeviceError: no such folder, a broken profile.
std::vector<DeviceProfile> LoadProfiles(const std::string& folder);

/// One profile: of that name in the folder `profiles`, or of a file, where `name` ends in ".toml".
/// Throws InputError: none of that name (the line lists them), a broken profile.
DeviceProfile FindProfile(const std::string& name, const std::string& profiles);

/// What is there: HID devices that a profile or their descriptor recognises. `profiles` is the
/// folder that holds the profiles (devices/profiles of the program's data). Throws DeviceError
/// where a profile is broken, never for a device's sake.
std::vector<DeviceEntry> ListDevices(const std::string& profiles);

/// What is known of a plug-in's device. Opens and closes it. Throws DeviceError.
DeviceEntry EntryOfPlugin(const std::string& name);

/// PATH of `plugin:PATH`; empty if `name` is of another kind.
std::string PluginPathOf(const std::string& name);

/// Which device to open, and how it will be used.
struct DeviceRequest {
  std::string name;     ///< of an entry, or `plugin:PATH`
  double tick = 0.001;  ///< [s]
  double press = 1;     ///< for devices without a third axis [N]
  /// If not null, receives a remark about the opening, one sentence; without one it stays as it is.
  std::string* remark = nullptr;
};

/// Opens a device; `profiles` as above. Throws DeviceError; for an unknown name the line gives the
/// nearest of those that are there, else of those that have a profile, else all that are there.
std::unique_ptr<Device> OpenDevice(const DeviceRequest& request, const std::string& profiles);

/// Throws DeviceError as OpenDevice does for a name that is not there; opens nothing, and asks no
/// plug-in.
void RequireThere(const std::string& name, const std::string& profiles);

/// The folder of device profiles that comes with the program.
std::string ProfilesFolder();

}  // namespace moontrace

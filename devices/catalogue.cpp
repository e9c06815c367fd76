#include "devices/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>

#include "devices/device_error.h"
#include "devices/hid_port.h"
#include "devices/plugin_device.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

bool HasId(const DeviceProfile& profile, const HidInfo& info) {
  return std::any_of(profile.ids.begin(), profile.ids.end(), [&info](const auto& id) {
    return id.vendor == info.vendor && id.product == info.product;
  });
}

/// The profile that a device answers to, if any.
const DeviceProfile* Recognise(const HidInfo& info, const std::vector<DeviceProfile>& profiles) {
  for (const DeviceProfile& profile : profiles) {
    if (HasId(profile, info)) return &profile;
  }
  return nullptr;
}

/// Why a device cannot be opened; empty if it can.
std::string ProblemOf(const std::string& path) {
  try {
    HidHandle::Open(path);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

std::string UnknownName(const std::string& name, const std::vector<DeviceEntry>& entries) {
  if (entries.empty()) {
    return fmt::format("{}: no such device, none is plugged in; \"moontrace devices\" says more",
                       name);
  }
  std::string names;
  for (const DeviceEntry& entry : entries) {
    names += (names.empty() ? "" : ", ") + entry.name;
  }
  return fmt::format("{}: no such device; there are {}; \"moontrace devices\" lists them", name,
                     names);
}

}  // namespace

std::vector<DeviceProfile> LoadProfiles(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".toml") paths.push_back(it->path().string());
  }
  if (error) {
    throw DeviceError(folder + ": cannot be read: install the program again");
  }
  std::sort(paths.begin(), paths.end());
  std::vector<DeviceProfile> profiles;
  for (const std::string& path : paths) profiles.push_back(LoadProfile(path));
  return profiles;
}

std::vector<DeviceEntry> ListDevices(const std::string& profiles) {
  const std::vector<DeviceProfile> known = LoadProfiles(profiles);
  std::vector<HidInfo> there = ListHid();
  std::sort(there.begin(), there.end(),
            [](const HidInfo& a, const HidInfo& b) { return a.path < b.path; });
  std::map<std::string, int> count;
  std::vector<DeviceEntry> entries;
  for (const HidInfo& info : there) {
    const DeviceProfile* profile = Recognise(info, known);
    if (profile == nullptr) continue;
    DeviceEntry entry{profile->name, *profile, info.path, ProblemOf(info.path)};
    const int number = ++count[profile->name];
    if (number > 1) entry.name += fmt::format("-{}", number);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::unique_ptr<Device> OpenDevice(const DeviceRequest& request, const std::string& profiles) {
  constexpr std::string_view kPlugin = "plugin:";
  if (request.name.compare(0, kPlugin.size(), kPlugin) == 0) {
    return MakePluginDevice(request.name.substr(kPlugin.size()), request.tick);
  }
  const std::vector<DeviceEntry> entries = ListDevices(profiles);
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&request](const auto& e) { return e.name == request.name; });
  if (entry == entries.end()) throw DeviceError(UnknownName(request.name, entries));
  if (!entry->problem.empty()) throw DeviceError(entry->name + ": " + entry->problem);
  throw DeviceError(entry->name + ": this kind of device cannot be driven yet");
}

}  // namespace moontrace

#include "devices/catalogue/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <string_view>
#include <system_error>

#include "devices/core/device_error.h"
#include "devices/guardian/guardian.h"
#include "devices/hid/hid_descriptor.h"
#include "devices/hid/hid_port.h"
#include "devices/hid/pid_device.h"
#include "devices/hid/pid_layout.h"
#include "devices/hid/puck.h"
#include "devices/hid/raw_device.h"
#include "devices/hid/wooden_haptics_device.h"
#include "devices/plugin/plugin_device.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

/// An entry with what the system says of it.
struct Found {
  DeviceEntry entry;
  HidInfo info;
};

bool HasId(const DeviceProfile& profile, const HidInfo& info) {
  return std::any_of(profile.ids.begin(), profile.ids.end(), [&info](const auto& id) {
    return id.vendor == info.vendor && id.product == info.product;
  });
}

HidDescriptor DescriptorOf(const HidInfo& info) {
  return ParseHidDescriptor(ReportDescriptorOf(info.path));
}

bool OffersPid(const HidInfo& info) {
  try {
    return SpeaksPid(DescriptorOf(info));
  } catch (const DeviceError&) {
    return false;
  }
}

/// A wireless puck lists its receiver's other halves with the same ids.
bool IsMultiAxisController(const HidInfo& info) {
  return std::any_of(info.usages.begin(), info.usages.end(), [](const HidInfo::Usage& usage) {
    return usage.page == 1 && usage.id == 8;  // generic desktop, multi-axis controller
  });
}

bool Answers(const DeviceProfile& profile, const HidInfo& info) {
  if (!HasId(profile, info)) return false;
  switch (profile.kind) {
    case DeviceKind::kWoodenHaptics:
      return FitsArm(info, profile);
    case DeviceKind::kPuck:
      return IsMultiAxisController(info);
    case DeviceKind::kPid:
    case DeviceKind::kRawHid:
    case DeviceKind::kPlugin:
      break;
  }
  return true;
}

/// The profile that a device answers to, if any. What it says of itself goes before its ids, which
/// may be borrowed.
const DeviceProfile* Recognise(const HidInfo& info, const std::vector<DeviceProfile>& profiles) {
  const auto first_without_ids = [&profiles](DeviceKind kind) -> const DeviceProfile* {
    for (const DeviceProfile& profile : profiles) {
      if (profile.kind == kind && profile.ids.empty()) return &profile;
    }
    return nullptr;
  };
  if (OffersRawProtocol(info)) return first_without_ids(DeviceKind::kRawHid);
  for (const DeviceProfile& profile : profiles) {
    if (Answers(profile, info)) return &profile;
  }
  return OffersPid(info) ? first_without_ids(DeviceKind::kPid) : nullptr;
}

/// Opens a device for a moment: its problem if it cannot be used, its own figures if it has some.
void Probe(Found& found) {
  DeviceProfile& profile = found.entry.profile;
  try {
    switch (profile.kind) {
      case DeviceKind::kRawHid:
        profile = WithHello(profile, ReadRawHello(found.info.path));
        found.entry.asked = true;
        break;
      case DeviceKind::kPid: {
        HidHandle::Open(found.info.path);
        const HidDescriptor descriptor = DescriptorOf(found.info);
        FindPidLayout(descriptor);
        FindStick(descriptor, profile.stick);
        break;
      }
      case DeviceKind::kWoodenHaptics:
      case DeviceKind::kPuck:
      case DeviceKind::kPlugin:
        HidHandle::Open(found.info.path);
        break;
    }
  } catch (const PermissionError& error) {
    found.entry.problem = "no permission";
    found.entry.rule = error.rule();
  } catch (const DeviceError& error) {
    found.entry.problem = error.what();
  }
}

/// Of a device whose figures and problem are known.
std::string WhyUnguarded(const DeviceEntry& entry) {
  if (!glm::any(entry.profile.limits.pushes)) return "it has no force";
  if (!entry.problem.empty()) return "it cannot be opened";
  // the helper process of a plug-in is its guardian as well
  return entry.profile.kind == DeviceKind::kPlugin ? "" : Guardian::WhyNone();
}

std::vector<Found> FindAll(const std::string& folder) {
  const std::vector<DeviceProfile> profiles = LoadProfiles(folder);
  std::vector<HidInfo> there = ListHid();
  std::sort(there.begin(), there.end(),
            [](const HidInfo& a, const HidInfo& b) { return a.path < b.path; });
  std::map<std::string, int> count;
  std::vector<Found> all;
  for (const HidInfo& info : there) {
    const DeviceProfile* profile = Recognise(info, profiles);
    if (profile == nullptr) continue;
    Found found;
    found.entry.name = profile->name;
    found.entry.profile = *profile;
    found.entry.path = info.path;
    found.info = info;
    const int number = ++count[profile->name];
    if (number > 1) found.entry.name += fmt::format("-{}", number);
    all.push_back(std::move(found));
  }
  return all;
}

std::vector<std::string> NamesOf(const std::vector<DeviceProfile>& profiles) {
  std::vector<std::string> names;
  names.reserve(profiles.size());
  for (const DeviceProfile& profile : profiles) names.push_back(profile.name);
  return names;
}

/// A word for the name that is not there: the nearest of those that are, else of those that are
/// known, else all that are there: names, which may be many, stand at the end.
std::string InPlaceOf(const std::string& name, const std::vector<std::string>& there,
                      const std::vector<std::string>& known) {
  std::vector<std::string> usable = there;
  usable.insert(usable.end(), {"simulated", "mouse"});  // the commands' own, never plugged in
  usable.erase(std::remove(usable.begin(), usable.end(), name), usable.end());
  const std::string nearest = NearestName(name, usable);
  if (!nearest.empty()) return "did you mean " + nearest + "?";
  const std::string kind = NearestName(name, known);
  if (!kind.empty()) return "did you mean " + kind + "? That is not plugged in";
  if (there.empty()) return "none is plugged in";
  return fmt::format("there are {}", fmt::join(there, ", "));
}

[[noreturn]] void RefuseName(const std::string& name, const std::vector<Found>& all,
                             const std::string& folder) {
  std::vector<std::string> there;
  there.reserve(all.size());
  for (const Found& found : all) there.push_back(found.entry.name);
  const std::vector<std::string> known = NamesOf(LoadProfiles(folder));
  if (std::find(known.begin(), known.end(), name) != known.end()) {
    throw DeviceError(fmt::format(
        "{}: none is plugged in; plug it in, and see whether it is found: moontrace devices",
        name));
  }
  throw DeviceError(fmt::format("no device is called \"{}\": {}", name.substr(0, 60),
                                InPlaceOf(name, there, known)));
}

Found FindNamed(const std::string& name, const std::string& profiles) {
  const std::vector<Found> all = FindAll(profiles);
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&name](const Found& one) { return one.entry.name == name; });
  if (found == all.end()) RefuseName(name, all, profiles);
  return *found;
}

std::unique_ptr<Device> Open(const Found& found, const DeviceRequest& request) {
  const DeviceProfile& profile = found.entry.profile;
  switch (profile.kind) {
    case DeviceKind::kPid:
      return MakePidDevice(found.info, profile, request.tick, request.press, request.remark);
    case DeviceKind::kRawHid:
      return MakeRawDevice(found.info, profile, request.tick);
    case DeviceKind::kWoodenHaptics:
      return MakeWoodenHaptics(found.info, profile, request.tick);
    case DeviceKind::kPuck:
      return MakePuck(found.info, profile, request.tick);
    case DeviceKind::kPlugin:
      break;  // no profile is of this kind: plug-ins describe themselves
  }
  throw DeviceError(found.entry.name + ": cannot be driven: correct the kind in its profile");
}

constexpr std::string_view kPlugin = "plugin:";

}  // namespace

std::vector<DeviceProfile> LoadProfiles(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".toml") paths.push_back(it->path().string());
  }
  if (error) throw DeviceError(folder + ": cannot be read: install the program again");
  std::sort(paths.begin(), paths.end());
  std::vector<DeviceProfile> profiles;
  profiles.reserve(paths.size());
  for (const std::string& path : paths) profiles.push_back(LoadProfile(path));
  return profiles;
}

DeviceProfile FindProfile(const std::string& name, const std::string& profiles) {
  const bool is_file = fs::path(name).extension() == ".toml";
  try {
    if (is_file) return LoadProfile(name);
    std::vector<DeviceProfile> all = LoadProfiles(profiles);
    for (DeviceProfile& profile : all) {
      if (profile.name == name) return std::move(profile);
    }
    const std::vector<std::string> names = NamesOf(all);
    const std::string nearest = NearestName(name, names);
    throw InputError(fmt::format(
        "device profile '{}': there is none; {}", OneLine(name),
        nearest.empty() ? fmt::format("name a .toml file, or one of {}", fmt::join(names, ", "))
                        : "did you mean " + nearest + "?"));
  } catch (const DeviceError& error) {
    throw InputError(error.what());
  }
}

std::vector<DeviceEntry> ListDevices(const std::string& profiles) {
  std::vector<DeviceEntry> entries;
  for (Found& found : FindAll(profiles)) {
    Probe(found);
    found.entry.unguarded = WhyUnguarded(found.entry);
    entries.push_back(std::move(found.entry));
  }
  return entries;
}

DeviceEntry EntryOfPlugin(const std::string& name) {
  DeviceEntry entry;
  entry.name = name;
  entry.profile = DescribePlugin(PluginPathOf(name));
  entry.asked = true;
  entry.unguarded = WhyUnguarded(entry);
  return entry;
}

std::string PluginPathOf(const std::string& name) {
  return name.compare(0, kPlugin.size(), kPlugin) == 0 ? name.substr(kPlugin.size()) : "";
}

std::unique_ptr<Device> OpenDevice(const DeviceRequest& request, const std::string& profiles) {
  if (request.name.compare(0, kPlugin.size(), kPlugin) == 0) {
    return MakePluginDevice(PluginPathOf(request.name), request.tick);
  }
  return Open(FindNamed(request.name, profiles), request);
}

void RequireThere(const std::string& name, const std::string& profiles) {
  if (PluginPathOf(name).empty()) FindNamed(name, profiles);
}

std::string ProfilesFolder() { return ResourcePath("devices/profiles"); }

}  // namespace moontrace

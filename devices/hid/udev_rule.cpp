#include "devices/hid/udev_rule.h"

#include <fmt/core.h>

#include <cstdint>
#include <map>
#include <utility>

namespace moontrace {
namespace {

// The number must be below 73, where uaccess is evaluated.
constexpr const char* kHead =
    "# Haptic devices that Moontrace knows: whoever sits at the computer may open them.\n"
    "# Made from the ids in devices/profiles; boards with borrowed ids and pucks are left out.\n"
    "# Where nobody sits (ssh, container) put GROUP=\"plugdev\",MODE=\"0660\" in place of TAG.\n";

}  // namespace

std::string UdevRule(const DeviceProfile::Id& id) {
  // Without spaces, so that no line is broken within it.
  return fmt::format(
      "KERNEL==\"hidraw*\",SUBSYSTEM==\"hidraw\",KERNELS==\"*:{:04X}:{:04X}.*\","
      "TAG+=\"uaccess\"",
      id.vendor, id.product);
}

std::string UdevFile(const std::vector<DeviceProfile>& profiles) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::string> titles;
  for (const DeviceProfile& profile : profiles) {
    if (profile.kind == DeviceKind::kPuck) continue;
    for (const DeviceProfile::Id& id : profile.ids) {
      if (id.own) titles.emplace(std::pair(id.vendor, id.product), profile.title);
    }
  }
  std::string file = kHead;
  for (const auto& [id, title] : titles) {
    file += fmt::format("\n# {}\n{}\n", title, UdevRule({id.first, id.second, true}));
  }
  return file;
}

}  // namespace moontrace
